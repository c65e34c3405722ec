/// \file
/// \brief Equalities as contacts from both sides.
#include "tumble/lcp_solvers/twins.hpp"

#include <cassert>

namespace tumble {

void TwinProblem::assign(const LcpProblem& problem) {
  originals_ = problem.size();
  rows_.clear();
  rows_.reserve(2 * static_cast<std::size_t>(originals_));
  for (const double sign : {1.0, -1.0})
    for (int i = 0; i < originals_; ++i)
      if (is_equality(problem, i)) rows_.push_back({i, sign});
  for (int i = 0; i < originals_; ++i)
    if (!is_equality(problem, i)) rows_.push_back({i, 1.0});

  const Eigen::Index n = size();
  if (A_.rows() < n) {
    A_.resize(n, n);
    b_.resize(n);
  }
  for (Eigen::Index j = 0; j < n; ++j) {
    const Row& column = rows_[static_cast<std::size_t>(j)];
    b_[j] = column.sign * problem.b[column.original];
    for (Eigen::Index i = 0; i < n; ++i) {
      const Row& row = rows_[static_cast<std::size_t>(i)];
      A_(i, j) = row.sign * column.sign * problem.A(row.original, column.original);
    }
  }
}

void TwinProblem::start_from(const LcpProblem& problem, std::span<const int> rows,
                             std::vector<int>& start) const {
  start.clear();
  start.reserve(rows_.size());
  for (const int wanted : rows) {
    // A push at an equality that would be negative is its twin's.
    const double sign = is_equality(problem, wanted) && problem.b[wanted] > 0.0 ? -1.0 : 1.0;
    for (std::size_t k = 0; k < rows_.size(); ++k)
      if (rows_[k].original == wanted && rows_[k].sign == sign)
        start.push_back(static_cast<int>(k));
  }
}

void TwinProblem::forces(std::span<const double> twin_f, std::vector<double>& f) const {
  assert(twin_f.size() == rows_.size());
  f.assign(static_cast<std::size_t>(originals_), 0.0);
  for (std::size_t k = 0; k < rows_.size(); ++k)
    f[static_cast<std::size_t>(rows_[k].original)] += rows_[k].sign * twin_f[k];
}

}  // namespace tumble
