/// \file
/// \brief Worlds for the tests of bodies in joints, and the distance of two of them.
#pragma once

#include "tumble/exterior_rotation/glued.hpp"
#include "tumble/scenes/simulation.hpp"

#include "support/changed_world.hpp"
#include "support/runs.hpp"
#include "support/scenes.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace tumble::test {

// Options of the technique.
inline GluedOptions way(GluedScheme scheme, PoseUpdate pose = PoseUpdate::separate) {
  return GluedOptions{.scheme = scheme, .pose = pose};
}

// Options of the technique with joints that push and do not pull.
inline GluedOptions pressing(GluedScheme scheme, GluedEvents events = GluedEvents::located) {
  GluedOptions options{
      .scheme = scheme, .joints = GluedJoints::unilateral, .events = events, .accuracy = 1e-12};
  return options;
}

// Difference of the states of two worlds.
// Returns [m, -] the largest distance of two centres, or difference of two orientations
inline double apart(const World& one, const World& other) {
  double worst = 0.0;
  for (std::size_t k = 0; k < one.states().size(); ++k) {
    const BodyState& a = one.states()[k];
    const BodyState& b = other.states()[k];
    worst = std::max({worst, (a.position_w - b.position_w).norm(),
                      std::min((a.orientation_wb.coeffs() - b.orientation_wb.coeffs()).norm(),
                               (a.orientation_wb.coeffs() + b.orientation_wb.coeffs()).norm())});
  }
  return worst;
}

// Whether two worlds have the same states to the last bit.
inline bool same_states(const World& one, const World& other) {
  return std::equal(one.states().begin(), one.states().end(), other.states().begin(),
                    other.states().end());
}

// All schemes, and each that allows it also with the exponential.
inline std::vector<GluedOptions> all_ways() {
  std::vector<GluedOptions> ways;
  for (const GluedScheme scheme : glued_schemes()) {
    GluedOptions options{.scheme = scheme};
    ways.push_back(options);
    if (scheme == GluedScheme::rk4 || scheme == GluedScheme::dormand_prince ||
        scheme == GluedScheme::midpoint)
      continue;
    options.pose = PoseUpdate::exponential;
    ways.push_back(options);
  }
  return ways;
}

// Text for failed checks.
inline std::string text_of(const GluedOptions& options) {
  return std::string(name_of(options.scheme)) + ", " + std::string(name_of(options.pose));
}

// Three boxes of different sizes and masses, glued to each other in free flight and tumbling as one.
inline World flying_group(const Vec3& gravity_w) {
  World world;
  world.gravity_w = gravity_w;
  const Vec3 spin_w(1.0, -2.0, 1.5);
  const auto put = [&](const Vec3& size, double mass, const Vec3& place_w) {
    world.add(box_properties(size, mass), place_w, Quat::Identity(), spin_w.cross(place_w), spin_w);
  };
  put(Vec3(1.0, 1.0, 1.0), 1.0, Vec3(0.0, 0.0, 0.0));
  put(Vec3(2.0, 0.5, 1.0), 3.0, Vec3(0.5, 0.75, 0.0));
  put(Vec3(0.5, 1.0, 0.5), 0.5, Vec3(0.75, 0.0, 0.25));
  // The group as a whole is at rest.
  double mass = 0.0;
  Vec3 momentum_w = Vec3::Zero();
  for (std::size_t k = 0; k < 3; ++k) {
    mass += world.bodies()[k].mass;
    momentum_w += world.states()[k].linear_momentum_w;
  }
  for (std::size_t k = 0; k < 3; ++k)
    world.states()[k].linear_momentum_w -= world.bodies()[k].mass / mass * momentum_w;
  return world;
}

// The largest distance of a joint's two sides, at its corners.
inline double apart(const Simulation& run) {
  double most = 0.0;
  for (const BodyJoint& joint : run.world().joints())
    most = std::max(most, gap_of(joint_of(run.world(), joint), run.world().states()).apart);
  return most;
}

}  // namespace tumble::test
