/// \file
/// \brief How much chatter each technique leaves, and how much of it is left in the settled clump
///        (thesis 5.5, 6.1).
#pragma once

#include "driver/figure.hpp"

#include <vector>

namespace tumble::chapters {

/// The figures "chatter_table" and "claim_6_1b_chatter".
/// \return them
std::vector<Figure> technique_chatter_figures();

/// Chatter of every technique on a stack, a pyramid and two clumps, with ranks.
///
/// A run's amplitude is that of the body with the largest. A scene is ranked by the medians over
/// seeds; who fell, or never rested, has no rank.
/// \param settings  seeds, others, boxes, rows, small, large, scatter, scatter_angle, settling, flying, watched,
///                  patient
/// \return tables "" (by technique and scene), "seeds" (every run), "without" (techniques without
///         resting contact, on the stack) and "bar" (the colours)
Result tabulate_chatter(const Parameters& settings);

/// Claim 6.1b: who of the settled clump chatters under the method of the thesis.
/// \param settings  seeds, varied, per_edge, settling, watched
/// \return tables "" (amplitudes of all bodies that rest, sorted), "shares" (by variant of the
///         constants) and "still" (bodies that do not move); the claim's number
Result measure_left_chatter(const Parameters& settings);

}  // namespace tumble::chapters
