/// \file
/// \brief Setups and helpers of the experiments with errata of the listings in appendix A.2.
#pragma once

#include "tumble/contact/contact.hpp"
#include "tumble/impulse_damped/as_printed/damped_as_printed.hpp"
#include "tumble/impulse_damped/as_printed/dampen_objects_as_printed.hpp"

#include "driver/common_numbers.hpp"
#include "driver/figure.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace tumble::chapters {

/// Adds one number of an erratum.
/// \param result  gets it
/// \param name    begins with the erratum's id
/// \param unit    "-" for none
/// \param value   in that unit
inline void add(Result& result, const std::string& name, const std::string& unit, double value) {
  result.quantities.push_back({name, unit, value});
}

/// Adds the two numbers of an erratum: with the text taken literally, everything else being mended, and
/// with this one mended too.
/// \param result   gets them
/// \param what     the part that both names share; begins with the erratum's id and a colon
/// \param unit     of both
/// \param printed  end of the first name
/// \param cured    end of the second name
/// \param mended   errata that are mended in the second
/// \param measure  gives the number for a set of mended errata
template <class Measure>
void compare(Result& result, const std::string& what, const std::string& unit,
             const std::string& printed, const std::string& cured, const DampedErrata& mended,
             const Measure& measure) {
  const std::string id = what.substr(0, what.find(':'));
  add(result, what + printed, unit, measure(mended.without(id)));
  add(result, what + cured, unit, measure(mended));
}

/// Adds a table of two paths.
/// \param result   gets it
/// \param suffix   of the table
/// \param columns  of time or step, of the listing as printed, and mended
/// \param step     what a row adds to the first column
/// \param scale    of both paths
/// \param printed  by step
/// \param mended   by step; as many rows are added
void add_paths(Result& result, const std::string& suffix, const std::vector<Column>& columns,
               double step, double scale, const std::vector<double>& printed,
               const std::vector<double>& mended);

/// The errata of the listings that as_meant mends.
/// \return all misprints; no choice, and not the order of section 5.2 (D1)
[[nodiscard]] DampedErrata misprints();

/// Damped integration as printed, without any damping.
/// \param repaired      errata that are mended
/// \param stable_boxes  whether boxes are found to be geometrically stable
/// \return options with all k = 1 and all ε = 0, but for ε1 and a trace of ε9
[[nodiscard]] DampedAsPrintedOptions undamped(const DampedErrata& repaired,
                                              bool stable_boxes = true);

/// A world with ground, without friction.
/// \param restitution [-] of the ground
/// \return nothing else in it
[[nodiscard]] World ground_world(double restitution = 0.0);

/// Adds a box of 1 kg without friction.
/// \param world         gets it
/// \param size          [m] full edges
/// \param position_w    [m] its centre
/// \param velocity_w    [m/s]
/// \param restitution   [-]
/// \return its index
int add_box(World& world, const Vec3& size, const Vec3& position_w,
            const Vec3& velocity_w = Vec3::Zero(), double restitution = 0.0);

/// Adds a box that cannot move.
/// \param world           gets it
/// \param size            [m] full edges
/// \param position_w      [m] its centre
/// \param orientation_wb  body to world
void add_fixed_box(World& world, const Vec3& size, const Vec3& position_w,
                   const Quat& orientation_wb = Quat::Identity());

/// The ground and a cube of 1 m on it.
/// \param velocity_w [m/s] of the cube
/// \return the cube has index 1
[[nodiscard]] World cube_on_ground(const Vec3& velocity_w = Vec3::Zero());

/// The velocity of a body.
/// \param world  the bodies
/// \param index  which
/// \return [m/s]
[[nodiscard]] Vec3 velocity_of(const World& world, int index);

/// A world after some steps.
/// \param world      at the start
/// \param technique  of the steps
/// \param steps      how many
/// \param dt         [s] of a step
/// \return at the end
[[nodiscard]] World stepped(World world, Technique&& technique, int steps = 1, double dt = kStep);

/// All pairs of bodies.
/// \param world  the bodies
/// \return the lower index first
[[nodiscard]] std::vector<IndexPair> all_pairs(const World& world);

/// Contacts of all pairs.
/// \param world   the bodies
/// \param margin  [m] up to which distance two of them touch
/// \return as gather_contacts() gives them
[[nodiscard]] ContactList contacts_of(const World& world, double margin);

/// A rotation about the z axis.
/// \param angle [rad]
/// \return body to world
[[nodiscard]] Quat turned_about_z(double angle);

/// A cube of 1 m and 1 kg: what the thesis's boxes all are.
/// \return its properties
[[nodiscard]] BodyProperties unit_cube();

/// The thresholds of that cube in a step, as the technique has them by default.
/// \return in SI units
[[nodiscard]] DampedThresholds usual_thresholds();

/// A world with one cube.
/// \param momentum_w  [kg m/s] world frame
/// \param spin_w      [kg m²/s] angular momentum, world frame
/// \return the world; the cube has index 0
[[nodiscard]] World world_with_cube(const Vec3& momentum_w, const Vec3& spin_w = Vec3::Zero());

/// DAMPENOBJECTS on all bodies.
/// \param world    in and out
/// \param touched  whether each body has had a contact
/// \param numbers  ε and k; as made, all ε are 0 and all k are 1, so that only those that are set act
/// \param mended   errata
/// \param dt       [s] the step
/// \return what it reports
DampenReport dampen(World& world, bool touched, const PrintedNumbers& numbers,
                    const DampedErrata& mended = DampedErrata::all(), double dt = kStep);

/// Line 3 of DAMPEDINTEGRATION: gravity of a step for all movable bodies.
/// \param world  in and out
void add_gravity(World& world);

/// C1 to C11: one impulse and the gravity around it.
/// \param result  gets the two numbers of each, in their order
void add_collide_errata(Result& result);

/// DM6, DM7, DM10, DM11, DM12, DM14: motion over many steps.
/// \param k1      [-] what a step in contact leaves of momentum
/// \param eps10   [m] a move in a step that is undone
/// \param result  gets tables "fall", "path", "wall", "apex", "tilt" and the numbers
void add_motion_errata(double k1, double eps10, Result& result);

/// X1 to X6, DM17: pushes of bodies.
/// \param cap       pushes after which a loop that does not end is left
/// \param duration  [s] for which pushes of a stack at rest are watched
/// \param result    gets tables "gap" and "stack" and the numbers
/// \throws std::runtime_error if a step of the stack does not end as it should
void add_repair_errata(int cap, double duration, Result& result);

}  // namespace tumble::chapters
