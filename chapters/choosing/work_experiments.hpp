/// \file
/// \brief Error against work: each technique on motions with closed forms (thesis 6.3.2).
#pragma once

#include "driver/experiment.hpp"

namespace tumble::chapters {

// The least work that each technique needs in each problem; infinity where no step gets there.
using LeastWork = std::vector<std::array<double, 3>>;

// How many pairs of techniques change places between two problems.
//
// A pair does if one needs less work in one problem, and the other in another. A technique that never gets
// there needs more than one that does, and two of that kind have no order.
// Returns [-] over all pairs
double share_that_changes_places(const LeastWork& work);

}  // namespace tumble::chapters
