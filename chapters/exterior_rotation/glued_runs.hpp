/// \file
/// \brief Runs of groups that stick, and the groups of the figures on the cure (thesis 6.2).
#pragma once

#include "tumble/exterior_rotation/glued.hpp"

#include "driver/experiment.hpp"

namespace tumble::chapters {

// Options of the technique `glued`.
// accuracy: [-] of dormand_prince, error allowed in a step
inline GluedOptions glued_options(GluedScheme scheme, PoseUpdate pose = PoseUpdate::separate,
                                  double accuracy = GluedOptions{}.accuracy) {
  return GluedOptions{.scheme = scheme, .pose = pose, .accuracy = accuracy};
}

// Numbers that are evenly spread in the logarithm.
inline std::vector<double> log_spaced(double first, double last, int count) {
  std::vector<double> numbers;
  for (int k = 0; k < count; ++k) {
    const double share = static_cast<double>(k) / (count - 1);
    numbers.push_back(first * std::exp(share * std::log(last / first)));
  }
  return numbers;
}

// The result of a run of the technique `glued`.
struct GluedRun {
  World world;         // at the end
  double gap = 0.0;    // [m] largest opening or overlap of any joint after any step
  double apart = 0.0;  // [m] largest distance of a held corner from itself after any step
  int solves = 0;      // systems of joint forces solved
};

// Runs a group that sticks.
inline GluedRun run_glued(World world, const GluedOptions& options, double dt, int steps,
                          const std::function<void(const World&, const JointGap&)>& after = {}) {
  Glued technique(options);
  GluedRun run;
  for (int k = 0; k < steps; ++k) {
    finished(technique.step(world, dt));
    const JointGap gap = gap_of(technique.joints(), world.states());
    run.gap = std::max({run.gap, gap.opening, gap.overlap});
    run.apart = std::max(run.apart, gap.apart);
    if (after) after(world, gap);
  }
  run.world = std::move(world);
  run.solves = technique.solves();
  return run;
}

inline constexpr int kCubes = 4;
inline const Vec3 kSupport = Vec3(4.0, 2.0, 4.0);  // [m] the larger box
inline constexpr double kInset = 0.1;              // [m] from its edges to the pivot

// Four cubes that stick, as a column that stands on one corner: a ball joint on top of a larger box,
// near the corner of it beyond which the column falls.
// angle: [rad] of the column's centre, as seen from the pivot, from the vertical
// spin: [rad/s] of the column about its long axis
inline World column_on_corner(double angle, double spin) {
  World world;
  const BodyProperties support = fixed_box_properties(kSupport);
  world.add(support, Vec3(kInset, 0.0, kInset) - 0.5 * kSupport);
  const BodyProperties cube = box_properties(Vec3::Ones(), 1.0);

  // The column's centre is a half diagonal from its corner. A first turn puts it above the corner, a
  // second one leans it, towards +x and +z alike.
  const Vec3 to_centre_b(-0.5, 0.5 * kCubes, -0.5);
  const Vec3 lean_w = Vec3(1.0, 0.0, -1.0).normalized();
  const double tilt = std::atan2(0.5 * std::numbers::sqrt2, 0.5 * kCubes);
  const Quat turned_wb = rotation_from_vector((angle + tilt) * lean_w);
  const Vec3 spin_w = spin * (turned_wb * Vec3::UnitY());
  for (int k = 0; k < kCubes; ++k) {
    const Vec3 place_w = turned_wb * (to_centre_b + Vec3(0.0, 0.5 + k - 0.5 * kCubes, 0.0));
    world.add(cube, place_w, turned_wb, spin_w.cross(place_w), spin_w);
  }
  return world;
}

// The same four cubes in the air, thrown.
// velocity_w: [m/s] of the column's centre
// spin_w: [rad/s] of the column, about its centre
inline World column_in_flight(const Vec3& velocity_w, const Vec3& spin_w) {
  World world;
  const BodyProperties cube = box_properties(Vec3::Ones(), 1.0);
  const Quat turned_wb = rotation_from_vector(Vec3(0.3, -0.5, 0.7));
  for (int k = 0; k < kCubes; ++k) {
    const Vec3 place_w = turned_wb * Vec3(0.0, 0.5 + k - 0.5 * kCubes, 0.0);
    world.add(cube, place_w, turned_wb, velocity_w + spin_w.cross(place_w), spin_w);
  }
  return world;
}

// The sums over all movable bodies.
struct GroupMotion {
  double mass = 0.0;               // [kg]
  Vec3 centre_w = Vec3::Zero();    // [m] of mass
  Vec3 momentum_w = Vec3::Zero();  // [N s]
};

// Adds the bodies of a group up.
inline GroupMotion motion_of(const World& world) {
  GroupMotion sum;
  for (std::size_t k = 0; k < world.states().size(); ++k) {
    if (!world.bodies()[k].movable()) continue;
    sum.mass += world.bodies()[k].mass;
    sum.centre_w += world.bodies()[k].mass * world.states()[k].position_w;
    sum.momentum_w += world.states()[k].linear_momentum_w;
  }
  if (sum.mass == 0.0) throw std::invalid_argument("a group without a movable body");
  sum.centre_w /= sum.mass;
  return sum;
}

}  // namespace tumble::chapters
