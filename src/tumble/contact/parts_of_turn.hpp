/// \file
/// \brief Steps in which a body turns far are divided (thesis 3.1).
#pragma once

#include "tumble/base/error.hpp"
#include "tumble/dynamics/flight.hpp"
#include "tumble/dynamics/step_report.hpp"
#include "tumble/dynamics/world.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tumble {

/// [rad] A body that turns further in a step makes the step be divided. Reason: above it a body does not keep its energy in
/// flight, contacts are found where they no longer are, and a rod that spins on the ground never comes to rest. (3.1)
inline constexpr double kTurnOfPart = 1.0;

/// [-] Parts of a step, at most. Reason: a body that turns 160 times in a step is one that nothing follows. (3.1)
inline constexpr double kMostPartsOfTurn = 1000.0;

/// [rad] Beyond it a step is not divided. Reason: a thousandth of such a step would still be 160 turns. (3.1)
inline constexpr double kTurnBeyondParts = 1e6;

/// Into how many equal parts a step is divided in which a body turns far.
/// \param turn     [rad] in the step
/// \param at_once  [rad] by which it may turn in a part, above 0
/// \return from 1 to kMostPartsOfTurn; 1 for a turn above kTurnBeyondParts, and for one that is not a number
[[nodiscard]] inline int parts_of_turn(double turn, double at_once = kTurnOfPart) {
  if (!(turn > at_once && turn <= kTurnBeyondParts)) return 1;
  return static_cast<int>(std::min(std::ceil(turn / at_once), kMostPartsOfTurn));
}

/// The same for the body of a world that turns fastest.
[[nodiscard]] inline int parts_of_turn(const World& world, double dt) {
  double turn = 0.0;
  for (std::size_t k = 0; k < world.bodies().size(); ++k)
    if (world.bodies()[k].movable())
      turn = std::max(turn, dt * angular_velocity(world.bodies()[k], world.states()[k]).norm());
  return parts_of_turn(turn);
}

/// How long a body flies in one go if it turns far in a step but keeps its momenta: so long that it turns by a radian. A rule
/// of rotation keeps the energy of such turns.
/// \return [s] infinite for what turns by less, evenly, or by more than kMostPartsOfTurn radians
[[nodiscard]] inline double micro_step_of(const BodyProperties& body, const BodyState& state,
                                          RotationRule rule, double dt) {
  constexpr double in_one_go = std::numeric_limits<double>::infinity();
  if (turns_evenly(body, state, rule)) return in_one_go;
  const double turn = dt * angular_velocity(body, state).norm();
  return turn > kTurnOfPart && turn <= kMostPartsOfTurn ? dt / parts_of_turn(turn) : in_one_go;
}

/// A step that is divided so.
/// \param world      in and out; its clock goes on by one step
/// \param step_part  called with the world, the length of a part [s] and its number from 0; returns what was done. It leaves
///                   the clock alone unless it ends as StepStatus::unsolved: then it counts the step, with the time that has
///                   passed
/// \return all that was done, with the contacts of the last part
template <class StepPart>
StepReport step_in_parts(World& world, double dt, const StepPart& step_part) {
  require::positive(dt, "dt");
  const int parts = parts_of_turn(world, dt);
  if (parts == 1) {
    const StepReport report = step_part(world, dt, 0);
    if (report.status < StepStatus::unsolved) world.finish_step(dt);
    return report;
  }
  StepReport report;
  World copy = world;  // its clock goes on part by part
  for (int k = 0; k < parts && report.status < StepStatus::unsolved; ++k) {
    const StepReport done = step_part(copy, dt / parts, k);
    add_report(done, report);
    report.contacts = done.contacts;
    if (report.status < StepStatus::unsolved) copy.finish_step(dt / parts);
  }
  std::copy(copy.states().begin(), copy.states().end(), world.states().begin());
  std::copy(copy.sleep_states().begin(), copy.sleep_states().end(), world.sleep_states().begin());
  world.finish_step(report.status < StepStatus::unsolved ? dt : copy.time() - world.time());
  return report;
}

}  // namespace tumble
