/// \file
/// \brief Stable boxes that slide are damped, measured (thesis 5.4).
#pragma once

#include "driver/figure.hpp"

#include <vector>

namespace tumble::chapters {

/// The figure on stable boxes that slide, "claim_5_4d_sliding".
/// \return it
std::vector<Figure> sliding_figures();

/// Claim 5.4d: the upper box of figure 5.4 slides until it falls.
/// \param settings  offset, speed, slowest, speeds
/// \return tables "" (speed over time, and when it is stable), "speeds" (steps until a corner leaves
///         its support, and those that count) and "frames" (times of the drawings); drawings
///         "frame1" to "frame4"; the claim's number
/// \throws std::runtime_error if the box of the drawings does not fall
Result measure_sliding(const Parameters& settings);

}  // namespace tumble::chapters
