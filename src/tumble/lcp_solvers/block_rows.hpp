/// \file
/// \brief A positive semidefinite matrix as products of short rows: contacts seen from the bodies.
#pragma once

#include "tumble/lcp_solvers/lcp.hpp"
#include "tumble/lcp_solvers/mass_root.hpp"
#include "tumble/math/sparse_blocks.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace tumble {

/// The rows g_i of a matrix G with A_ij = |g_i| |g_j| g_i·g_j, where each g_i has length 1.
///
/// | symbol | meaning | unit |
/// |---|---|---|
/// | S | a root of the inverse masses, W = S Sᵀ | kg^-1/2, (kg m²)^-1/2 |
/// | \f$\ell_i\f$ | length of row i of J S, \f$\ell_i^2 = A_{ii}\f$ | kg^-1/2 |
/// | g_i | row i of J S, divided by its length | - |
/// | z | what contacts add to the accelerations, in the root of masses, S z | m kg^1/2 / s² |
///
/// A row is stored in blocks of six numbers, one for each body in it: two for a contact. A matrix that
/// comes without bodies is factored first, by Cholesky's method with the largest pivot left; its rows
/// then have as many blocks as the rank asks for.
class BlockRows {
 public:
  /// Takes a problem apart.
  /// \param problem  a valid one; with factors these are used, otherwise A
  /// \return false if A comes without factors and is not positive semidefinite
  /// \throws std::invalid_argument if the factors make no sense, or the diagonal of J W Jᵀ is not
  ///         that of A
  bool take(const LcpProblem& problem);

  /// \return n
  [[nodiscard]] int size() const { return static_cast<int>(length_.size()); }
  /// \return how many blocks z has
  [[nodiscard]] int blocks() const { return blocks_; }
  /// \return [kg^-1/2] \f$\ell_i\f$; 0 for a row that moves nothing, which has no blocks
  [[nodiscard]] double length(int i) const { return length_[static_cast<std::size_t>(i)]; }
  /// Where each row begins: (n+1) positions in blocks_of_rows() and parts().
  [[nodiscard]] const std::vector<int>& begin_of_rows() const { return begin_; }
  /// \return the blocks of z that the rows have a part in, row by row
  [[nodiscard]] const std::vector<int>& blocks_of_rows() const { return block_; }
  /// \return these parts
  [[nodiscard]] const std::vector<Vec6>& parts() const { return part_; }

  /// y_i = g_i·z for all rows.
  /// \param z  (blocks) accelerations
  /// \param y  (n) relative accelerations
  void project(const std::vector<Vec6>& z, std::span<double> y) const;

  /// z = Σ f_i g_i.
  /// \param f  (n) forces
  /// \param z  (blocks) what they do to the bodies
  void gather(std::span<const double> f, std::vector<Vec6>& z) const;

  /// \return [-] multiplications of project(), or of gather()
  [[nodiscard]] std::int64_t multiplications() const {
    return 6 * static_cast<std::int64_t>(part_.size());
  }
  /// \return [-] multiplications of take()
  [[nodiscard]] std::int64_t multiplications_of_take() const { return taking_; }

 private:
  void take_factors(const LcpProblem& problem);
  bool take_matrix(const MatX& A);
  int factor(const MatX& A);
  void append(int block, const Vec6& part);
  void end_row();

  int blocks_ = 0;
  std::vector<int> begin_;
  std::vector<int> block_;
  std::vector<Vec6> part_;
  std::vector<double> length_;
  std::int64_t taking_ = 0;

  MassRoots roots_;
  MatX lower_;                // (n×n or larger) Cholesky factor, rows in A's order
  std::vector<double> left_;  // (n) diagonal of what is left of A
  std::vector<char> taken_;   // (n) whether a row has been a pivot
};

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
