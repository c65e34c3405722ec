/// \file
/// \brief Steps of experiments have to finish.
#pragma once

#include "tumble/record/run.hpp"

#include <stdexcept>
#include <string>

namespace tumble::chapters {

// The report of a step of an experiment, which has to be done: the rest is no measurement.
// Throws std::runtime_error naming the status.
inline const StepReport& finished(const StepReport& report) {
  if (report.status != StepStatus::done)
    throw std::runtime_error("a step of this experiment ended as " +
                             std::string(name_of(report.status)));
  return report;
}

// The same where a step may end at its cap on events, and the experiment counts and shows those that do.
// Returns whether this one did.
inline bool ended_at_cap(const StepReport& report) {
  if (report.status == StepStatus::event_cap) return true;
  finished(report);
  return false;
}

}  // namespace tumble::chapters
