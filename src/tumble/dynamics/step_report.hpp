/// \file
/// \brief Adding up what several steps did.
#pragma once

#include "tumble/dynamics/technique.hpp"

#include <array>

namespace tumble {

/// Every count of a report.
inline constexpr std::array<std::int64_t StepReport::*, 11> kReportCounts = {
    &StepReport::events,       &StepReport::contacts, &StepReport::iterations,
    &StepReport::pivots,       &StepReport::impulses, &StepReport::pair_tests,
    &StepReport::integrations, &StepReport::searches, &StepReport::rewinds,
    &StepReport::restarts,     &StepReport::fallbacks};

/// Adds a step to those before it: counts and energies are summed, `contacts` too; the deepest overlap
/// and the worst status are kept.
/// \param step   what one step did
/// \param total  what all of them did; in and out
void add_report(const StepReport& step, StepReport& total);

}  // namespace tumble
