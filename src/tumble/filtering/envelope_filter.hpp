/// \file
/// \brief Envelope filters: a body that stays near its displayed pose is displayed at rest (thesis 5.5).
#pragma once

#include "tumble/base/cloned.hpp"
#include "tumble/filtering/pose_filter.hpp"

namespace tumble {

/// Largest difference between the computed and the displayed pose.
struct Envelope {
  double radius = 0.01;                 ///< [m] of its centre of mass, above 0
  double angle = 0.017453292519943295;  ///< [rad] between the orientations, above 0; 1 degree
};

/// The thesis's second filter.
///
/// Each body has a displayed pose, at first the computed one. It stays while the computed pose is within
/// the envelope around it, and jumps to the computed pose in the first frame in which this is outside:
/// \f[ (y_n, p_n) = (x_n, q_n) \ \text{if}\ |x_n - y_{n-1}| > \rho \ \text{or}
///     \angle(q_n, p_{n-1}) > \alpha,\quad (y_{n-1}, p_{n-1}) \ \text{otherwise.} \f]
/// Position and orientation jump together, so that only computed poses are displayed. A body that stays
/// within the envelope around its first pose is displayed at rest; one that leaves it in every frame
/// is displayed as computed; one that creeps *pops*, by more than the envelope, and at most by its
/// motion in a frame more.
/// \par Spacing
/// Any: time does not enter.
/// \par Cost
/// 50 ns for a body and frame.
class EnvelopeFilter : public Cloned<FollowingFilter, EnvelopeFilter> {
 public:
  /// Makes the filter.
  /// \throws std::invalid_argument for a radius or an angle that is not finite and above 0
  explicit EnvelopeFilter(const Envelope& envelope = {});

  [[nodiscard]] std::string text() const override;

 private:
  void follow(const BodyState& now, double dt, FollowedBody& body) const override;

  Envelope envelope_;
};

/// An envelope without pops, ours.
///
/// The displayed pose is pulled along only as far as necessary, and the envelope shrinks with speed.
/// With \f$\|(d, \theta)\| = \max(|d|/\rho,\ \theta/\alpha)\f$ as the size in envelopes of a displacement
/// d with a rotation by θ, and the size \f$s_n\f$ of the computed motion from frame n - 1 to n,
/// \f[ \sigma_n = \max(0,\, 1 - s_n), \qquad
///     (y_n, p_n) = \text{the pose nearest to } (y_{n-1}, p_{n-1}) \text{ on the path from it to }
///     (x_n, q_n) \text{ that is within } \sigma_n \text{ envelopes of } (x_n, q_n). \f]
/// The path is a straight line for the centre and a rotation about one axis, in equal shares. So
/// - motion by an envelope or more in a frame is displayed as computed;
/// - motion within half an envelope, from end to end, is displayed at rest at once; an oscillation
///   frame by frame along a line (or about an axis), by up to two thirds after two frames;
/// - creep is displayed as creep: a displayed step is at most twice the computed step of that frame. So a
///   displayed step of one envelope needs a computed one of half an envelope; it removes in one frame
///   the offset accumulated at rest.
/// \par Spacing
/// Any, but speed is measured per frame.
/// \par Cost
/// 0.2 microseconds for a body and frame.
class SoftEnvelopeFilter : public Cloned<FollowingFilter, SoftEnvelopeFilter> {
 public:
  /// Makes the filter.
  /// \throws std::invalid_argument for a radius or an angle that is not finite and above 0
  explicit SoftEnvelopeFilter(const Envelope& envelope = {});

  [[nodiscard]] std::string text() const override;

 private:
  void follow(const BodyState& now, double dt, FollowedBody& body) const override;

  Envelope envelope_;
};

}  // namespace tumble
