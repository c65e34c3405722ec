/// \file
/// \brief Sums over the reports of several steps.
#pragma once

#include "tumble/dynamics/technique.hpp"

#include <algorithm>
#include <array>

namespace tumble {

/// A count of a report and its name in files.
struct ReportCount {
  std::string_view name;             ///< as in summary.json
  std::int64_t StepReport::*member;  ///< where the report has it
};

/// Every count of a report.
inline constexpr std::array<ReportCount, 11> kReportCounts = {
    {{"collisions", &StepReport::events},
     {"contacts", &StepReport::contacts},
     {"iterations", &StepReport::iterations},
     {"pivots", &StepReport::pivots},
     {"impulses", &StepReport::impulses},
     {"pair_tests", &StepReport::pair_tests},
     {"integrations", &StepReport::integrations},
     {"searches", &StepReport::searches},
     {"rewinds", &StepReport::rewinds},
     {"restarts", &StepReport::restarts},
     {"fallbacks", &StepReport::fallbacks}}};

/// Adds a step to those before it: counts and energies are summed, `contacts` too; the deepest overlap
/// and the worst status are kept.
/// \param total  sum of all; in and out
inline void add_report(const StepReport& step, StepReport& total) {
  for (const ReportCount& count : kReportCounts) total.*count.member += step.*count.member;
  total.deepest_overlap = std::max(total.deepest_overlap, step.deepest_overlap);
  total.status = std::max(total.status, step.status);
  total.energy.restitution += step.energy.restitution;
  total.energy.friction += step.energy.friction;
  total.energy.damping += step.energy.damping;
  total.energy.repair += step.energy.repair;
}

}  // namespace tumble
