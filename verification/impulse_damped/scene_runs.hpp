/// \file
/// \brief Runs of built-in scenes with a technique by name, and their measurements.
#pragma once

#include "tumble/dynamics/energy.hpp"
#include "tumble/math/rotation.hpp"
#include "tumble/scenes/library.hpp"
#include "tumble/techniques.hpp"

#include "support/pose.hpp"
#include "support/runs.hpp"
#include "support/scenes.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string_view>

namespace tumble::test {

// A technique with its defaults, but for sleeping: what stands has to stand without it.
inline std::unique_ptr<Technique> awake(std::string_view name, const Settings& set = {}) {
  const TechniqueRecipe& recipe = technique_recipe(name);
  Parameters options = recipe.options();
  if (options.has("sleeping")) options.set("sleeping", "off");
  if (options.has("pose")) options.set("pose", name_of(pose_under_test));
  for (const auto& [key, value] : set) options.set(key, value);
  return recipe.make(options, 1);
}

// What happened in a stretch of a run.
struct Course {
  int failed = 0;         // steps that did not end as done
  double moved = 0.0;     // [m] largest distance of a body from its place at the start
  double overlap = 0.0;   // [m] deepest
  double booked = 0.0;    // [J] sum of what the reports say was added
  double unbooked = 0.0;  // [J] largest change of the energy since the start that is not booked
  double fastest = 0.0;   // [m/s] largest speed of a centre at the end of a step
  int not_finite = 0;     // steps after which a position was no number
};

// The largest angle between the orientations of the same body in two worlds [rad].
inline double turned_most_of(const World& a, const World& b) {
  double worst = 0.0;
  for (std::size_t k = 0; k < a.states().size(); ++k)
    worst =
        std::max(worst, angle_between(a.states()[k].orientation_wb, b.states()[k].orientation_wb));
  return worst;
}

// Steps a world and measures.
// seconds: [s] how long; whole steps
inline Course run(World& world, Technique& technique, double seconds, double dt = kFrame) {
  Course course;
  const World start = world;
  const double energy = energy_of(world).total();
  const int steps = static_cast<int>(std::lround(seconds / dt));
  for (int k = 0; k < steps; ++k) {
    const StepReport report = technique.step(world, dt);
    if (report.status != StepStatus::done) ++course.failed;
    course.booked += report.energy.total();
    course.overlap = std::max(course.overlap, report.deepest_overlap);
    course.moved = std::max(course.moved, distance_of(world, start));
    course.unbooked =
        std::max(course.unbooked, std::abs(energy_of(world).total() - energy - course.booked));
    course.fastest = std::max(course.fastest, fastest_of(world));
    if (!std::isfinite(course.moved)) ++course.not_finite;
  }
  return course;
}

}  // namespace tumble::test
