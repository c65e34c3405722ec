/// \file
/// \brief Lemke's method for contacts with friction whose rows nearly depend on each other (thesis
///        2.6.3).
#pragma once

#include "tumble/lcp_solvers/lemke_restarts.hpp"

#include <array>

namespace tumble {

/// Lemke's method in several ways, until an answer holds.
///
/// Corners of boxes that have turned by 1e-8 since they lay flat have rows that depend on each other to
/// as much. A path through such bases loses its digits, and then its way. In turn:
/// 1. with a little slack (LemkeOptions::slack): fast, and exact where it succeeds;
/// 2. with points that yield by the part ε more to their own push, A + ε D with the diagonal D, which
///    makes rows independent, and again with \f$b - \varepsilon D f\f$ for the f just found. This is the
///    proximal point method: f stays where \f$A f + b\f$ solves the problem itself, and the error falls,
///    by about ε each time where rows do not depend on each other; with four more ε if need be;
/// 3. with the lexicographic rule and no slack;
/// 4. in rows of unit diagonal and from other bases (LemkeRestarts).
///
/// Above kMostToTryAll unknowns 2 ends after kMostWork multiplications, and 3 and 4 are left out; above
/// kMostUnknowns it is better not asked at all (FrictionSweeps).
/// \see Rockafellar, "Monotone operators and the proximal point algorithm", SIAM J. Control Optim. 14,
///      1976.
class FrictionLemkeSolver : public LcpSolver {
 public:
  static constexpr int kMostUnknowns =
      400;  ///< of problems that are solved in a fraction of a second
  static constexpr int kMostToTryAll = 150;  ///< of problems for which every way is tried
  static constexpr std::int64_t kMostWork =
      100'000'000;  ///< multiplications of a larger one; a path that arrives takes about 2 N³

  /// Makes its three solvers.
  FrictionLemkeSolver();

  [[nodiscard]] std::string_view name() const override { return "friction_lemke"; }

  /// Solves one problem.
  /// \param problem  any square matrix
  /// \param result   the answer; `solved` only if its residual is at most `tolerance::step_residual`.
  ///                 Unless solved, f is the one of least residual
  /// \param start    is ignored
  /// \throws std::invalid_argument as require_valid() and require_valid_start()
  void solve(const LcpProblem& problem, LcpResult& result,
             std::span<const int> start = {}) override;

 private:
  bool approach(const LcpProblem& problem, double compliance, std::int64_t most, LcpSolver& solver,
                LcpResult& result);

  // Slack lets the method run in circles. A problem takes about half as many pivots as it has unknowns,
  // and one of a thousand unknowns is too large for a dense method anyway.
  static constexpr int kSlackPivots = 1000;
  static constexpr int kMostRounds = 8;

  std::array<LemkeSolver, 2> slack_solvers_;
  LemkeSolver exact_solver_;
  LemkeRestarts restarts_;
  LcpProblem yielding_;          // A + eps D, b - eps D f
  std::vector<double> nearest_;  // forces of the least residual so far
};

}  // namespace tumble
