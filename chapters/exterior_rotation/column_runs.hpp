/// \file
/// \brief Runs of the glued column of figure 6.1, and their errors at the end (thesis 6.2).
#pragma once

#include "tumble/exterior_rotation/glued.hpp"

#include "driver/experiment.hpp"
#include "exterior_rotation/falling_column.hpp"
#include "exterior_rotation/glued_runs.hpp"

namespace tumble::chapters {

// A way to integrate the column.
struct ColumnScheme {
  std::string column;  // of tables
  std::string words;   // for readers
  GluedScheme scheme;  // how the motion is integrated
  PoseUpdate pose;     // how bodies are moved
  int order;           // that the angle's error should have
  int stages;          // force solves in a step
};

// The schemes with centres and orientations moved each by itself, and those of several stages.
inline std::span<const ColumnScheme> separate_schemes() {
  static const std::array<ColumnScheme, 7> schemes{{
      {"forward_euler", "forward Euler", GluedScheme::forward_euler, PoseUpdate::separate, 1, 1},
      {"semi_implicit", "semi-implicit Euler", GluedScheme::semi_implicit, PoseUpdate::separate, 1,
       1},
      {"impulse", "impulses", GluedScheme::impulse, PoseUpdate::separate, 1, 1},
      {"midpoint", "midpoint", GluedScheme::midpoint, PoseUpdate::separate, 2, 2},
      {"leapfrog", "leapfrog", GluedScheme::leapfrog, PoseUpdate::separate, 2, 2},
      {"rk4", "Runge-Kutta 4", GluedScheme::rk4, PoseUpdate::separate, 4, 4},
      {"dormand_prince", "Dormand-Prince 5", GluedScheme::dormand_prince, PoseUpdate::separate, 5,
       7},
  }};
  return schemes;
}

// The schemes that move bodies by the exponential of their twists.
inline std::span<const ColumnScheme> exponential_schemes() {
  static const std::array<ColumnScheme, 4> schemes{{
      {"forward_euler_exp", "forward Euler, exponential", GluedScheme::forward_euler,
       PoseUpdate::exponential, 1, 1},
      {"semi_implicit_exp", "semi-implicit Euler, exponential", GluedScheme::semi_implicit,
       PoseUpdate::exponential, 1, 1},
      {"impulse_exp", "impulses, exponential", GluedScheme::impulse, PoseUpdate::exponential, 1, 1},
      {"leapfrog_exp", "leapfrog, exponential", GluedScheme::leapfrog, PoseUpdate::exponential, 2,
       2},
  }};
  return schemes;
}

// The scheme of a column of tables.
inline const ColumnScheme& column_scheme(std::string_view column) {
  for (const std::span<const ColumnScheme> schemes : {separate_schemes(), exponential_schemes()})
    for (const ColumnScheme& scheme : schemes)
      if (scheme.column == column) return scheme;
  throw std::invalid_argument("no scheme " + std::string(column));
}

// A fall to run.
struct ColumnFall {
  double phi0 = 0.3;  // [rad] of the centre at the start
  double time = 1.0;  // [s] that it falls, from rest
  int count = 4;      // cubes
};

// Settings of a figure for a fall.
// time: [s] that it falls
inline Parameters fall_parameters(double time) {
  return {number("phi0", 0.3, 0.01, 0.5, "rad",
                 "of the column's centre at the start, from the vertical"),
          number("time", time, 0.1, 3.0, "s", "that it falls")};
}

// The end of a run.
struct ColumnRun {
  double angle_error = 0.0;    // [rad] of the centre at the end, less that of the closed form
  double gap = 0.0;            // [m] column_gap() at the end
  double largest_gap = 0.0;    // [m] largest magnitude of column_gap() after any step
  double largest_apart = 0.0;  // [m] largest distance of any glued point from itself
  int solves = 0;              // systems of joint forces solved: the work
};

inline ColumnRun run(GluedScheme scheme, PoseUpdate pose, double accuracy, int steps,
                     const ColumnFall& fall) {
  ColumnRun found;
  const GluedRun end =
      run_glued(column_world(fall.phi0, 0.0, fall.count), glued_options(scheme, pose, accuracy),
                fall.time / steps, steps, [&](const World& world, const JointGap&) {
                  found.gap = column_gap(world);
                  found.largest_gap = std::max(found.largest_gap, std::abs(found.gap));
                });
  found.largest_apart = end.apart;
  found.angle_error = centre_angle(end.world) - column_angle(fall.time, fall.phi0, fall.count);
  found.solves = end.solves;
  return found;
}

// Lets the column fall in equal steps, its joints held.
inline ColumnRun run_column(const ColumnScheme& scheme, int steps, const ColumnFall& fall = {}) {
  return run(scheme.scheme, scheme.pose, 1.0, steps, fall);  // with 1.0 no step is refused
}

// Lets the column fall in steps as long as an accuracy allows, by dormand_prince.
// accuracy: [-] error allowed in a step
inline ColumnRun run_column_accurately(double accuracy, const ColumnFall& fall = {}) {
  return run(GluedScheme::dormand_prince, PoseUpdate::separate, accuracy, 1, fall);
}

}  // namespace tumble::chapters
