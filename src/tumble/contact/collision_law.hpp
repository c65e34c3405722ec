/// \file
/// \brief An impact at one point: restitution and friction (thesis 2.5.1, 5.2).
#pragma once

#include "tumble/contact/effective_mass.hpp"

#include <cstdint>

namespace tumble {

/// What restitution means. Without friction both are the same.
enum class RestitutionLaw : std::uint8_t {
  newton,  ///< separation speed = e times speed of approach
  poisson  ///< normal impulse while separating = e times normal impulse while approaching
};

/// What the surfaces do across the normal during an impact.
enum class ImpactMode : std::uint8_t {
  none,         ///< there is no impulse: the point does not approach, or nothing can be moved
  stick,        ///< the tangential velocity ends at 0, as far as anything can be moved that way
  slip,         ///< friction is at Coulomb's bound
  frictionless  ///< no friction, though there may be a coefficient: see solve_impact()
};

/// An impact at one point, seen from the point: nothing else of the bodies matters.
///
/// | symbol | code              | meaning                            | unit |
/// |--------|-------------------|------------------------------------|------|
/// | n      | `normal_w`        | normal from first to second body   | -    |
/// | u      | `velocity_w`      | velocity of second against first   | m/s  |
/// | K      | `inverse_mass_w`  | u changes by K j                   | 1/kg |
/// | μ, e   | `friction`, `restitution` |                            | -    |
struct PointImpact {
  Vec3 normal_w = Vec3::UnitY();       ///< [-] length 1, world frame
  Vec3 velocity_w = Vec3::Zero();      ///< [m/s] relative_velocity() at the point
  Mat3 inverse_mass_w = Mat3::Zero();  ///< [1/kg] inverse_mass_at() of the pair
  double friction = 0.0;               ///< [-] at least 0
  double restitution = 0.0;            ///< [-] 0 to 1
  /// [m/s] n·u when the event began; below 0 the bodies approached. Newton's law asks for a
  /// separation speed of e times this, so that several impulses within one event do not bounce
  /// several times. Poisson's law does not use it.
  double approach_speed = 0.0;
};

/// The impulse of an impact and its account.
struct PointImpulse {
  Vec3 impulse_w = Vec3::Zero();       ///< [N s] on the second body, world frame
  ImpactMode mode = ImpactMode::none;  ///< what the surfaces do
  double restitution = 0.0;            ///< [-] e that was used: at most the e asked for
  double restitution_energy = 0.0;     ///< [J] work of the normal part of the impulse
  double friction_energy = 0.0;        ///< [J] work of the tangential part
};

/// Refuses values that are not those of an impact.
/// \throws std::invalid_argument naming the value that is not finite or out of range
void check(const PointImpact& impact);

/// Finds the impulse of an impact at one point.
///
/// A point that does not approach (n·u >= 0) gets none. Neither does one where nothing can be
/// moved along the normal. Otherwise the normal velocity ends at \f$w = e\,|v^-|\f$, and the
/// friction is as Guendelman, Bridson and Fedkiw have it: first the impulse that also ends all
/// slip; if it lies outside Coulomb's cone \f$|j_t| \le \mu j_n\f$, the one along
/// \f$n - \mu T\f$ with T the direction of the slip on arrival,
/// \f[ j_n = \frac{w - n\cdot u}{n^{\mathsf T} K (n - \mu T)} . \f]
/// If the denominator is not positive (a long thin body that friction would lever into the
/// surface, as in Painlevé's paradox), there is no such impulse and the impact is `frictionless`.
/// Poisson's law solves the approach like that with w = 0 and then adds the normal impulse
/// e j_n, with the friction that belongs to it; friction that would make the point approach again
/// is left out.
///
/// **Energy never rises.** The change is \f$E(j) = j\cdot u + \tfrac12 j^{\mathsf T} K j\f$, convex
/// in j, and Newton's law with friction can make it positive (Kane and Levinson). Then restitution
/// is lowered. Let j0 be the impulse for e = 0. On the way from j0 to j the normal velocity at the
/// end goes linearly from 0 to w, no point of the way leaves the cone, because it is convex, and E
/// is a parabola that is open upwards with E(j0) <= 0 < E(j): the last point with E = 0 is the
/// answer. If j0 and j both stick or both slip, the impulse is linear in e and this one belongs to
/// the largest restitution e' in [0, e] that the energy allows; otherwise to the largest on that
/// way. Should j0 itself raise the energy (slip that
/// friction turns round), the way starts at the frictionless impulse for e = 0, whose energy is
/// \f$-\tfrac12 (n\cdot u)^2/(n^{\mathsf T} K n)\f$, below 0 without doubt.
///
/// The energy is that of the two bodies, in the frame of a body of infinite mass.
/// It is split by the impulse that does the work: \f$j_n\,n\cdot(u + u^+)/2\f$ and \f$j_t\cdot(u + u^+)/2\f$.
/// \param impact  the impact, valid in the sense of check(), which is not called
/// \see Guendelman, Bridson, Fedkiw, "Nonconvex rigid bodies with stacking", 2003, section 7.
/// \see Kane, Levinson, "Dynamics: theory and applications", 1985, on energy and Newton's law.
/// \algorithm{Newton's model of a collision: section 3.3.2}
/// \verified{Impacts at random points of random pairs keep every promise}
[[nodiscard]] PointImpulse solve_impact(const PointImpact& impact, RestitutionLaw law);

/// Lets two bodies collide at a point: solve_impact() and apply_impulse() in one.
/// \param first        the body that the normal leaves; changed
/// \param second       the body that the normal enters; changed
/// \param friction     [-] at least 0
/// \param law          what restitution means; the approach speed is the present one
/// \throws std::invalid_argument naming the value that is not finite or out of range
PointImpulse collide_at_point(MovingBody& first, MovingBody& second, const Vec3& point_w,
                              const Vec3& normal_w, double friction, double restitution,
                              RestitutionLaw law = RestitutionLaw::newton);

/// How far one can go from a state whose energy is allowed towards one whose energy is not.
///
/// For \f$E(\theta) = E_0 + b\,\theta + a\,\theta^2\f$ with \f$E_0 \le 0 < E(1)\f$ and a >= 0.
/// \param start      [J] E_0, at most 0
/// \param slope      [J] b
/// \param curvature  [J] a, at least 0
/// \return [-] the largest θ in [0, 1] with E(θ) <= 0, to rounding
double largest_share(double start, double slope, double curvature);

}  // namespace tumble
