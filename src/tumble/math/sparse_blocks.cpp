/// \file
/// \brief Cholesky factors of sparse symmetric matrices of 6×6 blocks.
#include "tumble/math/sparse_blocks.hpp"

#include "tumble/base/error.hpp"
#include "tumble/base/index.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace tumble {
namespace {

// Each loop runs down a column, six independent sums at a time.

// C -= A Bᵀ
void subtract_product(const double* A, const double* B, double* C) {
  for (int j = 0; j < 6; ++j) {
    double column[6];
    for (int i = 0; i < 6; ++i) column[i] = C[6 * j + i];
    for (int k = 0; k < 6; ++k)
      for (int i = 0; i < 6; ++i) column[i] -= B[6 * k + j] * A[6 * k + i];
    for (int i = 0; i < 6; ++i) C[6 * j + i] = column[i];
  }
}

// L Lᵀ = A in place, the diagonal of L as reciprocals. Where rounding has left nothing to take the root of, all that
// is found with the factors is not a number, too.
void factor_diagonal(double* A) {
  for (int k = 0; k < 6; ++k) {
    const double reciprocal =
        A[7 * k] > 0.0 ? 1.0 / std::sqrt(A[7 * k]) : std::numeric_limits<double>::quiet_NaN();
    A[7 * k] = reciprocal;
    for (int i = k + 1; i < 6; ++i) A[6 * k + i] *= reciprocal;
    for (int j = k + 1; j < 6; ++j)
      for (int i = j; i < 6; ++i) A[6 * j + i] -= A[6 * k + j] * A[6 * k + i];
  }
}

// B <- B L⁻ᵀ
void divide_by_transposed(const double* L, double* B) {
  for (int k = 0; k < 6; ++k) {
    for (int i = 0; i < 6; ++i) B[6 * k + i] *= L[7 * k];
    for (int j = k + 1; j < 6; ++j)
      for (int i = 0; i < 6; ++i) B[6 * j + i] -= L[6 * k + j] * B[6 * k + i];
  }
}

// x <- L⁻¹ x
void solve_lower(const double* L, double* x) {
  for (int k = 0; k < 6; ++k) {
    x[k] *= L[7 * k];
    for (int i = k + 1; i < 6; ++i) x[i] -= L[6 * k + i] * x[k];
  }
}

// x <- L⁻ᵀ x
void solve_upper(const double* L, double* x) {
  for (int k = 5; k >= 0; --k) {
    for (int i = k + 1; i < 6; ++i) x[k] -= L[6 * k + i] * x[i];
    x[k] *= L[7 * k];
  }
}

// y -= A x
void subtract(const double* A, const double* x, double* y) {
  for (int k = 0; k < 6; ++k)
    for (int i = 0; i < 6; ++i) y[i] -= A[6 * k + i] * x[k];
}

// y -= Aᵀ x
void subtract_transposed(const double* A, const double* x, double* y) {
  for (int k = 0; k < 6; ++k) {
    double sum = 0.0;
    for (int i = 0; i < 6; ++i) sum += A[6 * k + i] * x[i];
    y[k] -= sum;
  }
}

}  // namespace

bool SparseBlocks::analyse(int blocks, std::span<const BlockPair> joined) {
  if (blocks == blocks_ && std::equal(joined.begin(), joined.end(), joined_.begin(), joined_.end()))
    return false;
  for (const BlockPair& pair : joined)
    require::that(pair.first >= 0 && pair.first < blocks && pair.second >= 0 &&
                      pair.second < blocks && pair.first != pair.second,
                  "joined: two different blocks that there are is needed for each pair");
  blocks_ = blocks;
  joined_.assign(joined.begin(), joined.end());
  find_order();
  place_blocks();
  x_.resize(idx(blocks_));
  return true;
}

// Eliminates blocks on paper: the one with the fewest neighbours goes next, and those become
// neighbours of each other. One bit for each pair.
void SparseBlocks::find_order() {
  const std::size_t words = (idx(blocks_) + 63) / 64;
  adjacent_.assign(idx(blocks_) * words, 0);
  const auto join = [&](int a, int b) {
    adjacent_[idx(a) * words + idx(b) / 64] |= std::uint64_t{1} << (idx(b) % 64);
  };
  for (const BlockPair& pair : joined_) {
    join(pair.first, pair.second);
    join(pair.second, pair.first);
  }

  degree_.resize(idx(blocks_));
  const auto count = [&](int block) {
    int bits = 0;
    for (std::size_t w = 0; w < words; ++w)
      bits += std::popcount(adjacent_[idx(block) * words + w]);
    degree_[idx(block)] = bits;
  };
  for (int block = 0; block < blocks_; ++block) count(block);

  order_.clear();
  place_.assign(idx(blocks_), -1);
  later_neighbours_.resize(idx(blocks_));
  for (int k = 0; k < blocks_; ++k) {
    int next = -1;
    for (int block = 0; block < blocks_; ++block)
      if (place_[idx(block)] < 0 && (next < 0 || degree_[idx(block)] < degree_[idx(next)]))
        next = block;
    place_[idx(next)] = k;
    order_.push_back(next);
    std::vector<int>& neighbours = later_neighbours_[idx(k)];
    neighbours.clear();
    for (std::size_t w = 0; w < words; ++w)
      for (std::uint64_t left = adjacent_[idx(next) * words + w]; left != 0; left &= left - 1)
        neighbours.push_back(static_cast<int>(64 * w) + std::countr_zero(left));
    for (const int block : neighbours) {
      std::uint64_t* bits = &adjacent_[idx(block) * words];
      for (std::size_t w = 0; w < words; ++w) bits[w] |= adjacent_[idx(next) * words + w];
      bits[idx(next) / 64] &= ~(std::uint64_t{1} << (idx(next) % 64));
      bits[idx(block) / 64] &= ~(std::uint64_t{1} << (idx(block) % 64));
      count(block);
    }
  }
}

