/// \file
/// \brief The order of two impacts that are nearer in time than the tolerance of the search (thesis
///        5.1).
#pragma once

#include "driver/figure.hpp"

#include <vector>

namespace tumble::chapters {

/// The figure on impacts at nearly the same time: "claim_5_1c_ties".
/// \return it
std::vector<Figure> tie_figures();

/// Claim 5.1c: how often two impacts on one cube come out in the wrong order.
///
/// The time between them is even from 0 to one and a half times the tolerance; half of the cubes
/// turn.
/// \param settings  trials, resolution
/// \return table "" (by the time between the impacts: shares in the wrong order with intervals, and
///         share resolved at one stroke) and "bisection" (what is to be expected of it in closed
///         form); the claim's number
Result measure_ties(const Parameters& settings);

}  // namespace tumble::chapters
