/// \file
/// \brief Runs of the glued column of figure 6.1, and their errors at the end.
#include "exterior_rotation/column_runs.hpp"

#include "exterior_rotation/glued_runs.hpp"

namespace tumble::chapters {
namespace {

ColumnRun run(GluedScheme scheme, PoseUpdate pose, double accuracy, int steps,
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

Parameters fall_parameters(double time) {
  return Parameters{}
      .add_number("phi0", 0.3, 0.01, 0.5, "rad",
                  "of the column's centre at the start, from the vertical")
      .add_number("time", time, 0.1, 3.0, "s", "that it falls");
}

ColumnRun run_column(const ColumnScheme& scheme, int steps, const ColumnFall& fall) {
  return run(scheme.scheme, scheme.pose, 1.0, steps, fall);  // with 1.0 no step is refused
}

ColumnRun run_column_accurately(double accuracy, const ColumnFall& fall) {
  return run(GluedScheme::dormand_prince, PoseUpdate::separate, accuracy, 1, fall);
}

}  // namespace tumble::chapters
