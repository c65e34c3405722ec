/// \file
/// \brief What it saves to leave stable boxes out of the contact forces, and by which right (thesis
///        5.4).
#pragma once

#include "driver/figure.hpp"

#include <vector>

namespace tumble::chapters {

/// The figures on stable boxes that are left out: "fig5_6_pyramid", "claim_5_4b_excluded" and
/// "stable_share_of_gain".
/// \return with their parameters, their defaults, and the functions that compute them
std::vector<Figure> excluded_figures();

/// Figure 5.6: who is stable in a pyramid without its bottom centre box, and how many forces are
/// unknown, with a gap between neighbours and without.
/// \param settings  rows, gap
/// \return tables "" (a row for each box of both pyramids) and "unknowns" (a row for each pyramid);
///         counts of boxes and unknowns
/// \throws std::invalid_argument for an even number of rows
Result measure_stable_pyramid(const Parameters& settings);

/// Claim 5.4b: unknowns, pivots and multiplications with all boxes and without the stable ones.
/// \param settings  rows, largest, gap, shuffled_rows, knocked_rows, knock, seeds, steps
/// \return tables "" (a row for each size) and "run" (a row for each step of three runs); the claim's
///         number and others
/// \throws std::invalid_argument for an even number of rows
Result measure_excluded(const Parameters& settings);

/// How much of what the listing saves as printed is saved by right.
/// \param settings  seeds, tilted, knocks
/// \return table "" (a row for each kind of pile and way to read the listing); shares
Result measure_share_of_gain(const Parameters& settings);

}  // namespace tumble::chapters
