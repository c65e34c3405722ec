/// \file
/// \brief Least squares with forces that cannot pull: the nearest point of a cone.
#pragma once

#include "tumble/math/complementarity.hpp"
#include "tumble/math/dense.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace tumble {

/// Answer of NonNegativeLeastSquares; keep it, its storage is used again.
struct LeastSquaresResult {
  ComplementarityStatus status = ComplementarityStatus::solved;  ///< solved or cap_reached
  std::vector<double> f;                                         ///< [any] (n) factors, f >= 0
  std::vector<double> rest;          ///< [any] (m) d - G f, unique where f is not
  std::vector<int> pushing;          ///< columns in use, ascending: a start for the next solve
  int pivots = 0;                    ///< how often a column began or ceased to be used
  double distance = 0.0;             ///< [any] |rest|, the distance of d from the cone
  std::int64_t multiplications = 0;  ///< [-] the work done, whatever the machine
};

/// Finds f >= 0 that makes |G f - d| least: the point nearest to d in the cone of G's columns.
///
/// With contact wrenches as columns and a load as d, a distance of 0 says that the contacts can
/// hold the load. Written as f·a = 0 with A = GᵀG and b = -Gᵀd this is what
/// ComplementaritySolver solves, too. It is done apart because forming GᵀG loses twice as many digits
/// as the problem deserves, and because here a solution always exists and each change of
/// the set lowers the distance, so that the method ends without rules against cycling.
/// \par Cost and determinism
/// About n pivots of O(m n); no allocation for a problem no larger than one before. Of equal
/// candidates the lowest index is taken: the same input, the same bits.
/// \see Lawson and Hanson, Solving Least Squares Problems, 1974, chapter 23; Wilhelmsen, "A nearest
///      point algorithm for convex polyhedral cones", Mathematics of Computation 30 (1976).
class NonNegativeLeastSquares {
 public:
  /// Solves one problem.
  /// \param G      [any] (m×n) columns, the generators of the cone; dependent ones are welcome
  /// \param result the answer; all of it is overwritten. n = 0 gives f empty and distance |d|
  /// \param start  columns to begin with, see ComplementaritySolver::solve(); may be
  ///               `result.pushing` itself
  /// \throws std::invalid_argument if sizes differ, a number is not finite, or an index of start is
  ///         out of range or given twice
  void solve(const MatRef& G, const VecRef& d, LeastSquaresResult& result,
             std::span<const int> start = {});

 private:
  enum class Column : std::uint8_t { free, used, useless };

  void begin(const MatRef& G, std::span<const int> start);
  void mark(int tried);
  [[nodiscard]] int steepest(const MatRef& G, const LeastSquaresResult& result) const;
  void descend(const MatRef& G, const VecRef& d, LeastSquaresResult& result);
  void update_rest(const MatRef& G, const VecRef& d, LeastSquaresResult& result) const;

  OrthogonalFactor factor_;      // of the columns in use
  std::vector<Column> columns_;  // (n) what is known of each column
  std::vector<double> length_;   // (n) |G_j|
  std::vector<double> target_;   // (|P|) the best factors for the columns in use, of any sign
  std::vector<int> start_;       // copy of the warm start
  double size_of_target_ = 0.0;  // |d|
};

}  // namespace tumble
