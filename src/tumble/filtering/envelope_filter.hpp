/// \file
/// \brief Envelope filters: what stays near where it is shown is shown at rest (thesis 5.5).
#pragma once

#include "tumble/filtering/following_filter.hpp"

namespace tumble {

/// How far a body may be from where it is shown.
struct Envelope {
  double radius = 0.01;                 ///< [m] of its centre of mass, above 0
  double angle = 0.017453292519943295;  ///< [rad] between the orientations, above 0; 1 degree
};

/// The second filter of the thesis.
///
/// Each body has a shown pose, at first the computed one. It stays as it is while the computed pose
/// is within the envelope around it, and becomes the computed pose in the first frame that is not:
/// \f[ (y_n, p_n) = (x_n, q_n) \ \text{if}\ |x_n - y_{n-1}| > \rho \ \text{or}
///     \angle(q_n, p_{n-1}) > \alpha,\quad (y_{n-1}, p_{n-1}) \ \text{otherwise.} \f]
/// Position and orientation fire together, or a pose would be drawn in which the body never was. A
/// body that is always within the envelope around its first pose is shown at rest; one that leaves
/// it in every frame is shown as it is; one that creeps *pops*, by more than the envelope and at
/// most by what it moves in a frame more.
/// \par Spacing
/// Any: the rule knows no time.
/// \par Cost
/// 50 ns for a body and frame.
class EnvelopeFilter : public FollowingFilter {
 public:
  /// Makes the filter.
  /// \param envelope how far a body may be from where it is shown
  /// \throws std::invalid_argument for a radius or an angle that is not finite and above 0
  explicit EnvelopeFilter(const Envelope& envelope = {});

  [[nodiscard]] std::string text() const override;
  [[nodiscard]] std::unique_ptr<PoseFilter> clone() const override;

 private:
  void follow(const BodyState& now, double dt, FollowedBody& body) const override;

  Envelope envelope_;
};

/// An envelope without pops, ours.
///
/// The shown pose is drawn along only as far as it has to be, and the envelope shrinks with speed.
/// With \f$\|(d, \theta)\| = \max(|d|/\rho,\ \theta/\alpha)\f$ as the size of a move d with a turn by
/// θ, in envelopes, and the size \f$s_n\f$ of the computed move from frame n - 1 to n,
/// \f[ \sigma_n = \max(0,\, 1 - s_n), \qquad
///     (y_n, p_n) = \text{the pose nearest to } (y_{n-1}, p_{n-1}) \text{ on the way from it to }
///     (x_n, q_n) \text{ that is within } \sigma_n \text{ envelopes of } (x_n, q_n). \f]
/// The way is a straight line for the centre and a turn about one axis, by the same share. So
/// - what moves by an envelope or more in a frame is shown as it is;
/// - what stays within half an envelope, from end to end, is shown at rest at once; what shakes to
///   and fro in every frame along a line (or about an axis), by up to two thirds after two frames;
/// - what creeps is shown creeping: what is shown moves by at most twice what is computed in that
///   frame. So a displayed step as long as the envelope takes a body that moves by half of one; it
///   makes up in one frame for the offset that it had at rest.
/// \par Spacing
/// Any, but what counts as fast is a move within a frame.
/// \par Cost
/// 0.2 microseconds for a body and frame.
class SoftEnvelopeFilter : public FollowingFilter {
 public:
  /// Makes the filter.
  /// \param envelope how far a body may be from where it is shown
  /// \throws std::invalid_argument for a radius or an angle that is not finite and above 0
  explicit SoftEnvelopeFilter(const Envelope& envelope = {});

  [[nodiscard]] std::string text() const override;
  [[nodiscard]] std::unique_ptr<PoseFilter> clone() const override;

 private:
  void follow(const BodyState& now, double dt, FollowedBody& body) const override;

  Envelope envelope_;
};

}  // namespace tumble
