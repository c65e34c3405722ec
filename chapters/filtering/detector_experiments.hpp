/// \file
/// \brief Chatter told from earlier frames, and what freezing it is good for (thesis 6.3.1, 4.5).
#pragma once

#include "driver/figure.hpp"

#include <vector>

namespace tumble::chapters {

/// The figures on the detector: "claim_6_3_1c_detector" and "freezing_clump".
/// \return them
std::vector<Figure> detector_figures();

/// Claim 6.3.1c: chatter that is told, and what moves that is not, over a corpus with labels.
/// \param settings  seeds, first_seed, per_edge, boxes
/// \return tables "" (hits and false alarms of the rule over its threshold), "path" and "speed" (of two
///         other rules), "points" (all rules at their standard numbers), "kinds" (by kind of motion) and
///         "windows" (by the length of the window); the claim's number
Result measure_detector(const Parameters& settings);

/// What sleeps in a settled clump under `damped`, and what it costs, until a cube hits it.
/// \param settings  seeds, per_edge, settling, watched, speed
/// \return table "" (of the first seed, by time: bodies awake, bodies that chatter, pair tests, for
///         no sleeping, sleeping, and freezing); work, chatter and waking over all seeds
Result measure_freezing(const Parameters& settings);

}  // namespace tumble::chapters
