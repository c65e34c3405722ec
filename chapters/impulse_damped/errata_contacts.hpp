/// \file
/// \brief The parts of measure_contact_errata(): the errata of three listings, each with two
///        numbers.
#pragma once

#include "tumble/impulse_damped/as_printed/damped_as_printed.hpp"

#include "driver/figure.hpp"

#include <string>
#include <vector>

namespace tumble::chapters {

/// One erratum in the figure: what the text gives, and what the reading gives that mends it.
struct ErratumPair {
  std::string failure_name;  ///< of the quantity; begins with the erratum's id
  std::string mended_name;   ///< ditto
  std::string unit;          ///< of both numbers
  double failure = 0.0;      ///< with the text taken literally
  double mended = 0.0;       ///< under the other reading
};

/// D1 to D6: the order of a step and what is handed on in it.
/// \param pairs gets one entry for each, in their order
void add_step_errata(std::vector<ErratumPair>& pairs);

/// C1 to C11: one impulse and the gravity around it.
/// \param pairs gets one entry for each, in their order
void add_collide_errata(std::vector<ErratumPair>& pairs);

/// RK1 to RK4 and RC1 to RC4: the passes over all pairs.
/// \param seconds  [s] for which the stack of RK4 is watched after as long a time to settle
/// \param pairs    gets one entry for each, in their order
void add_pass_errata(double seconds, std::vector<ErratumPair>& pairs);

/// The errata of the listings that as_meant mends.
/// \return all misprints; no choice, and not the order of section 5.2 (D1)
[[nodiscard]] DampedErrata misprints();

/// Damped integration as printed, without any damping: nobody is slowed down, turned upright or
/// held.
/// \param repaired  errata that are mended
/// \return options with all k = 1 and all ε = 0, but for ε1 and a trace of ε9
[[nodiscard]] DampedAsPrintedOptions undamped(const DampedErrata& repaired);

/// A world with ground, without friction.
/// \param restitution [-] of the ground
/// \return nothing else in it
[[nodiscard]] World ground_world(double restitution = 0.0);

/// Adds a box without friction.
/// \param world         gets it
/// \param size          [m] full edges
/// \param position_w    [m] its centre
/// \param velocity_w    [m/s]
/// \param restitution   [-]
/// \return its index
int add_box(World& world, const Vec3& size, const Vec3& position_w,
            const Vec3& velocity_w = Vec3::Zero(), double restitution = 0.0);

/// The velocity of a body.
/// \param world  the bodies
/// \param index  which
/// \return [m/s]
[[nodiscard]] Vec3 velocity_of(const World& world, int index);

/// Steps a world.
/// \param technique  how
/// \param world      in and out
/// \param dt         [s] of a step
/// \param steps      how many
void run_steps(Technique& technique, World& world, double dt, int steps);

}  // namespace tumble::chapters
