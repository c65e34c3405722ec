/// \file
/// \brief Baraff's pivoting, with equalities (thesis 3.3.1).
#pragma once

#include "tumble/lcp_solvers/lcp.hpp"
#include "tumble/lcp_solvers/least_constraint.hpp"
#include "tumble/lcp_solvers/twins.hpp"
#include "tumble/math/complementarity.hpp"

namespace tumble {

/// Contacts are taken up one after the other, and each new force grows until its contact stops
/// sinking, while those taken up before keep their conditions.
///
/// The algorithm itself is ComplementaritySolver, which every layer above math may use. Added here are
/// equalities: they are taken up first, each as two contacts that push against each other
/// (TwinProblem). And where A has lost the digits that decide, as with a dozen contacts in any
/// direction on each body of a chain, a problem that comes with factors is solved again with them
/// (LeastConstraintSolver) if the residual is above `tolerance::lost_in_A` or
/// there is none.
///
/// A has to be symmetric and positive semidefinite. Then `infeasible` means that there is no solution,
/// and a is unique; f is not if A is singular. Cost: about n + m pivots of O((n + m)²) for n rows, m of
/// them equalities; no allocation for a problem no larger than one before.
/// \see Baraff, "Fast contact force computation for nonpenetrating rigid bodies", SIGGRAPH 1994, 4.
/// \algorithm{Forces of resting contacts: section 3.3.1}
/// \verified{All exact solvers find one motion in 10000 contact problems with redundant contacts}
class BaraffSolver : public LcpSolver {
 public:
  /// Makes a solver.
  /// \param pivots_each pivots for each row, after which a problem ends as LcpStatus::cap_reached
  explicit BaraffSolver(int pivots_each = ComplementaritySolver::kPivotsEach)
      : pivots_each_(pivots_each), solver_(pivots_each) {}

  [[nodiscard]] std::string_view name() const override { return "baraff"; }

  /// Solves one problem.
  /// \param problem  A symmetric and positive semidefinite; if it is seen not to be semidefinite the
  ///                 status says so
  /// \param start    rows to begin with as pushing
  /// \throws std::invalid_argument as require_valid() and require_valid_start()
  void solve(const LcpProblem& problem, LcpResult& result,
             std::span<const int> start = {}) override;

 private:
  int pivots_each_;
  ComplementaritySolver solver_;
  ComplementarityResult answer_;
  TwinProblem twins_;
  LeastConstraintSolver with_factors_;
  std::vector<int> start_;
};

}  // namespace tumble
