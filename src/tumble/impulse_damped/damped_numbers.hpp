/// \file
/// \brief The constants of damped integration, for bodies of any size and mass (thesis 5.3, A.2).
#pragma once

#include "tumble/dynamics/body.hpp"
#include "tumble/impulse_damped/tolerances.hpp"

namespace tumble {

/// The thresholds of damped integration for one body and one time step.
struct DampedThresholds {
  double push = 0.0;        ///< [m] ε1: a push out of another body
  double aligned = 0.0;     ///< [rad] ε2: a face across gravity
  double settled = 0.0;     ///< [kg m/s] ε3: vertical momentum of an aligned body
  double tilt = 0.0;        ///< [rad] ε4: by how much it is turned upright in a step
  double slow = 0.0;        ///< [kg m/s] ε5: a component of momentum that is scaled
  double still = 0.0;       ///< [kg m/s] ε6: one that is set to 0
  double slow_spin = 0.0;   ///< [kg m²/s] ε7: a component of angular momentum that is scaled
  double still_spin = 0.0;  ///< [kg m²/s] ε8: one that is set to 0
  double rising = 0.0;      ///< [kg m/s] ε9: upward momentum that is set to 0
  double frozen = 0.0;      ///< [m] ε10: a move in a step that is undone
  double frozen_in_flight = 0.0;  ///< [m] the same of a body that nothing touches
  double frozen_angle = 0.0;      ///< [rad] ε11: a turn in a step that is undone with it
};

/// The factors of damped integration for one time step.
struct DampedFactors {
  double momentum = 1.0;      ///< [-] k1: of the momentum of a body in contact
  double spin = 1.0;          ///< [-] k2: of its angular momentum
  double settled_spin = 1.0;  ///< [-] k3: of the angular momentum of an aligned, settled body
  double slow = 1.0;          ///< [-] k5: of slow components of momentum
  double slow_spin = 1.0;     ///< [-] k7: of slow components of angular momentum
};

/// The constants ε1 to ε11 and k1 to k7 of the listing DAMPENOBJECTS.
///
/// The thesis names them and gives no numbers. There are no k4 and k6: they would belong to ε4 and
/// ε6, which are thresholds without a factor. ε2 and ε6 are not in the listing by name: they are
/// the tolerance that its alignment test needs, and the smaller one of two thresholds that it
/// prints alike.
///
/// All numbers hold for any box: lengths are in units of its shortest edge L, speeds of
/// \f$\sqrt{gL}\f$, momenta of \f$m\sqrt{gL}\f$, angular momenta of \f$mL\sqrt{gL}\f$. Something that is a
/// share for each step belongs to steps of 1/60 s, as the thesis's: factors are raised to
/// \f$60\,\Delta t\f$. ε4, ε10 and ε11 limit what moves in a step, and ε3, ε6, ε8 and ε9 stop what
/// gravity's share of a step leaves; these are multiplied by it.
///
/// Two bounds follow from gravity, which gives a body \f$m g\,\Delta t\f$ and moves it by
/// \f$g\,\Delta t^2\f$ in its first step: ε3 and ε6 have to be below the one, or a box that touches
/// a wall would hang there, and ε10 below the other, or a released one would not fall. At 1/60 s and 1
/// m these are 0.0522 and 0.00272. Both bounds shrink as boxes grow: above 5 m the thresholds stay below them (`damped_stop`,
/// `damped_halt`). The second one shrinks with the step, too: in steps below 1/300 s, at 1 m, ε10 stays below it for what nothing
/// touches. What touches something may hang for a step.
struct DampedNumbers {
  double eps1 = tolerance::damped_push;               ///< [-] see DampedThresholds
  double eps2 = tolerance::damped_aligned;            ///< [rad] ditto
  double eps3 = tolerance::damped_settled;            ///< [-] ditto
  double eps4 = tolerance::damped_tilt;               ///< [rad] ditto
  double eps5 = tolerance::damped_slow;               ///< [-] ditto
  double eps6 = tolerance::damped_still;              ///< [-] ditto
  double eps7 = tolerance::damped_slow_spin;          ///< [-] ditto
  double eps8 = tolerance::damped_still_spin;         ///< [-] ditto
  double eps9 = tolerance::damped_rising;             ///< [-] ditto
  double eps10 = tolerance::damped_frozen;            ///< [-] ditto
  double eps11 = tolerance::damped_frozen_angle;      ///< [rad] ditto
  double k1 = tolerance::damped_momentum_factor;      ///< [-] see DampedFactors, in 1/60 s
  double k2 = tolerance::damped_spin_factor;          ///< [-] ditto
  double k3 = tolerance::damped_settled_spin_factor;  ///< [-] ditto
  double k5 = tolerance::damped_slow_factor;          ///< [-] ditto
  double k7 = tolerance::damped_slow_spin_factor;     ///< [-] ditto
  double eps_scale = 1.0;  ///< [-] all ε are multiplied by it: does a result depend on them?
  double k_scale = 1.0;    ///< [-] all k are raised to it: 2 damps twice as fast
};

/// Steps a second to which the numbers belong.
inline constexpr double kDampedStepsPerSecond = 60.0;

/// [-] What `reading=as_reported` multiplies k_scale by. The thesis gives no values, but an outcome for figures 6.6
/// and 6.7: plausible, with small chatter (6.1). Of pairs of k_scale and eps_scale from 1 to 4 and 0.5 to 3 this one has the
/// smallest median chatter in 6.7 among those that leave millimetres in 6.6; see the figure `as_reported_6_1`. It slows 1 m/s by 9.2 m/s², as a coefficient of friction near 1 would.
inline constexpr double kReportedDamping = 2.0;

/// The factors of a time step, \f$k^{\,60\,\Delta t\,s}\f$ with s = k_scale.
[[nodiscard]] DampedFactors factors_of(const DampedNumbers& numbers, double dt);

/// The thresholds of a body.
/// \param body     a box
/// \param gravity  [m/s²] size of gravity; without any, momenta have no scale and their thresholds
///         are 0
/// \return in SI units
[[nodiscard]] DampedThresholds thresholds_of(const DampedNumbers& numbers,
                                             const BodyProperties& body, double gravity, double dt);

/// Refuses constants that make no sense.
/// \throws std::invalid_argument naming the value: an ε or scale that is negative or not finite, a
///         k outside 0 to 1
void check(const DampedNumbers& numbers);

}  // namespace tumble
