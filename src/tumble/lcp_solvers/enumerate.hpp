/// \file
/// \brief Trying every case, as a judge of other solvers (thesis 3.3.1).
#pragma once

#include "tumble/lcp_solvers/lcp.hpp"

namespace tumble {

/// Tries all pairs of a set of rows without acceleration and a part of it that pushes: 3ⁿ cases, see
/// solve_by_enumeration().
///
/// It takes any matrix, works in rows of unit diagonal (ScaledProblem), never errs but for rounding, and `infeasible` means that there is no
/// solution. An equality counts as two rows (TwinProblem). It allocates as it goes, and ignores rows
/// to start with.
class EnumerationSolver : public LcpSolver {
 public:
  [[nodiscard]] std::string_view name() const override { return "enumeration"; }

  /// Solves one problem.
  /// \param problem  any matrix; rows and equalities together at most `enumeration_limit`
  /// \param result   the answer, of several the first in the order of trial; `pivots` counts cases
  ///                 and `multiplications` stays 0
  /// \param start    is ignored
  /// \throws std::invalid_argument as require_valid() and require_valid_start(), or for too many rows
  void solve(const LcpProblem& problem, LcpResult& result,
             std::span<const int> start = {}) override;
};

}  // namespace tumble
