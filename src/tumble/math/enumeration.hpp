/// \file
/// \brief Complementarity by trying everything: the answer that others are compared with.
#pragma once

#include "tumble/math/complementarity.hpp"

namespace tumble {

/// Most unknowns that solve_by_enumeration() takes.
inline constexpr int enumeration_limit = 8;

/// Finds f >= 0 with a = A f + b >= 0 and f·a = 0 by trying every case, for any square A.
///
/// If there is a solution, there is one whose forces f_F > 0 are determined by the rows Z ⊇ F with
/// a_Z = 0, that is, the columns of A(Z, F) are independent (a corner of the set of solutions). So
/// all pairs F ⊆ Z are tried, 3ⁿ of them, and A(Z, F) f_F = -b_Z is solved by an orthogonal factor
/// that reveals the rank. Slow, without cleverness, and never wrong but for rounding.
/// \param A (n×n) any matrix, n up to `enumeration_limit`
/// \param b (n) the constant part
/// \return status `solved` or `infeasible` (f = 0, a = b, no ray), f, a, residual; `pivots` counts
///         the cases tried. Of several solutions the first in the order of trial is returned
/// \throws std::invalid_argument if sizes differ, n is too large, or a number is not finite
ComplementarityResult solve_by_enumeration(const MatRef& A, const VecRef& b);

}  // namespace tumble
