/// \file
/// \brief Small dense matrices of run-time size, with a fixed order of sums.
#include "tumble/math/dense.hpp"

#include "tumble/base/tolerances.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace tumble {
namespace {

int size_of(const std::vector<int>& v) { return static_cast<int>(v.size()); }

// y[from, to) += s x[from, to): entries do not meet, so it may be done several at a time.
void add_scaled(double s, const double* x, double* y, int from, int to) {
  for (int i = from; i < to; ++i) y[i] += s * x[i];
}

// Σ x_i y_i over [from, to), in ascending order.
double dot(const double* x, const double* y, int from, int to) {
  double sum = 0.0;
  for (int i = from; i < to; ++i) sum += x[i] * y[i];
  return sum;
}

}  // namespace

void add_column(double s, const MatRef& A, int column, std::span<double> y) {
  assert(static_cast<int>(y.size()) == A.rows() && column < A.cols());
  add_scaled(s, A.col(column).data(), y.data(), 0, static_cast<int>(y.size()));
}

void multiply(const MatRef& A, std::span<const double> x, std::span<double> y) {
  assert(static_cast<int>(x.size()) == A.cols());
  std::fill(y.begin(), y.end(), 0.0);
  for (int j = 0; j < A.cols(); ++j) add_column(x[static_cast<std::size_t>(j)], A, j, y);
}

// --- SubsetCholesky -------------------------------------------------------------------------

void SubsetCholesky::clear(int size) {
  if (lower_.rows() < size) lower_.resize(size, size);
  const auto capacity = static_cast<std::size_t>(lower_.rows());
  indices_.clear();
  indices_.reserve(capacity);
  later_.reserve(capacity);
  row_.resize(capacity);
  considered_ = -1;
}

double SubsetCholesky::consider(const MatRef& A, int index) {
  // The new row l of L fulfils L l = A(C, j), and its diagonal entry is the root of what l leaves
  // of A_jj: the Schur complement.
  const std::size_t n = indices_.size();
  for (std::size_t k = 0; k < n; ++k) row_[k] = A(indices_[k], index);
  solve_lower({row_.data(), n});
  considered_ = index;
  schur_ = A(index, index);
  for (std::size_t k = 0; k < n; ++k) schur_ -= row_[k] * row_[k];
  return schur_;
}

void SubsetCholesky::answer_to_considered(std::span<double> answer) const {
  // A_CC^{-1} A_Cj = L^{-T} (L^{-1} A_Cj), of which consider() has done the inner half.
  assert(considered_ >= 0 && answer.size() == indices_.size());
  for (std::size_t k = 0; k < answer.size(); ++k) answer[k] = -row_[k];
  solve_upper(answer);
}

void SubsetCholesky::append_considered() {
  assert(considered_ >= 0 && schur_ > 0.0);
  const int n = size_of(indices_);
  for (int k = 0; k < n; ++k) lower_(n, k) = row_[static_cast<std::size_t>(k)];
  lower_(n, n) = std::sqrt(schur_);
  indices_.push_back(considered_);
  considered_ = -1;
}

void SubsetCholesky::remove(const MatRef& A, int place) {
  assert(place >= 0 && place < size_of(indices_));
  // With fewer indices before them, the Schur complements of the later ones can only grow.
  later_.assign(indices_.begin() + place + 1, indices_.end());
  indices_.resize(static_cast<std::size_t>(place));
  considered_ = -1;
  for (const int index : later_) {
    consider(A, index);
    append_considered();
  }
}

void SubsetCholesky::solve(std::span<double> x) const {
  solve_lower(x);
  solve_upper(x);
}

void SubsetCholesky::solve_lower(std::span<double> x) const {
  const int n = static_cast<int>(x.size());
  for (int k = 0; k < n; ++k) {
    double& value = x[static_cast<std::size_t>(k)];
    value /= lower_(k, k);
    add_scaled(-value, lower_.col(k).data(), x.data(), k + 1, n);
  }
}

