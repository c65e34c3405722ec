/// \file
/// \brief Four corners against the hull of the supports (thesis 5.4, its footnote).
#pragma once

#include "driver/figure.hpp"

namespace tumble::chapters {

/// Claim 5.4c: bodies on which the rule of the text and that of the footnote differ, and which is right.
/// \param settings  piles, trials
/// \return table "" (a row for each kind of body); drawings "plan1" to "plan4" (one of each of four kinds);
///         the claim's number
/// \throws std::runtime_error if there is nothing to draw, or a problem of contact forces has no
///         answer
Result measure_hull(const Parameters& settings);

}  // namespace tumble::chapters
