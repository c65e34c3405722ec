/// \file
/// \brief Rows of a problem in units of their own.
#include "tumble/lcp_solvers/row_scaling.hpp"

#include "tumble/base/index.hpp"

#include <algorithm>
#include <cmath>

namespace tumble {

void ScaledProblem::assign(const LcpProblem& problem) {
  const int n = problem.size();
  unit_.assign(idx(n), 1.0);
  for (int i = 0; i < n; ++i) {
    double size = problem.A(i, i);
    if (!(size > 0.0))
      size =
          std::max(problem.A.row(i).cwiseAbs().maxCoeff(), problem.A.col(i).cwiseAbs().maxCoeff());
    if (size > 0.0) unit_[idx(i)] = std::ldexp(1.0, -(std::ilogb(size) >> 1));
  }
  scaled_.A.resize(n, n);
  scaled_.b.resize(n);
  scaled_.equality = problem.equality;
  for (int j = 0; j < n; ++j) {
    scaled_.b[j] = unit_[idx(j)] * problem.b[j];
    for (int i = 0; i < n; ++i) scaled_.A(i, j) = unit_[idx(i)] * unit_[idx(j)] * problem.A(i, j);
  }
}

void ScaledProblem::forces(std::span<const double> scaled, std::vector<double>& f) const {
  f.resize(unit_.size());
  for (std::size_t i = 0; i < f.size(); ++i) f[i] = unit_[i] * scaled[i];
}

}  // namespace tumble
