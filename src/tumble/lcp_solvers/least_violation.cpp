/// \file
/// \brief Forces that violate the conditions of contact least, where there may be no solution.
#include "tumble/lcp_solvers/least_violation.hpp"

#include "tumble/base/index.hpp"
#include "tumble/base/tolerances.hpp"
#include "tumble/lcp_solvers/tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tumble {
namespace {

constexpr int kMostRounds = 50;

}  // namespace

void LeastViolation::solve(const LcpProblem& problem, LcpResult& result) {
  result.pivots = 0;
  result.multiplications = 0;
  result.f.assign(idx(problem.size()), 0.0);
  result.status = LcpStatus::not_positive_semidefinite;
  if (scale(problem) && approach(result)) {
    // What is left is no error of the rounds. A problem whose b is changed by it has a solution.
    if (!(residual(f_) <= tolerance::multiplier_residual)) {
      const VecX b = scaled_.b;
      for (int i = 0; i < problem.size(); ++i)
        if (is_equality(problem, i) || f_[idx(i)] > 0.0 || a_[idx(i)] < 0.0)
          scaled_.b[i] -= a_[idx(i)];
      const std::vector<double> grown = f_;
      const bool approached = approach(result);
      scaled_.b = b;
      if (!approached || !(residual(f_) <= 2.0 * residual(grown))) f_ = grown;
    }
    units_.forces(f_, result.f);
    for (double& f : result.f) f *= largest_;
    result.status = LcpStatus::solved;
  }
  complete(problem, result);
  if (result.status != LcpStatus::solved) return;
  if (holds(problem, result)) return;
  // A violation that the rounds do not see, beside loads so much larger, is no proof that there is no solution.
  if (scaled_residual(problem, result) <= tolerance::lost_in_A)
    result.status = LcpStatus::singular;
  else if (!(result.residual <= tolerance::inconsistent))
    result.status = LcpStatus::infeasible;
  else
    result.status = LcpStatus::least_violation;
}

// Returns false for what cannot be semidefinite.
bool LeastViolation::scale(const LcpProblem& problem) {
  units_.assign(problem);
  scaled_ = units_.problem();
  const int n = problem.size();
  largest_ = 0.0;
  for (int j = 0; j < n; ++j) {
    if (!(scaled_.A(j, j) >= 0.0)) return false;
    largest_ = std::max(largest_, std::abs(scaled_.b[j]));
    for (int i = 0; i < j; ++i)
      if (!(std::abs(scaled_.A(i, j) - scaled_.A(j, i)) <= tolerance::symmetry)) return false;
  }
  if (!(largest_ > 0.0)) largest_ = 1.0;
  scaled_.b /= largest_;
  return std::isfinite(largest_);
}

// Rounds from f = 0 until they gain nothing more. f_ and a_ get the best of them.
bool LeastViolation::approach(LcpResult& result) {
  const int n = scaled_.size();
  soft_ = scaled_;
  soft_.A.diagonal().array() += tolerance::proximal_softness;
  f_.assign(idx(n), 0.0);
  answer_.pushing.clear();
  double before = std::numeric_limits<double>::infinity();
  for (int round = 0; round < kMostRounds; ++round) {
    for (int i = 0; i < n; ++i)
      soft_.b[i] = scaled_.b[i] - tolerance::proximal_softness * f_[idx(i)];
    twins_.assign(soft_);
    solver_.solve(twins_.A(), twins_.b(), answer_, answer_.pushing);
    result.pivots += answer_.pivots;
    result.multiplications += answer_.multiplications;
    if (answer_.status != ComplementarityStatus::solved) return round > 0;
    twins_.forces(answer_.f, next_);
    const double now = residual(next_);
    if (!(now < before)) break;
    f_ = next_;
    if (now <= tolerance::multiplier_residual || now > 0.5 * before) break;
    before = now;
  }
  residual(f_);  // and a_
  return true;
}

double LeastViolation::residual(std::span<const double> f) {
  a_.assign(scaled_.b.data(), scaled_.b.data() + scaled_.size());
  for (int j = 0; j < scaled_.size(); ++j)
    if (f[idx(j)] != 0.0) add_column(f[idx(j)], scaled_.A, j, a_);
  double worst = 0.0;
  for (int i = 0; i < scaled_.size(); ++i) {
    const double a = a_[idx(i)];
    const double here = std::abs(is_equality(scaled_, i) ? a : std::min(f[idx(i)], a));
    if (!(here <= worst)) worst = here;  // keeps what is not a number
    if (std::isnan(worst)) break;
  }
  return worst;
}

}  // namespace tumble
