/// \file
/// \brief Cholesky factors of sparse symmetric matrices of 6×6 blocks.
#pragma once

#include "tumble/base/types.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace tumble {

using Vec6 = Eigen::Matrix<double, 6, 1>;  ///< six numbers of one body
using Mat6 = Eigen::Matrix<double, 6, 6>;  ///< and what couples two bodies

/// Two blocks of unknowns that have a block of the matrix in common.
struct BlockPair {
  int first = 0;   ///< the one
  int second = 0;  ///< another one

  /// Compares both.
  bool operator==(const BlockPair&) const = default;
};

/// A symmetric positive definite matrix of 6×6 blocks, few of which are not 0, and its factors.
///
/// Factoring joins the neighbours of each block that is eliminated. Blocks are therefore eliminated
/// in the order of fewest neighbours left, ties by number; where the blocks of the factor are and
/// which products go into which is found out once and kept as long as the pattern stays.
/// \par Use
/// analyse(), clear(), add_to() for all that the matrix is the sum of, factor(), then solve() as
/// often as wanted.
/// \par Cost
/// For b blocks analyse() takes O(b²) and b² bits of memory; a factorisation of a planar pile about
/// b^1.5 products of 6×6 blocks. No allocation once the storage is warm.
/// \par Determinism
/// Every sum has one order: blocks of fixed size, added in the order of elimination.
/// \see Tinney, Walker, "Direct solutions of sparse network equations by optimally ordered triangular
///      factorization", Proceedings of the IEEE 55 (1967).
class SparseBlocks {
 public:
  /// Finds the order and the places of the blocks, unless the pattern is the one of the last call.
  /// \param joined  which of them are coupled; a pair may come more than once
  /// \return whether the pattern is another one: then nothing is factored
  /// \throws std::invalid_argument for a block out of range or coupled to itself
  bool analyse(int blocks, std::span<const BlockPair> joined);

  /// Sets all entries to 0.
  void clear();

  /// Adds to the block of one block of unknowns with itself.
  /// \param value  symmetric
  void add_to(int block, const Mat6& value);

  /// Adds to the block that couples two blocks of unknowns.
  /// \param pair   its place in the list that analyse() got
  /// \param value  rows belong to the pair's first, columns to its second
  void add_to_pair(int pair, const Mat6& value);

  /// Factors the matrix. What was added is gone: clear() comes before the next sum. If the matrix is positive definite
  /// but for rounding only, solve() finds numbers that are not finite.
  void factor();

  /// Solves with the factors.
  /// \param x  one for each block: right-hand side in, solution out
  void solve(std::span<Vec6> x);

  /// The cost of factor(): multiplications and divisions.
  [[nodiscard]] std::int64_t multiplications_of_factor() const { return factor_work_; }
  /// The cost of solve(): multiplications and divisions.
  [[nodiscard]] std::int64_t multiplications_of_solve() const {
    return 42 * std::int64_t{blocks_} +
           72 * (static_cast<std::int64_t>(row_.size()) - std::int64_t{blocks_});
  }

 private:
  // Column by column; of a block on the diagonal the lower triangle counts, and once factored its
  // diagonal holds reciprocals.
  struct Block {
    double v[36];
  };

  void find_order();
  void place_blocks();
  [[nodiscard]] int entry(int row, int column) const;

  int blocks_ = -1;
  std::vector<BlockPair> joined_;  // the pattern that was analysed
  std::vector<int> target_;        // (pairs) entry of the pair's block
  std::vector<char> turned_;       // (pairs) whether the entry's rows belong to the pair's second

  std::vector<int> order_;              // (blocks) which block is eliminated when
  std::vector<int> place_;              // (blocks) the inverse of order_
  std::vector<int> column_begin_;       // (blocks+1) entries of a column, the diagonal first
  std::vector<int> row_;                // (entries) place of the row, ascending within a column
  std::vector<int> target_of_product_;  // where the products of a column's pairs of entries go
  std::vector<std::vector<int>> later_neighbours_;  // (blocks) while the order is sought
  std::vector<std::uint64_t> adjacent_;  // (blocks×words) bits, while the order is sought
  std::vector<int> degree_;              // (blocks) while the order is sought

  std::vector<Block> value_;  // (entries)
  std::vector<Vec6> x_;       // (blocks) in the order of elimination
  std::int64_t factor_work_ = 0;
};

}  // namespace tumble
