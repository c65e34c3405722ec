/// \file
/// \brief Boxes that turn about a point outside them come apart (thesis 6.2, claim 6.2a).
#pragma once

#include "driver/figure.hpp"

namespace tumble::chapters {

/// A column, or one box, falls over the edge of a larger one under several schemes.
/// \param settings  boxes, angle, rate, duration, t1 to t4, magnification
/// \return frames with insets; gaps over time; gaps made by single steps from exact states
Result measure_fall(const Parameters& settings);

/// A box turns on a box that turns, centres and orientations moved apart and together.
/// \param settings  rate, duration, t1 to t4, magnification
/// \return frames with insets; how far both joints come apart over time
Result measure_nested(const Parameters& settings);

/// The column turns, and is pushed along without turning.
/// \param settings  angle, rate, duration, push, sizes
/// \return gaps of both over time; gaps made by single steps against their length
Result measure_turning(const Parameters& settings);

}  // namespace tumble::chapters
