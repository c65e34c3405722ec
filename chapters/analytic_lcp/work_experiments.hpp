/// \file
/// \brief What contact solvers have to do, counted, against the number of contacts (thesis 3.3.1).
#pragma once

#include "driver/figure.hpp"

#include <vector>

namespace tumble::chapters {

/// Multiplications of all solvers on pyramids of cubes (thesis 3.3.1).
/// \param settings  noise, seed, limit, largest, largest_printed
/// \return tables "" (at rest) and "noisy": a row for each size, a column for each solver; "failed": a row
///         for each problem that a solver did not solve; residuals, counts and growth of the fastest solver
Result measure_work(const Parameters& settings);

/// Adds the figure of the solvers' work.
/// \param figures  gets it
void add_work_figures(std::vector<Figure>& figures);

}  // namespace tumble::chapters
