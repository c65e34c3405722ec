/// \file
/// \brief Where section 6.2 says too much: one force and one torque, and boxes that stay together
///        (errata P15 and P15b).
#pragma once

#include "driver/figure.hpp"

#include <vector>

namespace tumble::chapters {

/// The figure "errata_exterior_rotation".
/// \return it
std::vector<Figure> rotation_errata_figures();

/// Errata P15 and P15b: one step with one force and torque, and what glue has to pull.
/// \param settings  speed, rate, angle, duration, turns
/// \return tables "" (by the turn in a step: gap of the column for each way of moving it) and "pull" (by
///         time: what a joint of the falling column has to pull with); the numbers of the errata
Result measure_rotation_errata(const Parameters& settings);

}  // namespace tumble::chapters
