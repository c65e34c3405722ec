/// \file
/// \brief The judge of answers: each row by what the problem's loads make of it.
#pragma once

#include "tumble/lcp_solvers/lcp.hpp"

namespace tumble {

/// What a force counts for in its own row.
/// \return [1/kg] A_ii, or where that cannot be a measure, as in rows of friction, the largest |A_ij| of the row, or 1
///         if all are 0
double row_yield(const MatX& A, int row);

/// Residual of the worst row, each in units of its own.
///
/// A huge load somewhere excuses no violation in a row that it does not reach. With \f$y_i\f$ from row_yield(), the unit
/// of a row is \f$\sqrt{y_i}\,\max_j \beta_j c_{ji}\f$: \f$\beta_j = |b_j|/\sqrt{y_j}\f$ is a load, and
/// \f$c_{ji}\f$ the product of the couplings \f$|A_{kl}|/\sqrt{y_k y_l} \le 1\f$ along the best way from row j to row
/// i. A row that separates without a force acts on no other one, so its load counts in its own row only. Where bodies
/// are known (`factors`) it counts everywhere: all loads are then sums over the same motions, with their rounding.
/// \param result   after complete()
/// \return [-] \f$\max_i |\min(y_i f_i, a_i)|\f$ over the unit of row i, with |a_i| for equalities. Rows whose violation
///         is below `tolerance::usable_residual` of their own terms \f$|b_i| + \sum_j |A_{ij} f_j|\f$ are left out.
///         Infinite if a number of f or a is not finite
/// \par Cost
/// As of a product A f, where a row is not left out O(n²) more.
/// \verified{A row that breaks its conditions is not excused by loads that do not reach it}
double row_residual(const LcpProblem& problem, const LcpResult& result);

}  // namespace tumble
