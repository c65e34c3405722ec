/// \file
/// \brief Error against work: each technique on motions with closed forms (thesis 6.3.2).
#pragma once

#include "driver/figure.hpp"

#include <array>
#include <vector>

namespace tumble::chapters {

/// The figure "claim_6_3_2a_work".
/// \return it
std::vector<Figure> work_against_error_figures();

/// The least work that each technique needs in each problem; infinity where no step gets there.
using LeastWork = std::vector<std::array<double, 3>>;

/// How many pairs of techniques change places between two problems.
///
/// A pair does if one needs less work in one problem, and the other in another. Who never gets there needs
/// more than whoever does, and two of that kind have no order.
/// \param work  by technique, at least two, and problem
/// \return [-] over all pairs
double share_that_changes_places(const LeastWork& work);

/// Claim 6.3.2a: whether a comparison on one scene would tell the order on another.
/// \param settings  finest, tolerance
/// \return tables "" (every run: error and work) and "least" (by technique and problem); the claim's
///         number, and errors and work of each technique
Result measure_work_against_error(const Parameters& settings);

}  // namespace tumble::chapters
