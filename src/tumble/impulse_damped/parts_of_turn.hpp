/// \file
/// \brief Steps in which a body turns far are divided.
///
/// Uses no other chapter.
#pragma once

#include "tumble/base/error.hpp"
#include "tumble/dynamics/step_report.hpp"
#include "tumble/dynamics/world.hpp"
#include "tumble/impulse_damped/tolerances.hpp"

#include <algorithm>
#include <cmath>

namespace tumble {

/// Into how many equal parts a step is divided, so that no body turns by more than `tolerance::turn_of_part` in one:
/// contacts are looked for at the end of a part only, and a body that turns past them is never stopped.
/// \param world  the bodies at the start of the step
/// \param dt     [s] of the step
/// \return from 1 to `tolerance::most_parts_of_turn`
[[nodiscard]] inline int parts_of_turn(const World& world, double dt) {
  double turn = 0.0;  // [rad] of the body that turns fastest
  for (std::size_t k = 0; k < world.bodies().size(); ++k)
    if (world.bodies()[k].movable())
      turn = std::max(turn, dt * angular_velocity(world.bodies()[k], world.states()[k]).norm());
  const double parts = std::ceil(turn / tolerance::turn_of_part);
  return static_cast<int>(
      std::clamp(parts, 1.0, static_cast<double>(tolerance::most_parts_of_turn)));
}

/// A step that is divided so.
/// \param world      in and out; its clock goes on by one step
/// \param dt         [s] above 0
/// \param step_part  called with the length of a part [s] and its number from 0; returns what was done
/// \return all that was done, with the contacts of the last part
template <class StepPart>
StepReport step_in_parts(World& world, double dt, const StepPart& step_part) {
  require::positive(dt, "dt");
  StepReport report;
  const int parts = parts_of_turn(world, dt);
  for (int k = 0; k < parts; ++k) {
    const StepReport done = step_part(dt / parts, k);
    add_report(done, report);
    report.contacts = done.contacts;
  }
  world.finish_step(dt);
  return report;
}

}  // namespace tumble
