/// \file
/// \brief Setups and helpers of the experiments with errata of the listings in appendix A.2.
#pragma once

#include "tumble/contact/contact.hpp"
#include "tumble/impulse_damped/as_printed/damped_as_printed.hpp"
#include "tumble/impulse_damped/as_printed/dampen_objects_as_printed.hpp"

#include "driver/experiment.hpp"
#include "driver/touching.hpp"

namespace tumble::chapters {

// Adds the two numbers of an erratum: with the text taken literally, everything else being mended, and
// with this one mended too.
template <class Measure>
void compare(Result& result, const std::string& what, const std::string& unit,
             const std::string& printed, const std::string& cured, const DampedErrata& mended,
             const Measure& measure) {
  const std::string id = what.substr(0, what.find(':'));
  result.add(what + printed, unit, measure(mended.without(id)));
  result.add(what + cured, unit, measure(mended));
}

// Adds a table of two paths.
inline void add_paths(Result& result, const std::string& suffix, const std::vector<Column>& columns,
                      double step, double scale, const std::vector<double>& printed,
                      const std::vector<double>& mended) {
  Table table{suffix, columns};
  for (std::size_t k = 0; k < mended.size(); ++k)
    table.add(step * static_cast<double>(k), scale * printed[k], scale * mended[k]);
  result.tables.push_back(table);
}

// The errata of the listings that as_meant mends.
[[nodiscard]] inline DampedErrata misprints() {
  return DampedErrata(
      "D2,D4,D5,D6,C1,C2,C3,C4,C5,C6,C7,C10,RK1,RK3,RC4,DM1,DM2,DM3,DM4,DM5,DM8,DM13,DM16,X1,X2,"
      "G1,G2,G3,G4,G5,G7,G8");
}

// Damped integration as printed, without any damping.
[[nodiscard]] inline DampedAsPrintedOptions undamped(const DampedErrata& repaired,
                                                     bool stable_boxes = true) {
  DampedAsPrintedOptions options{.repaired = repaired, .stable_boxes = stable_boxes};
  DampedNumbers& n = options.numbers;
  n.k1 = n.k2 = n.k3 = n.k5 = n.k7 = 1.0;
  n.eps2 = n.eps3 = n.eps4 = n.eps5 = n.eps6 = n.eps7 = n.eps8 = n.eps10 = n.eps11 = 0.0;
  n.eps9 = 1e-9;  // what a rounding lifts does not rise
  return options;
}

// A world with ground, without friction.
// restitution: [-] of the ground
[[nodiscard]] inline World ground_world(double restitution = 0.0) {
  World world;
  world.add_ground(0.0, restitution);
  return world;
}

// Adds a box of 1 kg without friction.
// size: [m] full edges
inline int add_box(World& world, const Vec3& size, const Vec3& position_w,
                   const Vec3& velocity_w = Vec3::Zero(), double restitution = 0.0) {
  world.add(box_properties(size, 1.0, 0.0, restitution), position_w, Quat::Identity(), velocity_w);
  return world.count() - 1;
}

// Adds a box that cannot move.
// size: [m] full edges
inline void add_fixed_box(World& world, const Vec3& size, const Vec3& position_w,
                          const Quat& orientation_wb = Quat::Identity()) {
  world.add(fixed_box_properties(size), position_w, orientation_wb);
}

// The ground and a cube of 1 m on it.
// velocity_w: [m/s] of the cube
[[nodiscard]] inline World cube_on_ground(const Vec3& velocity_w = Vec3::Zero()) {
  World world = ground_world();
  add_box(world, Vec3::Ones(), Vec3(0.0, 0.5, 0.0), velocity_w);
  return world;
}

// A world after some steps.
[[nodiscard]] inline World stepped(World world, Technique&& technique, int steps = 1,
                                   double dt = kStep) {
  for (int step = 0; step < steps; ++step) finished(technique.step(world, dt));
  return world;
}

// A rotation about the z axis.
// angle: [rad]
[[nodiscard]] inline Quat turned_about_z(double angle) {
  return Quat(std::cos(0.5 * angle), 0.0, 0.0, std::sin(0.5 * angle));
}

// A cube of 1 m and 1 kg: what the thesis's boxes all are.
[[nodiscard]] inline BodyProperties unit_cube() { return box_properties(Vec3::Ones(), 1.0); }

// The thresholds of that cube in a step, as the technique has them by default.
[[nodiscard]] inline DampedThresholds usual_thresholds() {
  return thresholds_of(DampedNumbers{}, unit_cube(), kGravity, kStep);
}

// A world with one cube.
// momentum_w: [kg m/s] world frame
// spin_w: [kg m²/s] angular momentum, world frame
[[nodiscard]] inline World world_with_cube(const Vec3& momentum_w,
                                           const Vec3& spin_w = Vec3::Zero()) {
  World world;
  BodyState state = make_state(unit_cube(), Vec3::Zero());
  state.linear_momentum_w = momentum_w;
  state.angular_momentum_w = spin_w;
  world.add(unit_cube(), state);
  return world;
}

// DAMPENOBJECTS on all bodies.
inline DampenReport dampen(World& world, bool touched, const PrintedNumbers& numbers,
                           const DampedErrata& mended = DampedErrata::all(), double dt = kStep) {
  const std::vector<std::uint8_t> flags(world.states().size(), touched ? 1 : 0);
  return dampen_objects_as_printed(world, flags, numbers, dt, RotationRule::splitting, mended);
}

// Line 3 of DAMPEDINTEGRATION: gravity of a step for all movable bodies.
inline void add_gravity(World& world) {
  for (std::size_t k = 0; k < world.states().size(); ++k)
    if (world.bodies()[k].movable())
      world.states()[k].linear_momentum_w += world.bodies()[k].mass * kStep * world.gravity_w;
}

// C1 to C11: one impulse and the gravity around it.
void add_collide_errata(Result& result);

// DM6, DM7, DM10, DM11, DM12, DM14: motion over many steps.
// k1: [-] what a step in contact leaves of momentum
// eps10: [m] a move in a step that is undone
void add_motion_errata(double k1, double eps10, Result& result);

// X1 to X6, DM17: pushes of bodies.
// duration: [s] for which pushes of a stack at rest are watched
void add_repair_errata(int cap, double duration, Result& result);

}  // namespace tumble::chapters
