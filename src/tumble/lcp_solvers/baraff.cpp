/// \file
/// \brief Baraff's pivoting, with equalities.
#include "tumble/lcp_solvers/baraff.hpp"

#include "tumble/lcp_solvers/row_scaling.hpp"
#include "tumble/lcp_solvers/tolerances.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace tumble {
namespace {

LcpStatus translated(ComplementarityStatus status) {
  switch (status) {
    case ComplementarityStatus::solved: return LcpStatus::solved;
    case ComplementarityStatus::infeasible: return LcpStatus::infeasible;
    case ComplementarityStatus::cap_reached: return LcpStatus::cap_reached;
    case ComplementarityStatus::not_positive_semidefinite: break;
  }
  return LcpStatus::not_positive_semidefinite;
}

// Which contact sinks and which matrix is singular is decided by the largest row. What failed so is tried again in
// rows of unit diagonal.
void solve_in_units(const LcpProblem& problem, int pivots_each, LcpResult& result) {
  ScaledProblem units;
  units.assign(problem);
  TwinProblem twins;
  twins.assign(units.problem());
  ComplementarityResult answer;
  ComplementaritySolver(pivots_each).solve(twins.A(), twins.b(), answer);
  if (answer.status != ComplementarityStatus::solved) return;
  LcpResult second;
  std::vector<double> f;
  twins.forces(answer.f, f);
  units.forces(f, second.f);
  second.status = LcpStatus::solved;
  second.pivots = result.pivots + answer.pivots;
  second.multiplications = result.multiplications + answer.multiplications;
  conclude(problem, second);
  if (second.status == LcpStatus::solved) std::swap(result, second);
}

}  // namespace

void BaraffSolver::solve(const LcpProblem& problem, LcpResult& result, std::span<const int> start) {
  require_valid(problem, LcpMatrix::symmetric_semidefinite);
  require_valid_start(problem.size(), start);

  // Contacts only: no copy is needed.
  if (std::all_of(problem.equality.begin(), problem.equality.end(),
                  [](char flag) { return flag == 0; })) {
    solver_.solve(problem.A, problem.b, answer_, start);
    result.f.assign(answer_.f.begin(), answer_.f.end());
  } else {
    twins_.assign(problem);
    twins_.start_from(problem, start, start_);
    solver_.solve(twins_.A(), twins_.b(), answer_, start_);
    twins_.forces(answer_.f, result.f);
  }
  result.status = translated(answer_.status);
  result.pivots = answer_.pivots;
  result.multiplications = answer_.multiplications;
  conclude(problem, result);

  const bool solved = result.status == LcpStatus::solved;
  if (problem.factors.rows.empty()) {
    if (!solved) solve_in_units(problem, pivots_each_, result);
    return;
  }
  // A holds only the squares of what J holds: half of the digits. Where that is too few, J is used.
  if (solved && result.residual <= tolerance::lost_in_A) return;
  const int pivots = result.pivots;
  const std::int64_t multiplications = result.multiplications;
  with_factors_.solve(problem, result);
  result.pivots += pivots;
  result.multiplications += multiplications;
}

}  // namespace tumble
