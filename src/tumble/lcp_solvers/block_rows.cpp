/// \file
/// \brief A positive semidefinite matrix as products of short rows.
#include "tumble/lcp_solvers/block_rows.hpp"

#include "tumble/base/index.hpp"
#include "tumble/base/tolerances.hpp"

#include <algorithm>
#include <cmath>

namespace tumble {

bool BlockRows::take(const LcpProblem& problem) {
  const std::size_t rows = problem.factors.rows.size();
  const std::size_t n = idx(problem.size());
  if (rows != 0) require_factors_fit(problem);
  begin_.clear();
  begin_.reserve(n + 1);
  begin_.push_back(0);
  block_.clear();
  part_.clear();
  length_.clear();
  length_.reserve(n);
  taking_ = 0;
  if (rows == 0) return take_matrix(problem.A);
  take_factors(problem);
  return true;
}

// g_i is what Sᵀ makes of row i of J, body by body.
void BlockRows::take_factors(const LcpProblem& problem) {
  const LcpFactors& factors = problem.factors;
  blocks_ = static_cast<int>(factors.bodies.size());
  roots_.take(factors);

  const auto append_part = [&](int body, const Vec3& linear_w, const Vec3& angular_w) {
    if (body >= 0) append(body, roots_.part(body, linear_w, angular_w));
  };
  part_.reserve(2 * factors.rows.size());
  block_.reserve(2 * factors.rows.size());
  for (int i = 0; i < problem.size(); ++i) {
    const LcpFactors::Row& row = factors.rows[idx(i)];
    append_part(row.first, row.linear_first_w, row.angular_first_w);
    append_part(row.second, row.linear_second_w, row.angular_second_w);
    end_row();
    require_diagonal(problem, i, length(i) * length(i));
  }
  taking_ = 10 * static_cast<std::int64_t>(factors.bodies.size()) +
            24 * static_cast<std::int64_t>(part_.size());
}

// The rows of Cholesky's factor, six columns to a block.
bool BlockRows::take_matrix(const MatX& A) {
  const int n = static_cast<int>(A.rows());
  const int rank = factor(A);
  if (rank < 0) return false;
  blocks_ = (rank + 5) / 6;
  for (int i = 0; i < n; ++i) {
    for (int block = 0; block < blocks_; ++block) {
      Vec6 part = Vec6::Zero();
      for (int k = 0; k < std::min(6, rank - 6 * block); ++k) part[k] = lower_(i, 6 * block + k);
      append(block, part);
    }
    end_row();
  }
  return true;
}

void BlockRows::append(int block, const Vec6& part) {
  block_.push_back(block);
  part_.push_back(part);
}

// Scales the row to length 1; one that moves nothing has no parts.
void BlockRows::end_row() {
  double square = 0.0;
  for (std::size_t p = idx(begin_.back()); p < part_.size(); ++p) square += part_[p].squaredNorm();
  const double length = std::sqrt(square);
  if (length > 0.0) {
    for (std::size_t p = idx(begin_.back()); p < part_.size(); ++p) part_[p] *= 1.0 / length;
  } else {
    part_.resize(idx(begin_.back()));
    block_.resize(idx(begin_.back()));
  }
  length_.push_back(length);
  begin_.push_back(static_cast<int>(part_.size()));
}

// Cholesky's factor of A, columns in the order of the largest share of A_ii left: the rank, or -1 if
// what is left at the end is not nothing.
int BlockRows::factor(const MatX& A) {
  const int n = static_cast<int>(A.rows());
  if (lower_.rows() < n) lower_.resize(n, n);
  left_.assign(idx(n), 0.0);
  taken_.assign(idx(n), 0);
  for (int i = 0; i < n; ++i) left_[idx(i)] = A(i, i) > 0.0 ? 1.0 : 0.0;

  int rank = 0;
  // The column that row p would give: what is left of A's column, over what is left of A_pp.
  const auto column = [&](int p) {
    for (int i = 0; i < n; ++i) lower_(i, rank) = A(i, p);
    for (int k = 0; k < rank; ++k)
      for (int i = 0; i < n; ++i) lower_(i, rank) -= lower_(p, k) * lower_(i, k);
    taking_ += std::int64_t{rank} * n;
  };
  while (rank < n) {
    int p = 0;
    for (int i = 1; i < n; ++i)
      if (left_[idx(i)] > left_[idx(p)]) p = i;
    if (left_[idx(p)] <= tolerance::dependent) break;
    column(p);
    const double pivot = std::sqrt(A(p, p) * left_[idx(p)]);
    for (int i = 0; i < n; ++i) {
      lower_(i, rank) = taken_[idx(i)] != 0 ? 0.0 : lower_(i, rank) / pivot;
      if (A(i, i) > 0.0) left_[idx(i)] -= lower_(i, rank) * lower_(i, rank) / A(i, i);
    }
    lower_(p, rank) = pivot;
    left_[idx(p)] = 0.0;
    taken_[idx(p)] = 1;
    taking_ += 3 * std::int64_t{n};
    ++rank;
  }

  // Nothing is left of a semidefinite matrix, off the diagonal too.
  for (int p = 0; p < n; ++p) {
    if (taken_[idx(p)] != 0) continue;
    if (A(p, p) < 0.0 || left_[idx(p)] < -tolerance::symmetry) return -1;
    column(p);
    for (int i = 0; i < n; ++i) {
      if (taken_[idx(i)] != 0) continue;
      const double scale = std::sqrt(std::abs(A(i, i))) * std::sqrt(std::abs(A(p, p)));
      if (std::abs(lower_(i, rank)) > tolerance::symmetry * scale) return -1;
    }
  }
  return rank;
}

void BlockRows::project(const std::vector<Vec6>& z, std::span<double> y) const {
  for (int i = 0; i < size(); ++i) {
    double sum = 0.0;
    for (int p = begin_[idx(i)]; p < begin_[idx(i) + 1]; ++p)
      sum += part_[idx(p)].dot(z[idx(block_[idx(p)])]);
    y[idx(i)] = sum;
  }
}

void BlockRows::gather(std::span<const double> f, std::vector<Vec6>& z) const {
  std::fill(z.begin(), z.end(), Vec6(Vec6::Zero()));
  for (int i = 0; i < size(); ++i) {
    if (f[idx(i)] == 0.0) continue;
    for (int p = begin_[idx(i)]; p < begin_[idx(i) + 1]; ++p)
      z[idx(block_[idx(p)])] += f[idx(i)] * part_[idx(p)];
  }
}

void BlockCholesky::analyse(const BlockRows& rows) {
  multiplications_ = 0;
  joined_.clear();
  const std::vector<int>& begin = rows.begin_of_rows();
  const std::vector<int>& blocks = rows.blocks_of_rows();
  for (int i = 0; i < rows.size(); ++i)
    for (int p = begin[idx(i)]; p < begin[idx(i) + 1]; ++p)
      for (int q = p + 1; q < begin[idx(i) + 1]; ++q)
        joined_.push_back({blocks[idx(p)], blocks[idx(q)]});
  matrix_.analyse(rows.blocks(), joined_);
}

void BlockCholesky::factor(const BlockRows& rows, const std::vector<char>& in_set,
                           double softness) {
  matrix_.clear();
  for (int k = 0; k < rows.blocks(); ++k) matrix_.add_to(k, softness * Mat6::Identity());
  const std::vector<int>& begin = rows.begin_of_rows();
  const std::vector<int>& blocks = rows.blocks_of_rows();
  const std::vector<Vec6>& parts = rows.parts();
  int pair = 0;
  for (int i = 0; i < rows.size(); ++i) {
    const int count = begin[idx(i) + 1] - begin[idx(i)];
    if (in_set[idx(i)] == 0) {
      pair += count * (count - 1) / 2;
      continue;
    }
    for (int p = begin[idx(i)]; p < begin[idx(i) + 1]; ++p) {
      const Vec6& a = parts[idx(p)];
      matrix_.add_to(blocks[idx(p)], a * a.transpose());
      for (int q = p + 1; q < begin[idx(i) + 1]; ++q)
        matrix_.add_to_pair(pair++, a * parts[idx(q)].transpose());
    }
    multiplications_ += std::int64_t{18} * count * (count + 1);
  }
  matrix_.factor();
  multiplications_ += matrix_.multiplications_of_factor();
}

void BlockCholesky::solve(std::vector<Vec6>& x) {
  matrix_.solve(x);
  multiplications_ += matrix_.multiplications_of_solve();
}

}  // namespace tumble
