/// \file
/// \brief Trying every case.
#include "tumble/lcp_solvers/enumerate.hpp"

#include "tumble/base/error.hpp"
#include "tumble/lcp_solvers/row_scaling.hpp"
#include "tumble/lcp_solvers/twins.hpp"
#include "tumble/math/enumeration.hpp"

#include <string>
#include <vector>

namespace tumble {

void EnumerationSolver::solve(const LcpProblem& problem, LcpResult& result,
                              std::span<const int> start) {
  require_valid(problem, LcpMatrix::any);
  require_valid_start(problem.size(), start);
  ScaledProblem scaled;
  scaled.assign(problem);
  TwinProblem twins;
  twins.assign(scaled.problem());
  if (twins.size() > enumeration_limit)
    refuse("n = " + std::to_string(problem.size()) + " with " +
           std::to_string(twins.size() - problem.size()) + " equalities: give at most " +
           std::to_string(enumeration_limit) + " rows and equalities together to try all cases");
  const ComplementarityResult answer = solve_by_enumeration(twins.A(), twins.b());
  std::vector<double> f;
  twins.forces(answer.f, f);
  scaled.forces(f, result.f);
  result.status =
      answer.status == ComplementarityStatus::solved ? LcpStatus::solved : LcpStatus::infeasible;
  result.pivots = answer.pivots;
  result.multiplications = 0;
  conclude(problem, result);
}

}  // namespace tumble
