/// \file
/// \brief Trying every case.
#include "tumble/lcp_solvers/enumerate.hpp"

#include "tumble/base/error.hpp"
#include "tumble/lcp_solvers/twins.hpp"
#include "tumble/math/enumeration.hpp"

#include <string>

namespace tumble {

void EnumerationSolver::solve(const LcpProblem& problem, LcpResult& result,
                              std::span<const int> start) {
  require_valid(problem, LcpMatrix::any);
  require_valid_start(problem.size(), start);
  TwinProblem twins;
  twins.assign(problem);
  if (twins.size() > enumeration_limit)
    require::that(false, "n = " + std::to_string(problem.size()) + " with " +
                             std::to_string(twins.size() - problem.size()) +
                             " equalities: give at most " + std::to_string(enumeration_limit) +
                             " rows and equalities together to try all cases");
  const ComplementarityResult answer = solve_by_enumeration(twins.A(), twins.b());
  twins.forces(answer.f, result.f);
  result.status =
      answer.status == ComplementarityStatus::solved ? LcpStatus::solved : LcpStatus::infeasible;
  result.pivots = answer.pivots;
  result.multiplications = 0;
  complete(problem, result);
}

}  // namespace tumble
