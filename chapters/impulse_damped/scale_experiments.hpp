/// \file
/// \brief The same motion at any size and mass, and Coulomb's stopping distance (thesis 6.3.1).
#pragma once

#include "driver/figure.hpp"

namespace tumble::chapters {

/// Claim 6.3.1a: whether the dimensionless motion depends on the size.
///
/// Lengths times s, masses times s³, times and the step times √s: with gravity alone to compare
/// with, the motion over s is the same.
/// \param settings  duration
/// \return tables "" (differences over time) and "path" (a sliding box); how far motions are apart
Result measure_size(const Parameters& settings);

}  // namespace tumble::chapters
