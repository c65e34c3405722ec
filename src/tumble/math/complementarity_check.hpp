/// \file
/// \brief Mistakes in a complementarity problem, as far as they show before it is solved.
#pragma once

#include "tumble/math/dense.hpp"

namespace tumble {

/// Refuses a problem whose parts do not fit.
/// \throws std::invalid_argument if A is not square, or b has another length
void require_sizes(const MatRef& A, const VecRef& b);

/// Refuses mistakes, and looks for what no positive semidefinite matrix has.
/// \return whether the principal minors of one and two rows allow A to be positive semidefinite:
///         \f$A_{ii} \ge 0\f$ and \f$A_{ij}^2 \le A_{ii} A_{jj}\f$
/// \throws std::invalid_argument if sizes differ, a number is not finite, or A is asymmetric by more
///         than `tolerance::symmetry`
bool may_be_semidefinite(const MatRef& A, const VecRef& b);

}  // namespace tumble
