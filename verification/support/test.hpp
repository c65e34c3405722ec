/// \file
/// \brief The usual headers of a test: Catch2, and the scenes, techniques, numbers and chance of the library.
#pragma once

#include "tumble/base/cloned.hpp"
#include "tumble/base/index.hpp"
#include "tumble/base/number_text.hpp"
#include "tumble/base/random.hpp"
#include "tumble/contact/effective_mass.hpp"
#include "tumble/contact/gather.hpp"
#include "tumble/dynamics/energy.hpp"
#include "tumble/geometry/separation.hpp"
#include "tumble/math/elementary.hpp"
#include "tumble/math/rotation.hpp"
#include "tumble/scenes/library.hpp"
#include "tumble/scenes/scene_file.hpp"
#include "tumble/scenes/simulation.hpp"
#include "tumble/techniques.hpp"

#include "support/catch.hpp"

namespace tumble::test {

inline constexpr double kFrame = 1.0 / 60.0;  // [s] the step that the techniques are meant for
inline constexpr double kGravity = 9.81;      // [m/s²] of every scene with gravity

// A world with level ground.
// friction: [-]
inline World ground_world(double friction = 0.5, double restitution = 0.0) {
  World world;
  world.add_ground(friction, restitution);
  return world;
}

// A world without weight.
inline World weightless_world() {
  World world;
  world.gravity_w = Vec3::Zero();
  return world;
}

// The motion of all bodies of a world.
inline std::vector<MovingBody> moving_bodies(const World& world) {
  std::vector<MovingBody> moving;
  load_moving_bodies(world, moving);
  return moving;
}

}  // namespace tumble::test

// Every test speaks of these.
using namespace tumble;
using namespace tumble::test;
