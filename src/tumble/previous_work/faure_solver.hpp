/// \file
/// \brief Faure's iteration for a complementarity problem (thesis 2.6.4).
#pragma once

#include "tumble/lcp_solvers/lcp.hpp"
#include "tumble/math/projected_descent.hpp"
#include "tumble/previous_work/tolerances.hpp"

namespace tumble {

/// Contact forces by steps down the energy, as many as there is time for.
///
/// See ProjectedDescent. Answers are `solved` if they hold, and `cap_reached` with the forces of the last step
/// if the budget ends before.
/// \par Cost
/// n² multiplications for each product; one or two products a step.
/// \see Faure, "An energy-based approach for contact force computation", Computer Graphics Forum 15(3), 1996.
/// \algorithm{Contact forces by steps down the energy: section 2.6.4}
/// \deviation{The paper begins with a global solution and redistributes energy; here each step is a conjugate direction down the energy.
/// What the thesis and the paper's abstract say of it holds: values for all unknowns after each step\, a constant time for it\, and
/// less energy without friction.}
/// \verified{Each step of Faure's iteration lowers the energy, and it ends at the answer of a direct solver}
class FaureSolver final : public LcpSolver {
 public:
  /// Makes a solver.
  /// \param budget  steps at most, at least 0
  /// \param wanted  [-] good enough, see lcp_residual(), at least 0
  explicit FaureSolver(int budget, double wanted = tolerance::faure_residual);

  [[nodiscard]] std::string_view name() const override { return "faure"; }

  /// \copydoc LcpSolver::solve
  /// \note Needs a symmetric A with a positive diagonal. `start` is checked and not used. `pivots` are steps
  void solve(const LcpProblem& problem, LcpResult& result,
             std::span<const int> start = {}) override;

 private:
  // The problem as ProjectedDescent asks for it.
  struct Dense {
    const LcpProblem& lcp;
    [[nodiscard]] double diagonal(std::size_t i) const {
      return lcp.A(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(i));
    }
    [[nodiscard]] double constant(std::size_t i) const {
      return lcp.b[static_cast<Eigen::Index>(i)];
    }
    void multiply(std::span<const double> x, std::span<double> out) const;
    void allow(std::span<double> f) const;
  };

  int budget_ = 0;
  double wanted_ = 0.0;
  ProjectedDescent<Dense> descent_;
};

}  // namespace tumble
