/// \file
/// \brief Cholesky factor of a sparse matrix of 6×6 blocks: the bodies of a heap and who touches whom.
///
/// Uses no other chapter.
#pragma once

#include "tumble/analytic_lcp/block_rows.hpp"

#include <cstdint>
#include <vector>

namespace tumble {

/// Solves \f$(\varepsilon I + \sum_{i \in C} g_i g_i^{\mathsf T})\, x = r\f$ for sets C of rows.
///
/// Two bodies have a block in common if a row touches both, and factoring joins the neighbours of
/// each body that is eliminated. Bodies are therefore eliminated in the order of fewest neighbours
/// left, ties by number; where the blocks of the factor are and which products go into which is found
/// out once and kept as long as the rows touch the same bodies.
/// \par Cost
/// For b bodies the first look takes O(b²) and b² bits of memory; a factorisation of a planar pile
/// about b^1.5 products of 6×6 blocks.
/// \par Determinism
/// Every sum has one order: blocks of fixed size, added in the order of elimination.
/// \see Tinney, Walker, "Direct solutions of sparse network equations by optimally ordered triangular
///      factorization", Proceedings of the IEEE 55 (1967).
class BlockCholesky {
 public:
  /// Finds the order and the places of the blocks, unless the rows touch the same bodies as before.
  /// \param rows which bodies they touch
  void analyse(const BlockRows& rows);

  /// Sets the matrix up and factors it.
  /// \param rows      as in analyse()
  /// \param in_set    (n) not 0 for the rows of C
  /// \param softness  [-] \f$\varepsilon > 0\f$, large enough not to drown in rounding
  void factor(const BlockRows& rows, const std::vector<char>& in_set, double softness);

  /// Solves with the factor.
  /// \param x (blocks) r on the way in, x on the way out
  void solve(std::vector<Vec6>& x);

  /// \return [-] multiplications and divisions of all factor() and solve() since analyse()
  [[nodiscard]] std::int64_t multiplications() const { return multiplications_; }

 private:
  // Column by column; of a block on the diagonal the lower triangle counts, and once factored its
  // diagonal holds reciprocals.
  struct Block {
    double v[36];
  };

  void find_order(const BlockRows& rows);
  void place_blocks();
  void place_rows(const BlockRows& rows);
  [[nodiscard]] int entry(int row, int column) const;
  void assemble(const BlockRows& rows, const std::vector<char>& in_set, double softness);

  int blocks_ = -1;
  std::vector<int> begin_of_rows_;   // the pattern that was analysed
  std::vector<int> blocks_of_rows_;  // the same

  std::vector<int> order_;              // (blocks) which block is eliminated when
  std::vector<int> place_;              // (blocks) the inverse of order_
  std::vector<int> column_begin_;       // (blocks+1) entries of a column, the diagonal first
  std::vector<int> row_;                // (entries) place of the row, ascending within a column
  std::vector<int> target_of_product_;  // where the products of a column's pairs of entries go
  std::vector<int> target_of_pair_;     // where the products of a row's pairs of parts go
  std::vector<std::vector<int>> later_neighbours_;  // (blocks) while the order is sought
  std::vector<std::uint64_t> adjacent_;  // (blocks×words) bits, while the order is sought

  std::vector<Block> value_;  // (entries)
  std::vector<Vec6> x_;       // (blocks) in the order of elimination
  std::int64_t multiplications_ = 0;
};

}  // namespace tumble
