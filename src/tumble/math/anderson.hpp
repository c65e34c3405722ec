/// \file
/// \brief Anderson acceleration of a fixed-point iteration.
#pragma once

#include "tumble/math/dense.hpp"

#include <array>

namespace tumble {

/// Anderson acceleration: the next point of a fixed-point iteration \f$x \mapsto g(x)\f$ from its last results.
///
/// Of a linear iteration, points whose weights sum to 1 have a change \f$f = g(x) - x\f$ of the same weights. The next point has
/// the smallest one:
/// \f[ x = g_k - \sum_j y_j\,(g_k - g_j), \qquad \min_y \bigl|f_k - \sum_j y_j\,(f_k - f_j)\bigr|, \f]
/// over the results j before. Where changes grow, as the iteration is far from linear, it begins anew.
/// \par Cost
/// Per step, with n numbers in f and m in g: some 30 n + 6 m multiplications. Storage is kept.
/// \see Anderson 1965, Iterative procedures for nonlinear integral equations; Walker and Ni 2011, Anderson acceleration for
///      fixed-point iterations.
/// \verified{Anderson acceleration solves a linear iteration in as many steps as it has unknowns}
class AndersonAcceleration {
 public:
  static constexpr std::size_t kDepth = 3;  ///< results before the last one that are used

  /// Forgets all results.
  void start() { count_ = 0; }

  /// Takes a result of the iteration, and extrapolates.
  /// \param change  \f$f_k\f$, in a norm of the caller's choice, of the same length since start()
  /// \param x       \f$g_k\f$ in, the next point out
  void extrapolate(const VecX& change, VecX& x);

 private:
  std::size_t count_ = 0;             // results since start
  double length_ = 0.0;               // |f| of the last one
  std::array<VecX, kDepth> changes_;  // f_j, the oldest at count_ % kDepth
  std::array<VecX, kDepth> results_;  // g_j
  MatX differences_;                  // f_k - f_j
  VecX step_;                         // sum of y_j (g_k - g_j)
  OrthogonalFactor factor_;
};

}  // namespace tumble
