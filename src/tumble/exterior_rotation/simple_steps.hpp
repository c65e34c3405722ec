/// \file
/// \brief Steps with one evaluation of forces, and two pose updates for them (thesis 6.2).
///
/// Uses the chapter on analytic forces.
#pragma once

#include "tumble/contact/islands.hpp"
#include "tumble/dynamics/pose_update.hpp"
#include "tumble/exterior_rotation/joint_forces.hpp"

#include <span>
#include <vector>

namespace tumble {

/// Order of the velocity and the position update.
enum class SimpleScheme : std::uint8_t {
  forward_euler,  ///< moves with the old velocities, then changes them. The thesis's; order 1
  semi_implicit,  ///< changes velocities by the forces at the start, moves with the new ones; order 1
  impulse,        ///< gravity, then impulses that make velocities consistent at the start; order 1
  leapfrog        ///< moves for half of the step, changes velocities there, moves again; order 2
};

/// Integrator with one evaluation of forces for bodies in joints.
///
/// **Separate.** Each centre moves straight, \f$x^+ = x + h v\f$, each orientation turns by
/// \f$\exp(h\omega)\f$. The joints are exact at the start, but the two positions of a joint point between
/// bodies with centres s apart differ after a step by
/// \f[ \tfrac12\,\omega^2 h^2 s + O(h^3) , \f]
/// since a tangent leaves the arc outwards.
///
/// **Exponential.** The motion of a body at an instant is a twist: the angular velocity, and the velocity
/// of its point that is at the origin at that instant. A constant twist moves the body in a step by
/// \f[ x^+ = x + h u + h V(h\omega)\,(v - u), \qquad q^+ = \exp(h\omega)\,q, \f]
/// with V of along_arc() and a reference velocity u: 0 for a group on an immovable body, the velocity of
/// the centre of mass for a group in free flight (which must move straight). All bodies of a rigid
/// group have the same twist, so they stay together to rounding for any h. Two bodies that turn about a
/// common point p with velocity v_p, with angular velocities that differ by Δω, separate by
/// \f$\tfrac12 h^2\,|\Delta\omega|\,|v_p|\f$ in a step.
///
/// Forces are constant over the step. They change the twist at the rate
/// \f$\dot\omega = I^{-1}(\tau - \omega\times L)\f$ and, at the centre,
/// \f$F/m - \omega\times(v - u)\f$: the rotation of the velocity with the body is part of the motion itself,
/// so that a body whose twist is constant stays on its circle.
/// \par Cost
/// One solve of the joints; `leapfrog` takes two, as the rate of the twist depends on the twist.
/// \algorithm{Poses by the exponential of a twist: section 6.2}
/// \deviation{The thesis gives no remedy; it suggests one pivot for each group.}
/// \verified{The exponential keeps the glued column together over a fall}
class SimpleSteps {
 public:
  /// One step of all movable bodies.
  /// \param world   states in and out; its time does not change
  void step(SimpleScheme scheme, PoseUpdate pose, double dt, std::span<const Joint> joints,
            JointForces& forces, World& world);

 private:
  void find_references(std::span<const Joint> joints, const World& world);
  void find_rates(PoseUpdate pose, std::span<const Joint> joints, JointForces& forces,
                  const World& world);
  void kick(PoseUpdate pose, double dt, World& world);
  void move(PoseUpdate pose, double dt, World& world);
  void put_velocities(World& world);

  std::vector<MovingBody> moving_;
  std::vector<Wrench> wrenches_;
  std::vector<Acceleration> rates_;     // of the twists
  std::vector<Vec3> reference_w_;       // [m/s] u, by body
  std::vector<Vec3> reference_rate_w_;  // [m/s²] du/dt: gravity for a group in free flight
  std::vector<BodyState> before_;       // momenta at the start of a trial step
  std::vector<IndexPair> pairs_;
  Islands groups_;
};

}  // namespace tumble