void SubsetCholesky::solve_upper(std::span<double> x) const {
  const int n = static_cast<int>(x.size());
  for (int k = n - 1; k >= 0; --k) {
    double& value = x[static_cast<std::size_t>(k)];
    value = (value - dot(lower_.col(k).data(), x.data(), k + 1, n)) / lower_(k, k);
  }
}

// --- OrthogonalFactor -----------------------------------------------------------------------

void OrthogonalFactor::clear(int rows, int columns) {
  const int capacity = std::min(rows, columns);  // more columns than rows always depend
  if (q_.rows() < rows || q_.cols() < capacity)
    q_.resize(std::max<Eigen::Index>(q_.rows(), rows), std::max<Eigen::Index>(q_.cols(), capacity));
  if (r_.rows() < capacity) r_.resize(capacity, capacity);
  indices_.clear();
  indices_.reserve(static_cast<std::size_t>(r_.rows()));
  later_.reserve(static_cast<std::size_t>(r_.rows()));
  rest_.resize(static_cast<std::size_t>(rows));
  multiplications_ = 0;
}

// Subtracts from `rest_` its part along direction k; returns how long that part was.
double OrthogonalFactor::take_out(int k) {
  const int rows = static_cast<int>(rest_.size());
  const double along = dot(q_.col(k).data(), rest_.data(), 0, rows);
  add_scaled(-along, q_.col(k).data(), rest_.data(), 0, rows);
  multiplications_ += 2 * std::int64_t{rows};
  return along;
}

bool OrthogonalFactor::append(const MatRef& G, int column) {
  return append(G, column, tolerance::dependent_length);
}

bool OrthogonalFactor::append(const MatRef& G, int column, double limit) {
  const int n = size_of(indices_);
  const int rows = static_cast<int>(rest_.size());
  assert(G.rows() == rows);
  if (n == rows) return false;

  // What is left of the column without the directions held is a new direction, or rounding.
  for (int i = 0; i < rows; ++i) rest_[static_cast<std::size_t>(i)] = G(i, column);
  const double length_before = std::sqrt(dot(rest_.data(), rest_.data(), 0, rows));
  for (int k = 0; k < n; ++k) r_(k, n) = take_out(k);
  const double length = std::sqrt(dot(rest_.data(), rest_.data(), 0, rows));
  multiplications_ += 3 * std::int64_t{rows};  // two lengths, and the division below
  if (length <= limit * length_before) return false;

  for (int i = 0; i < rows; ++i) q_(i, n) = rest_[static_cast<std::size_t>(i)] / length;
  r_(n, n) = length;
  indices_.push_back(column);
  return true;
}

void OrthogonalFactor::remove(const MatRef& G, int place) {
  assert(place >= 0 && place < size_of(indices_));
  // Fewer columns before them leave the later ones longer: none has become dependent.
  later_.assign(indices_.begin() + place + 1, indices_.end());
  indices_.resize(static_cast<std::size_t>(place));
  for (const int column : later_) append(G, column, 0.0);
}

void OrthogonalFactor::solve(const VecRef& d, std::span<double> x) {
  // R x = Qᵀ d; each part of d is taken out before the next is measured.
  const int n = size_of(indices_);
  assert(static_cast<int>(x.size()) == n && d.size() == static_cast<int>(rest_.size()));
  for (std::size_t i = 0; i < rest_.size(); ++i) rest_[i] = d[static_cast<Eigen::Index>(i)];
  for (int k = 0; k < n; ++k) x[static_cast<std::size_t>(k)] = take_out(k);
  for (int k = n - 1; k >= 0; --k) {
    double& value = x[static_cast<std::size_t>(k)];
    value /= r_(k, k);
    add_scaled(-value, r_.col(k).data(), x.data(), 0, k);
    multiplications_ += k + 1;
  }
}

}  // namespace tumble
