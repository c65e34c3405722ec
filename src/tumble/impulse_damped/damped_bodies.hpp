/// \file
/// \brief The bodies of a step as the stages of damped integration see them (thesis 5.2, 5.4).
#pragma once

#include "tumble/contact/contact.hpp"
#include "tumble/dynamics/advance_pose.hpp"

#include <span>
#include <vector>

namespace tumble {

/// The bodies of a step: velocities while impulses are found, where they lead, and two marks.
///
/// There is one store of each: velocities here, from load() to store(), and momenta in the world
/// before and after. The poses of the world do not change meanwhile; predicted ones are copies.
struct DampedBodies {
  /// Velocities and inverse masses, one for each body index. Places are the predicted ones, so
  /// lever arms are too; inertia is that of the step's start. Sleepers are as heavy as the ground.
  std::vector<MovingBody> moving;
  std::vector<Mat3> axes_w;          ///< by index: [-] axes as columns at the step's start
  std::vector<BodyState> predicted;  ///< by index: where bodies come to, see predict()
  std::vector<char> stable;          ///< by index: geometrically stable when the step began
  std::vector<char> touched;         ///< by index: has had a contact interaction in this step

  /// Reads velocities; nothing is touched yet.
  /// \param firmly  by index: whether it is geometrically stable
  void load(const World& world, std::span<const char> firmly);

  /// integrateObjectPositions(Δt, VELOCITY_PLUS_GRAVITY): where bodies come to with the velocities
  /// that they have and the gravity of one step. What has the velocity of the pass before is there.
  /// \param world  the bodies at the step's start
  /// \return how many bodies were advanced
  int predict(const World& world, double dt, RotationRule rule);

  /// Takes the mark of stability from bodies that are touched from the side (thesis 5.4: all
  /// normals of a stable body's contacts are along the y axis).
  void clear_tilted(const World& world, std::span<const Contact> collisions);

  /// Whether a contact has a movable body that is geometrically stable. Its normal is along the y
  /// axis, or the mark would have been taken: see clear_tilted().
  [[nodiscard]] bool holds_firm(const World& world, const Contact& contact) const;

  /// Makes a body easy to move as it is by itself, or, if it is stable, sideways and about the
  /// vertical only: an upright box that cannot sink, rise or tip.
  void set_ease(const World& world, int body);

 private:
  // By index: with what predict() has moved it, since load().
  struct Motion {
    bool any = false;  // whether it has
    bool changed = false;
    double dt = 0.0;
    Vec3 velocity_w, angular_velocity_w;
    RotationRule rule{};

    [[nodiscard]] bool same_bits(const Motion& other) const;
  };
  std::vector<Motion> moved_with_;
};

/// The kinetic energy of a body in a stage, \f$\tfrac12 m v^2 + \tfrac12 \omega\cdot I\omega\f$.
/// \param axes_w  [-] its axes as columns
/// \return [J] 0 for an immovable body
double kinetic_energy_of(const BodyProperties& body, const Mat3& axes_w, const MovingBody& moving);

}  // namespace tumble
