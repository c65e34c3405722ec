/// \file
/// \brief What each part of the damping does against chatter, and whom the alignment test misses
///        (thesis 5.3).
#pragma once

#include "driver/figure.hpp"

namespace tumble::chapters {

/// The parts of the damping, each left out, and each other set that is compared (claim 5.3b).
/// \param settings  per_edge, duration, seeds
/// \return table "" (chatter and time to rest of each set); the claim's number, with intervals, and
///         the same with thresholds and factors halved and doubled
Result measure_ablation(const Parameters& settings);

/// What the alignment test says of boxes that chatter, those on a face and those that lean (claim
/// 5.3e).
/// \param settings  per_edge, duration, seeds
/// \return table "" (tilt and shake of each box that chatters); the claim's number, with intervals,
///         and the same with thresholds and factors halved and doubled
Result measure_leaning(const Parameters& settings);

}  // namespace tumble::chapters
