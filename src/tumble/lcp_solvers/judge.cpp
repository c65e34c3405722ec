/// \file
/// \brief The judge of answers: each row by what the problem's loads make of it.
#include "tumble/lcp_solvers/judge.hpp"

#include "tumble/base/index.hpp"
#include "tumble/lcp_solvers/tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace tumble {
namespace {

constexpr double kUnbounded = std::numeric_limits<double>::infinity();

// One of force and acceleration has to be 0, and neither may be negative.
double row_violation(const LcpProblem& problem, const LcpResult& result, int row) {
  const double a = result.a[idx(row)];
  if (is_equality(problem, row)) return std::abs(a);
  return std::abs(std::min(row_yield(problem.A, row) * result.f[idx(row)], a));
}

// Σ_j |A_ij f_j| + |b_i|
double row_terms(const LcpProblem& problem, const LcpResult& result, int row) {
  double sum = std::abs(problem.b[row]);
  for (int j = 0; j < problem.size(); ++j) sum += std::abs(problem.A(row, j) * result.f[idx(j)]);
  return sum;
}

bool load_acts(const LcpProblem& problem, const LcpResult& result, int row) {
  return !problem.factors.rows.empty() || is_equality(problem, row) || problem.b[row] < 0.0 ||
         result.f[idx(row)] != 0.0;
}

// [any] of each row: the largest load that reaches it, in rows of unit yield. The row with the largest of those left
// is final, since couplings only reduce: Dijkstra's way through the graph of couplings.
std::vector<double> loads_that_reach(const LcpProblem& problem, const LcpResult& result) {
  const int n = problem.size();
  std::vector<double> root(idx(n));
  std::vector<double> load(idx(n));
  std::vector<int> open(idx(n));
  for (int i = 0; i < n; ++i) {
    root[idx(i)] = std::sqrt(row_yield(problem.A, i));
    load[idx(i)] = load_acts(problem, result, i) ? std::abs(problem.b[i]) / root[idx(i)] : 0.0;
    open[idx(i)] = i;
  }
  while (!open.empty()) {
    const auto next = std::max_element(open.begin(), open.end(),
                                       [&](int i, int j) { return load[idx(i)] < load[idx(j)]; });
    const int from = *next;
    open.erase(next);
    for (const int i : open) {
      const double coupling = std::abs(problem.A(i, from)) / root[idx(i)] / root[idx(from)];
      load[idx(i)] = std::max(load[idx(i)], load[idx(from)] * std::min(coupling, 1.0));
    }
  }
  for (int i = 0; i < n; ++i) load[idx(i)] *= root[idx(i)];
  return load;
}

}  // namespace

double row_yield(const MatX& A, int row) {
  if (A(row, row) > 0.0) return A(row, row);
  double largest = 0.0;
  for (int j = 0; j < A.cols(); ++j) largest = std::max(largest, std::abs(A(row, j)));
  return largest > 0.0 ? largest : 1.0;
}

double scaled_residual(const LcpProblem& problem, const LcpResult& result) {
  double worst = 0.0;
  double largest = 0.0;
  for (int i = 0; i < problem.size(); ++i) {
    if (!std::isfinite(result.f[idx(i)]) || !std::isfinite(result.a[idx(i)])) return kUnbounded;
    const double root = std::sqrt(row_yield(problem.A, i));
    worst = std::max(worst, row_violation(problem, result, i) / root);
    largest = std::max(largest, std::abs(problem.b[i]) / root);
  }
  return largest > 0.0 ? worst / largest : worst;
}

double row_residual(const LcpProblem& problem, const LcpResult& result) {
  double worst = 0.0;
  std::vector<double> unit;
  for (int i = 0; i < problem.size(); ++i) {
    if (!std::isfinite(result.f[idx(i)]) || !std::isfinite(result.a[idx(i)])) return kUnbounded;
    const double wrong = row_violation(problem, result, i);
    if (wrong <= tolerance::usable_residual * row_terms(problem, result, i)) continue;
    if (unit.empty()) unit = loads_that_reach(problem, result);
    worst = std::max(worst, unit[idx(i)] > 0.0 ? wrong / unit[idx(i)] : kUnbounded);
  }
  return worst;
}

bool holds(const LcpProblem& problem, const LcpResult& result) {
  return result.residual <= tolerance::usable_residual &&
         scaled_residual(problem, result) <= tolerance::usable_residual &&
         row_residual(problem, result) <= tolerance::usable_residual;
}

}  // namespace tumble
