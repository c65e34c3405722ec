/// \file
/// \brief The listing COLLIDE: one impulse between two bodies that overlap (thesis 5.2, A.2).
#pragma once

#include "tumble/contact/gather.hpp"
#include "tumble/contact/simultaneous_impacts.hpp"
#include "tumble/impulse_damped/damped_bodies.hpp"

namespace tumble {

/// With which velocities two bodies collide.
enum class TemporaryGravity : std::uint8_t {
  velocity_no_gravity,   ///< with those that they have
  velocity_plus_gravity  ///< with those that gravity is about to give them in this step
};

/// What an impulse did.
struct CollideResult {
  bool pushed = false;   ///< whether there was one
  double impulse = 0.0;  ///< [N s] along the normal, on the second body, at least 0
  /// [J] kinetic energy that it added to both bodies, 0 or below: seen with the temporary gravity,
  /// that is, as if gravity had been added before the impulse
  double restitution = 0.0;
  int pivots = 0;  ///< of the complementarity solver, for contact areas
};

/// The listing COLLIDE, in the sense in which it was meant.
///
/// Impulses are Newton's and have no friction: \f$v_n^+ = -e\,v_n^-\f$ with e from -1 to 1. Below
/// 0 the bodies still approach afterwards, at |e| of their speed: contacts stop over several
/// passes.
///
/// **Mended.** The temporary gravity is g Δt, not g, and is for movable bodies only: added to the
/// ground as well it would cancel, and nothing would hold against gravity. Stable bodies cannot be
/// moved vertically or tipped by the impulse, as section 5.4 says, and are stopped before the
/// temporary gravity is taken away again; stopped afterwards they would lose the support. Bodies
/// that part are left alone: Newton's law would pull them back.
/// \algorithm{COLLIDE: appendix A.2}
/// \deviation{Gravity is multiplied by the step and given to movable bodies only; stable bodies are held while the impulse acts; bodies that part get none.}
/// \verified{A cube that lands flat leaves with 0.9 of its speed and does not turn}
class Collide {
 public:
  /// Lets two bodies collide.
  /// \param collision    the pair, its normal and point (or points, which are resolved together);
  ///                     gets the impulses added
  /// \param restitution  [-] e, -1 to 1
  /// \param bodies       velocities and marks; changed
  CollideResult run(const World& world, Contact& collision, double restitution,
                    TemporaryGravity gravity, double dt, DampedBodies& bodies);

 private:
  CollideResult apply_newtonian_impulse(const World& world, Contact& collision, double restitution,
                                        const Vec3& ahead_w, DampedBodies& bodies);
  int area_impulse(Contact& collision, double restitution, DampedBodies& bodies);

  SimultaneousImpacts block_;
  Contact work_;  // the impulses of one call
};

}  // namespace tumble
