/// \file
/// \brief Steps of experiments have to finish.
#pragma once

#include "tumble/record/run.hpp"

#include <stdexcept>
#include <string>

namespace tumble::chapters {

// The report of a step of an experiment, which has to be done: the rest is no measurement. An experiment that
// measures how steps end reads their status itself, and shows how many did not finish.
// Throws std::runtime_error naming the status.
inline const StepReport& finished(const StepReport& report) {
  if (report.status != StepStatus::done)
    throw std::runtime_error("a step of this experiment ended as " +
                             std::string(name_of(report.status)));
  return report;
}

}  // namespace tumble::chapters
