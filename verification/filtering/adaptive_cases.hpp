/// \file
/// \brief Worlds for the tests of adaptive steps.
#pragma once

#include "tumble/filtering/adaptive_step.hpp"
#include "tumble/scenes/library.hpp"
#include "tumble/techniques.hpp"

#include "support/scenes.hpp"

#include <memory>
#include <string>

namespace tumble::adaptive_cases {

constexpr double kStep = 1.0 / 60.0;  // [s] a whole step

// A technique with its default options.
inline std::unique_ptr<Technique> make(const char* name) { return make_technique(name); }

// Options with default tolerances.
inline AdaptiveStepOptions halvings(int most, int fewest = 0) {
  return AdaptiveStepOptions{.halvings = most, .fewest = fewest};
}

// Cubes that fly together, fall and chatter.
inline World clump(int per_edge) {
  return test::world_of("fig6_7", {{"per_edge", std::to_string(per_edge)}});
}

// A cube of 0.2 m and 1 kg, 5 m above the origin.
// spin_w: [rad/s]
inline World one_cube(const Vec3& velocity_w, const Vec3& spin_w = Vec3::Zero()) {
  World world;
  world.add(box_properties(Vec3::Constant(0.2), 1.0), Vec3(0.0, 5.0, 0.0), Quat::Identity(),
            velocity_w, spin_w);
  return world;
}

}  // namespace tumble::adaptive_cases
