/// \file
/// \brief Contact forces by projected Gauss-Seidel sweeps (thesis 2.6, 3.3.1).
#pragma once

#include "tumble/lcp_solvers/lcp.hpp"
#include "tumble/lcp_solvers/tolerances.hpp"

namespace tumble {

/// Options of GaussSeidelSolver.
struct GaussSeidelOptions {
  int sweeps = 100000;  ///< [-] at most; at least 0
  std::int64_t multiplications =
      2'000'000'000;  ///< [-] at most, but for the last sweep; at least 0
  double residual = tolerance::gauss_seidel_residual;  ///< [-] good enough, see lcp_residual()
  bool warm = false;  ///< begin with the forces in `result`, if it has n of them; else with 0
};

/// Puts one row after the other right, as if no other force would change, until all are right at
/// once.
///
/// \f[ f_i \leftarrow \max\!\left(0,\; f_i - \frac{(A f + b)_i}{A_{ii}}\right) \f]
/// for i = 1 to n, without the maximum for equalities, and again. Each row lowers the energy
/// \f$\tfrac12 f^{\mathsf T}\!A f + b^{\mathsf T}\!f\f$ as far as it can alone, so for symmetric
/// positive semidefinite A it converges whenever there is a solution; redundant contacts do no
/// harm. It is slow where many rows have to agree: on a stack of n boxes a sweep takes the error to
/// \f$\cos^2(\pi/2n)\f$ of what it was, 0.994 for n = 20. Most of today's real-time engines
/// sweep, and hide it by starting from the forces of the last step.
/// \par How it ends
/// `solved` at the residual asked for; `cap_reached` after the sweeps or multiplications allowed, also where there is no
/// solution: the forces then grow without end; `not_positive_semidefinite`, with no forces, if they grew out of range, which an A
/// that is symmetric and semidefinite does not do.
/// \par Cost
/// n² + n multiplications a sweep.
/// \par Determinism
/// Rows are visited in their order, and the answer depends on it where f is not unique.
/// \see Jourdan, Alart, Jean, "A Gauss-Seidel like algorithm to solve frictional contact problems",
///      Computer Methods in Applied Mechanics and Engineering 155 (1998).
/// \algorithm{Contact forces by sweeps: section 3.3.1}
/// \verified{A sweep takes the error of a stack to the square of the cosine of pi over 2 n}
class GaussSeidelSolver final : public LcpSolver {
 public:
  /// Makes a solver.
  /// \throws std::invalid_argument for an option out of its range
  explicit GaussSeidelSolver(const GaussSeidelOptions& options = {});

  [[nodiscard]] std::string_view name() const override { return "gauss_seidel"; }

  /// \copydoc LcpSolver::solve
  /// \note Rows without their forces are no help to it: `start` is checked and not used. `pivots`
  ///       are sweeps. The diagonal of A must be positive
  /// \throws std::invalid_argument with the option `warm`, if a force in `result` is not finite
  void solve(const LcpProblem& problem, LcpResult& result,
             std::span<const int> start = {}) override;

 private:
  void begin(const LcpProblem& problem, LcpResult& result) const;

  GaussSeidelOptions options_;
};

}  // namespace tumble
