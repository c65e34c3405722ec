/// \file
/// \brief Small worlds of cubes, their steps and their speeds, for tests of techniques.
#pragma once

#include "tumble/dynamics/technique.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace tumble::test {

// Stores all collisions.
class Listener final : public Observer {
 public:
  void on_event(const Event& event) override { events.push_back(event); }
  EventLog events;  // in the order of their reports
};

// Does steps of one length.
// dt: [s] of each
inline int run(World& world, Technique& technique, int steps, double dt = 1.0 / 60.0) {
  int failed = 0;
  for (int k = 0; k < steps; ++k)
    if (technique.step(world, dt).status != StepStatus::done) ++failed;
  return failed;
}

// The largest speed in a world [m/s], of a centre, or [rad/s] of a spin.
inline double fastest(const World& world) {
  double speed = 0.0;
  for (std::size_t k = 0; k < world.bodies().size(); ++k)
    speed = std::max({speed, velocity(world.bodies()[k], world.states()[k]).norm(),
                      angular_velocity(world.bodies()[k], world.states()[k]).norm()});
  return speed;
}

// How fast the fastest centre is [m/s].
inline double fastest_of(const World& world) {
  double speed = 0.0;
  for (std::size_t k = 0; k < world.bodies().size(); ++k)
    speed = std::max(speed, velocity(world.bodies()[k], world.states()[k]).norm());
  return speed;
}

// The largest distance between the places of the same body in two worlds [m]: infinite if a place is no number.
inline double distance_of(const World& a, const World& b) {
  double worst = 0.0;
  for (std::size_t k = 0; k < a.states().size(); ++k) {
    const double far = (a.states()[k].position_w - b.states()[k].position_w).norm();
    worst = std::max(worst, std::isfinite(far) ? far : std::numeric_limits<double>::infinity());
  }
  return worst;
}

// Cubes of 1 m and 1 kg on top of each other on the ground.
// friction: [-] of all, the ground too
// restitution: [-] ditto
inline World stack_of(int count, double friction = 0.5, double restitution = 0.0) {
  World world;
  world.add_ground(friction, restitution);
  const BodyProperties cube = box_properties(Vec3::Ones(), 1.0, friction, restitution);
  for (int k = 0; k < count; ++k) world.add(cube, Vec3(0.0, k + 0.5, 0.0));
  return world;
}

// A flat box on a plane that is tilted by an angle, seen from a camera that is tilted with it:
// gravity has a part along x. A sliding box of this shape stays flat.
// friction: [-] of box and plane
// speed: [m/s] downhill
inline World tilted_plane(double degrees, double friction, double speed = 0.0) {
  World world;
  world.add_ground(friction);
  const double angle = degrees * std::numbers::pi / 180.0;
  world.gravity_w = 9.81 * Vec3(std::sin(angle), -std::cos(angle), 0.0);
  world.add(box_properties(Vec3(1.0, 0.2, 1.0), 1.0, friction), Vec3(0.0, 0.1, 0.0),
            Quat::Identity(), Vec3(speed, 0.0, 0.0));
  return world;
}

}  // namespace tumble::test
