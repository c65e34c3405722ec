/// \file
/// \brief The smallest and the largest force that a part of the contacts can bear, as a linear
///        programme (thesis 2.6).
#include "lcp_solvers/force_range.hpp"

namespace tumble::chapters {
namespace {

// [-] What is smaller is rounding: entries begin between 0.1 and 100, and some tens of pivots were
// measured to leave less than 1e-12 where there is nothing.
constexpr double kZero = 1e-9;

}  // namespace

// First phase: each equation gets an artificial unknown that makes up what is missing. Their sum is
// made least; if it is 0, they are not needed any more.
ForceRange::ForceRange(const MatX& A, const VecX& b) {
  const int n = static_cast<int>(b.size());
  MatX& T = start_.T;
  T.setZero(n + 1, n + 1);
  for (int i = 0; i < n; ++i) {
    const double sign = b[i] > 0.0 ? -1.0 : 1.0;  // so that -b_i is not negative
    T.block(i, 0, 1, n) = sign * A.row(i);
    T(i, n) = -sign * b[i];
    T.row(n) -= T.row(i);  // the cost, with the artificial unknowns of the basis eliminated
    start_.basis.push_back(n + i);
  }
  start_.descend();
  if (std::abs(T(n, n)) > kZero * (1.0 + b.cwiseAbs().sum()))
    throw std::runtime_error("no contact forces keep these bodies at rest");

  // An artificial unknown that is left is 0. Any force can take its place; if none occurs in its
  // row, the equation depends on others.
  for (int i = 0; i < n; ++i) {
    if (start_.basis[static_cast<std::size_t>(i)] < n) continue;
    int best = 0;
    for (int j = 1; j < n; ++j)
      if (std::abs(T(i, j)) > std::abs(T(i, best))) best = j;
    if (std::abs(T(i, best)) > kZero)
      start_.pivot(i, best);
    else
      T.row(i).setZero();
  }
}

ForceInterval ForceRange::of(std::span<const int> rows) const {
  const auto least = [&](double sign) {
    Tableau work = start_;
    MatX& T = work.T;
    const Eigen::Index m = T.rows() - 1;
    T.row(m).setZero();
    for (const int j : rows) T(m, j) = sign;
    for (Eigen::Index i = 0; i < m; ++i) {
      const int unknown = work.basis[static_cast<std::size_t>(i)];
      if (unknown < T.cols() - 1) T.row(m) -= (T(m, unknown) * T.row(i)).eval();
    }
    if (!work.descend()) throw std::runtime_error("the force has no limit");
    return -T(m, T.cols() - 1);
  };
  return {least(1.0), -least(-1.0)};
}

// Pivots until no unknown beside the basis would lower the cost. Returns false if one would without
// end.
bool ForceRange::Tableau::descend() {
  const int m = static_cast<int>(T.rows()) - 1;
  const int n = static_cast<int>(T.cols()) - 1;
  for (int pivots = 0; pivots < 100 * (n + 1); ++pivots) {
    int enters = 0;
    while (enters < n && !(T(m, enters) < -kZero)) ++enters;
    if (enters == n) return true;

    // What becomes 0 first leaves; of several, the one of least index.
    int leaves = -1;
    double length = 0.0;
    for (int i = 0; i < m; ++i) {
      if (!(T(i, enters) > kZero)) continue;
      const double ratio = T(i, n) / T(i, enters);
      const bool tie = leaves >= 0 && std::abs(ratio - length) <= kZero * (1.0 + length);
      const auto at = [this](int row) { return basis[static_cast<std::size_t>(row)]; };
      if (leaves >= 0 && (tie ? at(i) > at(leaves) : ratio > length)) continue;
      length = ratio;
      leaves = i;
    }
    if (leaves < 0) return false;
    pivot(leaves, enters);
  }
  throw std::runtime_error("the linear programme did not end");
}

void ForceRange::Tableau::pivot(int row, int column) {
  T.row(row) /= T(row, column);
  for (Eigen::Index i = 0; i < T.rows(); ++i)
    if (i != row && T(i, column) != 0.0) T.row(i) -= (T(i, column) * T.row(row)).eval();
  basis[static_cast<std::size_t>(row)] = column;
}

}  // namespace tumble::chapters
