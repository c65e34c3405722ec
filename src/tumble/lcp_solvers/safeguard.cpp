/// \file
/// \brief A solver whose answers are judged, and a second attempt where they fail.
#include "tumble/lcp_solvers/safeguard.hpp"

#include "tumble/base/index.hpp"
#include "tumble/lcp_solvers/enumerate.hpp"
#include "tumble/lcp_solvers/tolerances.hpp"
#include "tumble/math/enumeration.hpp"

#include <algorithm>
#include <cmath>

namespace tumble {
namespace {

// A second answer costs more than the first one, most of all where bodies are known and forces fast.
constexpr int kMostRowsToCompare = 300;
constexpr int kMostRowsToCompareOfBodies = 100;
constexpr double kMuchSmaller = 0.25;  // forces that are worth a change

// [-] max A_ii |f_i| over max |b|, in rows of unit diagonal.
double size_of_forces(const LcpProblem& problem, const LcpResult& result) {
  double force = 0.0;
  double load = 0.0;
  for (int i = 0; i < problem.size(); ++i) {
    const double y = problem.A(i, i) > 0.0 ? std::sqrt(problem.A(i, i)) : 1.0;
    force = std::max(force, y * std::abs(result.f[idx(i)]));
    load = std::max(load, std::abs(problem.b[i]) / y);
  }
  return load > 0.0 ? force / load : force;
}

bool is_solved(const LcpProblem& problem, const LcpResult& result) {
  return result.status == LcpStatus::solved && holds(problem, result);
}

// A force that is below 0 by as little as a solution may be is 0: contacts do not pull. It is judged again with that.
void end_pulls(const LcpProblem& problem, LcpResult& result) {
  if (result.status != LcpStatus::solved || !(result.residual <= tolerance::usable_residual) ||
      !(scaled_residual(problem, result) <= tolerance::usable_residual))
    return;
  bool any = false;
  for (int i = 0; i < problem.size(); ++i) {
    if (is_equality(problem, i) || !(result.f[idx(i)] < 0.0)) continue;
    result.f[idx(i)] = 0.0;
    any = true;
  }
  if (any) complete(problem, result);
}

// Of two solved ones: as exact with smaller forces, or with much smaller ones.
bool is_better(const LcpProblem& problem, const LcpResult& one, const LcpResult& other) {
  if (!is_solved(problem, one)) return false;
  const double size = size_of_forces(problem, one);
  const double other_size = size_of_forces(problem, other);
  return size <= kMuchSmaller * other_size ||
         (one.residual <= other.residual && size <= other_size);
}

}  // namespace

void SafeguardedSolver::solve(const LcpProblem& problem, LcpResult& result,
                              std::span<const int> start) {
  core_->solve(problem, result, start);
  end_pulls(problem, result);
  if (needs_help(problem, result)) try_again(problem, result);
  end_pulls(problem, result);
  // Forces that no number holds are no proof of anything.
  const bool finite = std::all_of(result.f.begin(), result.f.end(),
                                  [](double force) { return std::isfinite(force); });
  if ((result.status == LcpStatus::solved && !holds(problem, result)) ||
      (result.status == LcpStatus::infeasible && !finite))
    result.status = LcpStatus::singular;
}

// An answer that is right, but not to rounding, or has large forces may be that of a problem that contradicts
// itself a little.
bool SafeguardedSolver::needs_help(const LcpProblem& problem, const LcpResult& result) const {
  if (core_->name() == "baraff_as_printed") return false;
  const bool few = problem.size() <=
                   (problem.factors.rows.empty() ? kMostRowsToCompare : kMostRowsToCompareOfBodies);
  if (result.status == LcpStatus::cap_reached && sweeps()) return few;
  if (!is_solved(problem, result)) return true;
  const bool precise = result.residual <= tolerance::lost_in_A || sweeps();
  return few && !(precise && size_of_forces(problem, result) <= tolerance::large_forces);
}

void SafeguardedSolver::try_again(const LcpProblem& problem, LcpResult& result) {
  least_violation_.solve(problem, second_);
  if (second_.status == LcpStatus::not_positive_semidefinite) {
    if (!is_solved(problem, result)) try_any_matrix(problem, result);
    return;
  }
  // Sweeps may have been slow and no more, if there is a solution that they could have come to.
  if (result.status == LcpStatus::cap_reached && sweeps() &&
      scaled_residual(problem, second_) <= tolerance::gauss_seidel_residual) {
    if (holds(problem, result)) result.status = LcpStatus::solved;
    return;
  }
  second_.pivots += result.pivots;
  second_.multiplications += result.multiplications;
  if (!is_solved(problem, result) || is_better(problem, second_, result))
    std::swap(result, second_);
}

// What is neither solved nor semidefinite. Trying every case knows all; Lemke's method from other bases
// knows nothing if it fails.
void SafeguardedSolver::try_any_matrix(const LcpProblem& problem, LcpResult& result) {
  if (core_->name() != "lemke" || result.status == LcpStatus::infeasible) return;
  int rows = problem.size();
  for (int i = 0; i < problem.size(); ++i) rows += is_equality(problem, i) ? 1 : 0;
  if (rows > enumeration_limit) {
    restarts_.solve(problem, result);
    return;
  }
  EnumerationSolver().solve(problem, second_);
  if (second_.status == LcpStatus::infeasible)
    result.status = LcpStatus::infeasible;
  else if (is_solved(problem, second_))
    result = second_;
}

}  // namespace tumble
