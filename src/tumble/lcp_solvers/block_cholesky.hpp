/// \file
/// \brief Cholesky factor of a sparse matrix of 6×6 blocks: a block for each body and for each pair that touches.
#pragma once

#include "tumble/lcp_solvers/block_rows.hpp"

#include <cstdint>
#include <vector>

namespace tumble {

/// Solves \f$(\varepsilon I + \sum_{i \in C} g_i g_i^{\mathsf T})\, x = r\f$ for sets C of rows.
///
/// Two bodies have a block in common if a row touches both; see SparseBlocks for order and cost.
class BlockCholesky {
 public:
  /// Finds the order and the places of the blocks, unless the rows touch the same bodies as before.
  void analyse(const BlockRows& rows);

  /// Sets the matrix up and factors it.
  /// \param in_set    (n) not 0 for the rows of C
  /// \param softness  [-] \f$\varepsilon > 0\f$, large enough not to drown in rounding
  void factor(const BlockRows& rows, const std::vector<char>& in_set, double softness);

  /// Solves with the factor.
  /// \param x (blocks) r on the way in, x on the way out
  void solve(std::vector<Vec6>& x);

  /// \return [-] multiplications and divisions of all factor() and solve() since analyse()
  [[nodiscard]] std::int64_t multiplications() const { return multiplications_; }

 private:
  std::vector<BlockPair>
      joined_;  // for each row all pairs of its parts but those of a part with itself
  SparseBlocks matrix_;
  std::int64_t multiplications_ = 0;
};

}  // namespace tumble
