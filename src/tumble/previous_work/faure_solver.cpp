/// \file
/// \brief Faure's iteration for a complementarity problem.
#include "tumble/previous_work/faure_solver.hpp"

#include "tumble/base/error.hpp"
#include "tumble/base/index.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace tumble {

FaureSolver::FaureSolver(int budget, double wanted) : budget_(budget), wanted_(wanted) {
  require::that(budget >= 0, "budget = " + std::to_string(budget) + ": expected 0 or more");
  require::not_negative(wanted, "wanted");
}

void FaureSolver::Dense::multiply(std::span<const double> x, std::span<double> out) const {
  std::fill(out.begin(), out.end(), 0.0);
  for (std::size_t k = 0; k < x.size(); ++k)  // A is symmetric, and kept by columns
    for (std::size_t i = 0; i < out.size(); ++i)
      out[i] += lcp.A(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k)) * x[k];
}

// Contacts push.
void FaureSolver::Dense::allow(std::span<double> f) const {
  for (std::size_t i = 0; i < f.size(); ++i)
    if (!is_equality(lcp, static_cast<int>(i))) f[i] = std::max(f[i], 0.0);
}

void FaureSolver::solve(const LcpProblem& problem, LcpResult& result, std::span<const int> start) {
  require_valid(problem, LcpMatrix::positive_diagonal);
  require_valid_start(problem.size(), start);
  const std::int64_t n = problem.size();
  result.f.assign(idx(problem.size()), 0.0);
  // A step that is small enough leaves no row further from its answer than `wanted` of the largest constant.
  const double scale = n > 0 ? problem.b.cwiseAbs().maxCoeff() : 0.0;
  double largest = 0.0;
  for (int i = 0; i < problem.size(); ++i) largest = std::max(largest, problem.A(i, i));
  const double step = n > 0 ? wanted_ * scale / std::sqrt(largest) : 0.0;
  Dense dense{problem};
  const DescentReport done = descent_.solve(dense, result.f, step, budget_);
  result.pivots = done.iterations;
  result.multiplications = done.products * n * n;
  result.status = done.settled ? LcpStatus::solved : LcpStatus::cap_reached;
  complete(problem, result);
  conclude(problem, result);
}

}  // namespace tumble
