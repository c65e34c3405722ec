/// \file
/// \brief Contact forces by Gauss' principle of least constraint (thesis 2.6.2).
#pragma once

#include "tumble/lcp_solvers/block_rows.hpp"
#include "tumble/math/least_squares.hpp"

namespace tumble {

/// Finds the accelerations that obey the contacts and differ least from those of free bodies.
///
/// Gauss: of all accelerations that the constraints allow, nature takes those with the least
/// \f$\tfrac12 (\ddot x - \ddot x_{free})^{\mathsf T} W^{-1} (\ddot x - \ddot x_{free})\f$. The
/// unknowns are 6 numbers for each body, however many contacts there are:
///
/// | symbol | meaning | unit |
/// |---|---|---|
/// | x | what the contacts add to the free accelerations, 6 for each body | m/s², rad/s² |
/// | S | a root of the inverse masses, W = S Sᵀ; x = S z | kg^-1/2, (kg m²)^-1/2 |
/// | G | J S transposed, a column for each row of the problem | kg^-1/2 |
/// | z | x measured in the root of masses, so that Gauss' sum is z·z / 2 | m kg^1/2 / s² |
///
/// \f[ \min_z |z|^2 \quad\text{with}\quad G^{\mathsf T} z + b \ge 0 \f]
/// is the point nearest to the origin in a polyhedron. One more coordinate makes the polyhedron a
/// cone: u >= 0 that brings \f$\binom{G}{-b^{\mathsf T}/s}\,u\f$ nearest to (0, 1) gives
/// \f$z = s\,G u / t\f$ and the forces \f$f = s\,u / t\f$, t the last coordinate of the vector from there to
/// (0, 1). This is Wilhelmsen's nearest point of a cone, done by NonNegativeLeastSquares. The scale s, about |z|,
/// keeps t about 1/2.
///
/// f solves the complementarity problem with A = GᵀG = J W Jᵀ and the same b: the principle and the
/// law of forces that only push are one. x and a are unique where f is not; no redundant contact
/// needs special care, and no more than 6 columns per body are ever in use, plus one.
/// \par How it ends
/// `solved`, `infeasible` for constraints that contradict each other, `cap_reached`.
/// \par Cost
/// A pivot takes O(m (n + p)) for m = 6 bodies + 1, n rows, p of them in use; G is taken to be
/// dense.
/// \see Redon, Kheddar, Coquillart, "Gauss' least constraints principle and rigid body
///      simulations", ICRA 2002; Wilhelmsen, "A nearest point algorithm for convex polyhedral
///      cones", Mathematics of Computation 30 (1976); Lawson and Hanson, Solving Least Squares
///      Problems, 1974, 23.4.
/// \algorithm{Gauss' principle of least constraint: section 2.6.2}
/// \verified{All exact solvers find one motion in 10000 contact problems with redundant contacts}
class LeastConstraintSolver final : public LcpSolver {
 public:
  [[nodiscard]] std::string_view name() const override { return "least_constraint"; }

  /// \copydoc LcpSolver::solve
  /// \note Without factors, G is a Cholesky factor of A, and a matrix that is not positive semidefinite gets
  ///       that status. `start` and equalities are used
  /// \throws std::invalid_argument if factors are given that make no sense or are not those of A
  void solve(const LcpProblem& problem, LcpResult& result,
             std::span<const int> start = {}) override;

  /// What the contacts of the last problem add to the accelerations of the bodies, if it was
  /// solved.
  /// \return [m/s², rad/s²] (6 per body; empty without factors) \f$\dot v\f$, \f$\dot\omega\f$ in the world frame, as the
  ///         bodies are numbered in the factors
  [[nodiscard]] std::span<const double> added_accelerations() const { return x_; }

 private:
  bool set_up_columns(const LcpProblem& problem);
  void set_size(const LcpProblem& problem, int blocks);
  void take_matrix_columns();
  void take_body_columns(const LcpProblem& problem);
  [[nodiscard]] double farthest_constraint(const LcpProblem& problem) const;
  bool project(const LcpProblem& problem, double scale);
  void take_forces(const LcpProblem& problem, double scale, LcpResult& result);

  NonNegativeLeastSquares nearest_;
  LeastSquaresResult cone_;    // u, (0, 1) - E u, and the columns in use
  MatX E_;                     // (m×n+e) columns (G_i, -b_i/s), then the e equalities, negative
  VecX target_;                // (m) (0, 1)
  std::vector<int> mirrored_;  // (e) rows that are equalities
  MassRoots roots_;
  BlockRows rows_;         // of A alone
  std::vector<double> x_;  // (6 bodies) see added_accelerations()
};

}  // namespace tumble
