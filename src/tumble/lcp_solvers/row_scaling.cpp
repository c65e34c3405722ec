/// \file
/// \brief Rows of a problem in units of their own.
#include "tumble/lcp_solvers/row_scaling.hpp"

#include "tumble/base/index.hpp"

#include <algorithm>
#include <cmath>

namespace tumble {
namespace {

constexpr int kMostExponent = 1000;  // of a scaled load: doubles end at 1023
constexpr double kLeast = 0x1p-500;  // [-] of A_ii over its row: no product of two units overflows

}  // namespace

void ScaledProblem::assign(const LcpProblem& problem) {
  const int n = problem.size();
  unit_.assign(idx(n), 1.0);
  lift_ = 0;
  for (int i = 0; i < n; ++i) {
    const double largest =
        std::max(problem.A.row(i).cwiseAbs().maxCoeff(), problem.A.col(i).cwiseAbs().maxCoeff());
    const double size =
        problem.A(i, i) > 0.0 ? std::max(problem.A(i, i), kLeast * largest) : largest;
    if (size > 0.0) unit_[idx(i)] = std::ldexp(1.0, -(std::ilogb(size) >> 1));
    if (problem.b[i] != 0.0)
      lift_ = std::max(lift_, std::ilogb(problem.b[i]) + std::ilogb(unit_[idx(i)]) - kMostExponent);
  }
  scaled_.A.resize(n, n);
  scaled_.b.resize(n);
  scaled_.equality = problem.equality;
  for (int j = 0; j < n; ++j) {
    scaled_.b[j] = unit_[idx(j)] * std::ldexp(problem.b[j], -lift_);
    for (int i = 0; i < n; ++i) scaled_.A(i, j) = unit_[idx(i)] * problem.A(i, j) * unit_[idx(j)];
  }
}

void ScaledProblem::forces(std::span<const double> scaled, std::vector<double>& f) const {
  f.resize(unit_.size());
  for (std::size_t i = 0; i < f.size(); ++i) f[i] = std::ldexp(unit_[i] * scaled[i], lift_);
}

}  // namespace tumble
