/// \file
/// \brief An impact at one point, followed through its duration (thesis 2.5.2).
#pragma once

#include "tumble/contact/collision_law.hpp"

namespace tumble {

/// When an impact is over.
enum class ImpactEnd : std::uint8_t {
  work,  ///< Stronge: the normal impulse has given back e² of the work that it took
  impulse  ///< Poisson: separating took e times the impulse of approaching. With friction energy may rise
};

/// An impact at one point and how it ends.
///
/// | symbol | code              | meaning                            | unit |
/// |--------|-------------------|------------------------------------|------|
/// | n      | `normal_w`        | normal from first to second body   | -    |
/// | u      | `velocity_w`      | velocity of second against first   | m/s  |
/// | K      | `inverse_mass_w`  | u changes by K j                   | 1/kg |
/// | μ, e   | `friction`, `restitution` |                            | -    |
struct SlidingImpact {
  Vec3 normal_w = Vec3::UnitY();       ///< [-] length 1, world frame
  Vec3 velocity_w = Vec3::Zero();      ///< [m/s] relative_velocity() at the point
  Mat3 inverse_mass_w = Mat3::Zero();  ///< [1/kg] inverse_mass_at() of the pair, positive definite
  double friction = 0.0;               ///< [-] at least 0
  double restitution = 0.0;            ///< [-] 0 to 1
  ImpactEnd end = ImpactEnd::work;     ///< what restitution means
  double rebound = 0.0;  ///< [m/s] it also goes on until the bodies part this fast, at least 0
};

/// What an impact was.
struct SlidingImpulse {
  Vec3 impulse_w = Vec3::Zero();  ///< [N s] on the second body, world frame
  ImpactMode mode =
      ImpactMode::none;  ///< at the end: stick, or slip; none if the point does not approach
  bool stopped = false;  ///< whether slip came to a stop on the way
  int steps = 0;         ///< of the integration, where slip turns
};

/// Follows an impact through its duration, with friction that changes on the way.
///
/// The time of an impact is the normal impulse p that has acted. While the point slides with the slip \f$u_t\f$, friction is
/// at Coulomb's bound and against it,
/// \f[ \frac{\mathrm du}{\mathrm dp} = K \begin{pmatrix} -\mu\,u_t/|u_t| \\ 1 \end{pmatrix} . \tag{1} \f]
/// Friction turns the slip, slows it, or makes it faster. **Where it stops**, friction f per normal impulse would hold the
/// point if \f$f = -K_{tt}^{-1} K_{tn}\f$. If \f$|f| \le \mu\f$ the point sticks for the rest of the impact. If not, it slides off at
/// once along the one direction \f$\hat u\f$ in which it stays,
/// \f[ (\mu K_{tt} + \lambda)\,\hat u = K_{tn}, \quad \lambda > 0, \quad |\hat u| = 1 . \tag{2} \f]
/// The length of \f$(\mu K_{tt} + \lambda)^{-1} K_{tn}\f$ falls with λ from \f$|f|/\mu\f$, which is above 1, so there is exactly one.
///
/// Slip of a constant direction, sticking and (2) are straight lines in p, and are followed exactly: an impact in a plane of symmetry is
/// Routh's. Where slip turns, (1) is integrated with \f$\mathrm dp = |u_t|\,\mathrm d\sigma\f$. Then nothing is
/// singular where the slip ends, which takes σ for ever, and the rest is a straight line.
///
/// Approaching ends where \f$n\cdot u = 0\f$; then as ImpactEnd says. With ImpactEnd::work no energy is added unless `rebound` asks for it. It
/// always ends: K is positive definite, so slip that grows goes with a push that parts the bodies, and slip that shrinks
/// comes to its end.
/// \param impact  the impact, its values as SlidingImpact has them, which is not checked
/// \see Routh, "Dynamics of a system of rigid bodies", elementary part, 1905; Keller, "Impact with friction", J. Appl. Mech. 53, 1986;
///      Mirtich, "Impulse-based dynamic simulation of rigid body systems", 1996.
/// \algorithm{Friction through an impact: section 2.5.2}
/// \verified{Impacts of a rod are Routh's: they slide, stick, or slide back}
[[nodiscard]] SlidingImpulse solve_sliding_impact(const SlidingImpact& impact);

}  // namespace tumble