// The columns of the factor, and for each pair of entries of a column the entry that their product
// goes to: it exists, because elimination made the two neighbours.
void SparseBlocks::place_blocks() {
  column_begin_.assign(1, 0);
  row_.clear();
  for (int k = 0; k < blocks_; ++k) {
    row_.push_back(k);
    for (const int block : later_neighbours_[idx(k)]) row_.push_back(place_[idx(block)]);
    std::sort(row_.begin() + column_begin_.back(), row_.end());
    column_begin_.push_back(static_cast<int>(row_.size()));
  }
  value_.resize(row_.size());

  target_of_product_.clear();
  for (int k = 0; k < blocks_; ++k)
    for (int j = column_begin_[idx(k)] + 1; j < column_begin_[idx(k) + 1]; ++j) {
      int target = column_begin_[idx(row_[idx(j)])];
      for (int i = j; i < column_begin_[idx(k) + 1]; ++i) {
        while (row_[idx(target)] != row_[idx(i)]) ++target;
        target_of_product_.push_back(target);
      }
    }

  target_.clear();
  turned_.clear();
  for (const BlockPair& pair : joined_) {
    const int a = place_[idx(pair.first)];
    const int b = place_[idx(pair.second)];
    target_.push_back(entry(std::max(a, b), std::min(a, b)));
    turned_.push_back(a < b ? 1 : 0);
  }
  factor_work_ = 0;
  for (int k = 0; k < blocks_; ++k) {
    const std::int64_t below = column_begin_[idx(k) + 1] - column_begin_[idx(k)] - 1;
    factor_work_ += 56 + 126 * below + 108 * below * (below + 1);
  }
}

int SparseBlocks::entry(int row, int column) const {
  const auto begin = row_.begin() + column_begin_[idx(column)];
  const auto end = row_.begin() + column_begin_[idx(column) + 1];
  return static_cast<int>(std::lower_bound(begin, end, row) - row_.begin());
}

void SparseBlocks::clear() { std::fill(value_.begin(), value_.end(), Block{}); }

void SparseBlocks::add_to(int block, const Mat6& value) {
  double* v = value_[idx(column_begin_[idx(place_[idx(block)])])].v;
  for (int j = 0; j < 6; ++j)
    for (int i = 0; i < 6; ++i) v[6 * j + i] += value(i, j);
}

void SparseBlocks::add_to_pair(int pair, const Mat6& value) {
  double* v = value_[idx(target_[idx(pair)])].v;
  const bool turned = turned_[idx(pair)] != 0;
  for (int j = 0; j < 6; ++j)
    for (int i = 0; i < 6; ++i) v[6 * j + i] += turned ? value(j, i) : value(i, j);
}

// Column by column: the diagonal block is factored, the column divided by it, and the products of its
// blocks are subtracted from all that comes later.
void SparseBlocks::factor() {
  const int* target = target_of_product_.data();
  for (int k = 0; k < blocks_; ++k) {
    const int begin = column_begin_[idx(k)];
    const int end = column_begin_[idx(k) + 1];
    factor_diagonal(value_[idx(begin)].v);
    for (int i = begin + 1; i < end; ++i)
      divide_by_transposed(value_[idx(begin)].v, value_[idx(i)].v);
    for (int j = begin + 1; j < end; ++j)
      for (int i = j; i < end; ++i)
        subtract_product(value_[idx(i)].v, value_[idx(j)].v, value_[idx(*target++)].v);
  }
}

void SparseBlocks::solve(std::span<Vec6> x) {
  for (int k = 0; k < blocks_; ++k) x_[idx(k)] = x[idx(order_[idx(k)])];
  for (int k = 0; k < blocks_; ++k) {
    const int begin = column_begin_[idx(k)];
    solve_lower(value_[idx(begin)].v, x_[idx(k)].data());
    for (int i = begin + 1; i < column_begin_[idx(k) + 1]; ++i)
      subtract(value_[idx(i)].v, x_[idx(k)].data(), x_[idx(row_[idx(i)])].data());
  }
  for (int k = blocks_ - 1; k >= 0; --k) {
    const int begin = column_begin_[idx(k)];
    for (int i = begin + 1; i < column_begin_[idx(k) + 1]; ++i)
      subtract_transposed(value_[idx(i)].v, x_[idx(row_[idx(i)])].data(), x_[idx(k)].data());
    solve_upper(value_[idx(begin)].v, x_[idx(k)].data());
  }
  for (int k = 0; k < blocks_; ++k) x[idx(order_[idx(k)])] = x_[idx(k)];
}

}  // namespace tumble
