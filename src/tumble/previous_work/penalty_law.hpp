/// \file
/// \brief One mass on a spring and a damper: its bounce, and the steps that it stands (thesis 2.5.1).
#pragma once

#include <cstdint>

namespace tumble {

/// How a step follows springs and dampers. Forces are those where the step begins.
enum class PenaltyScheme : std::uint8_t {
  semi_implicit,  ///< velocities first; bodies move with the new ones
  explicit_euler  ///< bodies move with the old velocities
};

/// The mass m at the spring k and the damper c, \f$m\ddot x = -k x - c\dot x\f$ for \f$x < 0\f$.
struct PenaltyLaw {
  double frequency = 0.0;  ///< [rad/s] \f$\omega = \sqrt{k/m}\f$
  double damping = 0.0;    ///< [-] \f$\zeta = c/(2\sqrt{km})\f$; 1 is critical
};

/// The longest step with which a swing does not grow.
///
/// With \f$x' = x + h v'\f$ a swing decays while \f$h^2\omega^2 + 4\zeta h\omega < 4\f$: without damping below
/// \f$2/\omega\f$. With \f$x' = x + h v\f$ it decays while \f$h\omega < 2\zeta\f$ and
/// \f$4\zeta h\omega < 4 + h^2\omega^2\f$: without damping never.
/// \param law  frequency above 0, damping at least 0
/// \return [s] 0: no step
/// \verified{Swings on springs decay below the stable step and grow above it}
double stable_step(PenaltyScheme scheme, const PenaltyLaw& law);

/// Restitution of a bounce without gravity.
///
/// If the damper may pull, the mass is released where it touched, after half a swing:
/// \f$e = \exp(-\pi\zeta/\sqrt{1-\zeta^2})\f$, and 0 from critical damping on. If contacts only push, it is released
/// as soon as the damper would pull more than the spring pushes, and
/// \f$e = \exp(-2\zeta\arccos\zeta/\sqrt{1-\zeta^2})\f$: \f$e^{-2}\f$ at critical damping.
/// \param damping  [-] ζ, at least 0
/// \return [-] 0 to 1
/// \verified{A ball on a spring and a damper bounces by the closed forms of both laws}
double penalty_restitution(double damping, bool pull);

/// The damping that gives a restitution, at most 1.
/// \param pull         whether contacts may pull
/// \return [-] the inverse of penalty_restitution(); 1 for restitutions below those of critical damping
double penalty_damping_for(double restitution, bool pull);

}  // namespace tumble
