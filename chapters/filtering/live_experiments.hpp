/// \file
/// \brief Filters that run live: the same frames, and how late they are seen (thesis 5.5).
#pragma once

#include "driver/figure.hpp"

#include <vector>

namespace tumble::chapters {

/// The figure on filtering live: "claim_5_5e_live".
/// \return it
std::vector<Figure> live_figures();

/// Claim 5.5e: whether frames that are filtered live are those that are filtered afterwards, and by
/// how much a viewer sees them late.
///
/// Two runs, with bodies that settle and bodies that come and go, are filtered frame by frame while
/// they are computed, in pieces of random lengths, and afterwards; all bits are compared. Delays are
/// those of a body that creeps, of one that is fast, and of a cube that lands.
/// \param settings  cubes, duration, pieces, height, creep, fast, near
/// \return tables "" (by filter: frames held back, stored, needed; delays; bits), "landing" (by frame:
///         height of a falling cube, computed and seen) and "creep" (by frame: place of a creeping body);
///         the claim's number
Result measure_live(const Parameters& settings);

}  // namespace tumble::chapters
