/// \file
/// \brief Setups and helpers of the experiments with errata of the listings in appendix A.2.
#pragma once

#include "tumble/contact/contact.hpp"
#include "tumble/impulse_damped/as_printed/damped_as_printed.hpp"
#include "tumble/impulse_damped/as_printed/dampen_objects_as_printed.hpp"

#include "driver/experiment.hpp"

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
void add_paths(Result& result, const std::string& suffix, const std::vector<Column>& columns,
               double step, double scale, const std::vector<double>& printed,
               const std::vector<double>& mended);

// The errata of the listings that as_meant mends.
[[nodiscard]] DampedErrata misprints();

// Damped integration as printed, without any damping.
[[nodiscard]] DampedAsPrintedOptions undamped(const DampedErrata& repaired,
                                              bool stable_boxes = true);

// A world with ground, without friction.
// restitution: [-] of the ground
[[nodiscard]] World ground_world(double restitution = 0.0);

// Adds a box of 1 kg without friction.
// size: [m] full edges
// position_w: [m] its centre
// velocity_w: [m/s]
// restitution: [-]
int add_box(World& world, const Vec3& size, const Vec3& position_w,
            const Vec3& velocity_w = Vec3::Zero(), double restitution = 0.0);

// Adds a box that cannot move.
// size: [m] full edges
// position_w: [m] its centre
void add_fixed_box(World& world, const Vec3& size, const Vec3& position_w,
                   const Quat& orientation_wb = Quat::Identity());

// The ground and a cube of 1 m on it.
// velocity_w: [m/s] of the cube
[[nodiscard]] World cube_on_ground(const Vec3& velocity_w = Vec3::Zero());

// The velocity of a body.
// Returns [m/s]
[[nodiscard]] Vec3 velocity_of(const World& world, int index);

// A world after some steps.
// dt: [s] of a step
[[nodiscard]] World stepped(World world, Technique&& technique, int steps = 1, double dt = kStep);

// All pairs of bodies.
[[nodiscard]] std::vector<IndexPair> all_pairs(const World& world);

// Contacts of all pairs.
// margin: [m] up to which distance two of them touch
[[nodiscard]] ContactList contacts_of(const World& world, double margin);

// A rotation about the z axis.
// angle: [rad]
[[nodiscard]] Quat turned_about_z(double angle);

// A cube of 1 m and 1 kg: what the thesis's boxes all are.
[[nodiscard]] BodyProperties unit_cube();

// The thresholds of that cube in a step, as the technique has them by default.
[[nodiscard]] DampedThresholds usual_thresholds();

// A world with one cube.
// momentum_w: [kg m/s] world frame
// spin_w: [kg m²/s] angular momentum, world frame
[[nodiscard]] World world_with_cube(const Vec3& momentum_w, const Vec3& spin_w = Vec3::Zero());

// DAMPENOBJECTS on all bodies.
// dt: [s] the step
DampenReport dampen(World& world, bool touched, const PrintedNumbers& numbers,
                    const DampedErrata& mended = DampedErrata::all(), double dt = kStep);

// Line 3 of DAMPEDINTEGRATION: gravity of a step for all movable bodies.
void add_gravity(World& world);

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
