/// \file
/// \brief Steps with forces found once, and two ways to move a body with them (thesis 6.2).
///
/// Uses the chapter on analytic forces.
#pragma once

#include "tumble/contact/islands.hpp"
#include "tumble/dynamics/pose_update.hpp"
#include "tumble/exterior_rotation/joint_forces.hpp"

#include <span>
#include <string_view>
#include <vector>

namespace tumble {

/// How velocities are changed, and when.
enum class SimpleScheme : std::uint8_t {
  forward_euler,  ///< moves with the old velocities, then changes them. The thesis's; order 1
  semi_implicit,  ///< changes velocities by the forces at the start, moves with the new ones; order 1
  impulse,        ///< gravity, then impulses that make velocities right at the start; order 1
  leapfrog        ///< moves for half of the step, changes velocities there, moves again; order 2
};

/// One step of bodies in joints.
///
/// **Separate.** Each centre goes straight, \f$x^+ = x + h v\f$, each orientation turns by
/// \f$\exp(h\omega)\f$. The joints are right at the start, but a point of two bodies with
/// centres s apart is then, after a step,
/// \f[ \tfrac12\,\omega^2 h^2 s + O(h^3) \f]
/// off: arcs are longer inwards than tangents.
///
/// **Exponential.** A body's motion at an instant is a twist: the angular velocity, and the velocity of
/// that of its points which is at the origin just then. Held for a step it moves the body by
/// \f[ x^+ = x + h u + h V(h\omega)\,(v - u), \qquad q^+ = \exp(h\omega)\,q, \f]
/// with V of along_arc() and a reference velocity u: 0 for a group that stands on something immovable,
/// the velocity of its centre of mass for a group in free flight (which has to go straight). All bodies
/// of a group that turns as one have the same twist, so they stay together to the last digits, whatever
/// h is. Two that turn about a common point p which moves at v_p, with spins that differ by Δω, come apart
/// by \f$\tfrac12 h^2\,|\Delta\omega|\,|v_p|\f$ in a step.
///
/// Forces are held over the step as before. They change the twist at the rate
/// \f$\dot\omega = I^{-1}(\tau - \omega\times L)\f$ and, at the centre,
/// \f$F/m - \omega\times(v - u)\f$: what turns the velocity with the body is done by the motion itself, so
/// that a body without force on its twist goes round its circle for ever.
/// \par Cost
/// One solve of the joints; `leapfrog` takes two, as what turns the twist depends on itself.
/// \algorithm{Poses by the exponential of a twist: section 6.2}
/// \deviation{The thesis knows no cure; it thinks of one pivot for each group.}
/// \verified{The exponential keeps the glued column together over a fall}
class SimpleSteps {
 public:
  /// One step of all movable bodies.
  /// \param scheme  how velocities are changed
  /// \param pose    how bodies are moved
  /// \param dt      [s] above 0
  /// \param joints  what is held
  /// \param forces  finds the forces or impulses
  /// \param world   states in and out; time is not counted
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
  std::vector<Vec3> reference_rate_w_;  // [m/s²] how it changes: gravity for a group in free flight
  std::vector<BodyState> before_;       // momenta that a trial step starts from
  std::vector<IndexPair> pairs_;
  Islands groups_;
};

}  // namespace tumble
