/// \file
/// \brief The one-euro filter: a low-pass filter whose cutoff rises with speed.
#pragma once

#include "tumble/base/cloned.hpp"
#include "tumble/filtering/pose_filter.hpp"

namespace tumble {

/// Parameters of the one-euro filter.
///
/// The defaults were chosen on scenes of cubes with edges of a metre. *Gain* first: a fast body lags by
/// 1/(2π gain) at any speed; 16 makes that a centimetre, the radius of the default envelope. Then the
/// *cutoff*: with 1 Hz the settled clump of figure 6.7 is as still as under a box filter over 15
/// frames (a seventh of the amplitude, two sevenths of the squirm); 0.5 Hz would halve both again,
/// but a body that starts to move would lag a tenth more. Speed is smoothed at 1 Hz, as in the paper;
/// at 3 Hz chatter itself begins to raise the cutoff. For other edges use a gain of 16 over their
/// length in metres.
struct OneEuroOptions {
  double cutoff = 1.0;  ///< [Hz] for a body at rest, above 0
  double gain = 16.0;   ///< [Hz/(m/s)], [Hz/(rad/s)] increase of the cutoff with speed, from 0
  double speed_cutoff = 1.0;  ///< [Hz] of the filter that smooths the speed, above 0
};

/// The one-euro filter of Casiez, Roussel and Vogel.
///
/// Exponential smoothing of positions with a cutoff that depends on the smoothed speed,
/// \f[ y_n = y_{n-1} + a(f_n)\,(x_n - y_{n-1}), \quad f_n = f_{min} + \beta |\hat v_n|, \quad
///     \hat v_n = \hat v_{n-1} + a(f_d)\,(v_n - \hat v_{n-1}), \quad
///     a(f) = \frac{1}{1 + 1/(2\pi f \Delta t)}, \f]
/// with the computed velocity \f$v_n = (x_n - x_{n-1})/\Delta t\f$: one filter for the three coordinates,
/// so that the result does not depend on axes. Orientations turn by the same share of the rotation from
/// the displayed to the computed one, with the angular speed in f. Speed starts at 0.
///
/// At rest it is a stronger filter than a mean over five frames, at high speed it lags less; unlike
/// an envelope it neither stands still nor pops.
/// \par Spacing
/// Any: the time between two frames enters.
/// \par Cost
/// 0.4 microseconds for a body and frame.
/// \see Casiez, Roussel, Vogel, "1€ filter: a simple speed-based low-pass filter for noisy input in
///      interactive systems", CHI 2012.
class OneEuroFilter : public Cloned<FollowingFilter, OneEuroFilter> {
 public:
  /// Makes the filter.
  /// \throws std::invalid_argument for a parameter out of range
  explicit OneEuroFilter(const OneEuroOptions& options = {});

  [[nodiscard]] std::string text() const override;

 private:
  void follow(const BodyState& now, double dt, FollowedBody& body) const override;

  OneEuroOptions options_;
};

}  // namespace tumble
