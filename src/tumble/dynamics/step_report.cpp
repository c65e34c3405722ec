/// \file
/// \brief Sums over the reports of several steps.
#include "tumble/dynamics/step_report.hpp"

#include <algorithm>

namespace tumble {

void add_report(const StepReport& step, StepReport& total) {
  for (const ReportCount& count : kReportCounts) total.*count.member += step.*count.member;
  total.deepest_overlap = std::max(total.deepest_overlap, step.deepest_overlap);
  total.status = std::max(total.status, step.status);
  total.energy.restitution += step.energy.restitution;
  total.energy.friction += step.energy.friction;
  total.energy.damping += step.energy.damping;
  total.energy.repair += step.energy.repair;
}

}  // namespace tumble
