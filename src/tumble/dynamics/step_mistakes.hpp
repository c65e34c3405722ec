/// \file
/// \brief Exceptions of a step: refused as the caller's mistake, or broken off by a check inside.
#pragma once

#include <stdexcept>
#include <string_view>

namespace tumble {

/// A technique does not simulate this world, or not in a step of this length: the caller's mistake. The message has the
/// value and the expected one.
class StepRefused : public std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};

/// A check inside a step failed, for example since a state had become infinite. It is not the caller's mistake, and
/// bodies may have moved.
class StepFault : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Refuses a step.
/// \param message  the value and what would be right, for example "stiffness = 1e9: expected below 2e6"
/// \throws StepRefused with the message
[[noreturn]] void refuse_step(std::string_view message);

/// Refuses the length of a step.
/// \param dt    [s] from tolerance::shortest_step to longest_step
/// \param time  [s] when the step begins; has to be resolved to tolerance::step_share of dt
/// \throws std::invalid_argument naming the value, the limit and the remedy
void require_step_limits(double dt, double time);

/// Refuses a step that is too long for the resolution of event times.
/// \param resolution  [s] of event times; has to be above the rounding of times up to dt
/// \throws std::invalid_argument for a dt that is not finite and above 0; StepRefused naming the resolution
void require_resolved(double dt, double resolution);

}  // namespace tumble
