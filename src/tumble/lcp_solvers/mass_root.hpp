/// \file
/// \brief The root of the inverse masses of a problem's bodies (thesis 2.6.2).
#pragma once

#include "tumble/lcp_solvers/lcp.hpp"
#include "tumble/math/sparse_blocks.hpp"

#include <vector>

namespace tumble {

/// S with W = S Sᵀ, body by body, lower triangular by Cholesky's method.
///
/// Where W is rigid, so is S: a pivot that is only rounding (`tolerance::rigid`) leaves a column of
/// zeros.
class MassRoots {
 public:
  /// Takes the roots.
  /// \param factors  valid ones
  void take(const LcpFactors& factors);

  /// The part of a body in a row of J S.
  /// \param linear_w   [-] the body's part of the row of J
  /// \param angular_w  [m] ditto
  /// \return [kg^-1/2] the part of the row of J S
  [[nodiscard]] Vec6 part(int body, const Vec3& linear_w, const Vec3& angular_w) const;

  /// S z.
  /// \param z  [m kg^1/2 / s²] its acceleration in the root of masses
  /// \return [m/s², rad/s²] \f$\dot v\f$, \f$\dot\omega\f$ in the world frame
  [[nodiscard]] Vec6 acceleration(int body, const Vec6& z) const;

 private:
  std::vector<Vec3> mass_;       // (bodies) upper left block of S, its diagonal
  std::vector<Mat3> inertia_w_;  // (bodies) lower right block of S
};

/// Refuses factors that make no sense, or of which there are not as many rows as A has.
/// \throws std::invalid_argument as require_valid(), or naming both numbers
void require_factors_fit(const LcpProblem& problem);

/// Refuses factors whose product has another diagonal than A.
/// \param product  [1/kg] the diagonal entry of J W Jᵀ
/// \throws std::invalid_argument naming the row and both numbers
void require_diagonal(const LcpProblem& problem, int row, double product);

}  // namespace tumble
