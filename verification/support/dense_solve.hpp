/// \file
/// \brief Dense linear algebra for tests. Eigen's takes half a minute to compile for matrices that are large or of run-time size.
#pragma once

#include "tumble/base/types.hpp"

#include <cmath>
#include <utility>
#include <vector>

namespace tumble::test {

// The product of two matrices of run-time size.
inline MatX product(const MatX& A, const MatX& B) { return A.lazyProduct(B); }

// The lower triangle L with A = L L'.
// A: symmetric and positive definite
inline MatX cholesky(const MatX& A) {
  MatX L = MatX::Zero(A.rows(), A.cols());
  for (Eigen::Index j = 0; j < A.cols(); ++j)
    for (Eigen::Index i = j; i < A.rows(); ++i) {
      double rest = A(i, j);
      for (Eigen::Index k = 0; k < j; ++k) rest -= L(i, k) * L(j, k);
      L(i, j) = i == j ? std::sqrt(rest) : rest / L(j, j);
    }
  return L;
}

// The largest eigenvalue of a symmetric matrix without negative ones. Squared again and again, it has only the
// directions of that one.
inline double largest_eigenvalue(const MatX& A) {
  MatX power = A / A.norm();
  for (int k = 0; k < 30; ++k) {
    power = product(power, power);
    power /= power.norm();
  }
  Eigen::Index longest = 0;
  power.colwise().squaredNorm().maxCoeff(&longest);
  const VecX v = power.col(longest);
  return v.dot(VecX(A.lazyProduct(v))) / v.squaredNorm();
}

// Solves A x = b by Gaussian elimination, column by column, with the largest remaining entry of each as pivot. Columns
// that depend on those before, to 1e-12 of the largest entry, are left out: b has to be consistent, and their unknowns are 0.
inline VecX dense_solve(MatX A, VecX b) {
  const Eigen::Index n = A.rows();
  const double none = 1e-12 * A.cwiseAbs().maxCoeff();
  std::vector<Eigen::Index> pivots;  // columns; the k-th one's equation is moved to row k
  for (Eigen::Index column = 0; column < n; ++column) {
    const auto row = static_cast<Eigen::Index>(pivots.size());
    Eigen::Index best = row;
    for (Eigen::Index i = row; i < n; ++i)
      if (std::abs(A(i, column)) > std::abs(A(best, column))) best = i;
    if (!(std::abs(A(best, column)) > none)) continue;
    pivots.push_back(column);
    A.row(row).swap(A.row(best));
    std::swap(b[row], b[best]);
    for (Eigen::Index i = row + 1; i < n; ++i) {
      const double share = A(i, column) / A(row, column);
      if (share == 0.0) continue;
      for (Eigen::Index j = column; j < n; ++j) A(i, j) -= share * A(row, j);
      b[i] -= share * b[row];
    }
  }
  VecX x = VecX::Zero(n);
  for (std::size_t k = pivots.size(); k-- > 0;) {
    const auto row = static_cast<Eigen::Index>(k);
    double rest = b[row];
    for (Eigen::Index j = pivots[k] + 1; j < n; ++j) rest -= A(row, j) * x[j];
    x[pivots[k]] = rest / A(row, pivots[k]);
  }
  return x;
}

}  // namespace tumble::test
