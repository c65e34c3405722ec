/// \file
/// \brief Runs of the glued column of figure 6.1, and how far each is off in the end.
#include "exterior_rotation/column_runs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace tumble::chapters {
namespace {

GluedOptions options_of(const ColumnScheme& scheme) {
  GluedOptions options;
  options.scheme = scheme.scheme;
  options.pose = scheme.pose;
  options.accuracy = 1.0;  // no step is refused
  return options;
}

ColumnRun run(Glued& glued, int steps, const ColumnFall& fall) {
  World world = column_world(fall.phi0, 0.0, fall.count);
  ColumnRun found;
  for (int k = 0; k < steps; ++k) {
    glued.step(world, fall.time / steps);
    found.largest_gap = std::max(found.largest_gap, std::abs(column_gap(world)));
    found.largest_apart =
        std::max(found.largest_apart, gap_of(glued.joints(), world.states()).apart);
  }
  found.angle_error = centre_angle(world) - column_angle(fall.time, fall.phi0, fall.count);
  found.gap = column_gap(world);
  found.solves = glued.solves();
  return found;
}

}  // namespace

std::span<const ColumnScheme> separate_schemes() {
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

std::span<const ColumnScheme> exponential_schemes() {
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

const ColumnScheme& column_scheme(std::string_view column) {
  for (const std::span<const ColumnScheme> schemes : {separate_schemes(), exponential_schemes()})
    for (const ColumnScheme& scheme : schemes)
      if (scheme.column == column) return scheme;
  throw std::invalid_argument("no scheme " + std::string(column));
}

ColumnRun run_column(const ColumnScheme& scheme, int steps, const ColumnFall& fall) {
  Glued glued(options_of(scheme));
  return run(glued, steps, fall);
}

ColumnRun run_column_accurately(double accuracy, const ColumnFall& fall) {
  GluedOptions options;
  options.scheme = GluedScheme::dormand_prince;
  options.accuracy = accuracy;
  Glued glued(options);
  return run(glued, 1, fall);
}

}  // namespace tumble::chapters
