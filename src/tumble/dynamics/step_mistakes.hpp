/// \file
/// \brief Exceptions of a step: a caller's mistake, and a check inside that failed.
#pragma once

#include <stdexcept>
#include <string_view>

namespace tumble {

/// A technique does not simulate this world, or not in a step of this length: the caller's mistake, with what would be right.
class StepRefused : public std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};

/// A part of a step refused what another part handed to it, for example a state that had become infinite: no mistake
/// of the caller's. The bodies may have moved.
class StepFault : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Refuses a step.
/// \param message  the value and what would be right, for example "stiffness = 1e9: expected below 2e6"
/// \throws StepRefused with the message
[[noreturn]] void refuse_step(std::string_view message);

/// Refuses a step that is no step, or too long for the resolution of times in it.
/// \param dt          [s] the longest flight, above 0
/// \param resolution  [s] above the rounding of times up to dt
/// \throws std::invalid_argument for a dt that is not finite and above 0; StepRefused naming the resolution
void require_resolved(double dt, double resolution);

}  // namespace tumble
