/// \file
/// \brief Forces that violate the conditions of contact least, where there may be no solution.
#pragma once

#include "tumble/lcp_solvers/row_scaling.hpp"
#include "tumble/lcp_solvers/twins.hpp"
#include "tumble/math/complementarity.hpp"

namespace tumble {

/// Finds the forces of a symmetric positive semidefinite problem that violate its conditions least, and
/// of these about the smallest.
///
/// Rows and columns are divided by \f$\sqrt{A_{ii}}\f$, so that units of rows do not matter. Of the scaled
/// problem, with a small softness \f$\varepsilon\f$,
/// \f[ 0 \le f_{k+1} \perp (A + \varepsilon I) f_{k+1} + b - \varepsilon f_k \ge 0, \qquad f_0 = 0 \f]
/// has one solution each. If the problem has solutions, \f$f_k\f$ tends to one of them. If it has none, \f$f_k\f$ grows
/// by equal amounts, and \f$v = \varepsilon (f_{k+1} - f_k)\f$ is the least change of b, by the sum of
/// squares, after which there is one. Then the same is done once more with b + v from f = 0: without
/// the growth, the forces stay small.
/// \par How it ends
/// `solved` if the answer passes holds(). Else by its residual: `least_violation` up to `tolerance::inconsistent`, above it
/// `infeasible`; but `singular` if the violation does not show beside the largest load, so that the rounds are blind for it.
/// `not_positive_semidefinite` if A is seen not to be.
/// \par Cost
/// Some ten problems of ComplementaritySolver, each with the start of the one before.
/// \see Rockafellar, "Monotone operators and the proximal point algorithm", SIAM Journal on Control and
///      Optimization 14 (1976).
/// \algorithm{Forces that violate the conditions of contact least: section 3.3.1}
/// \verified{Problems that are consistent but for a little get small forces from every solver}
class LeastViolation {
 public:
  /// Solves one problem.
  /// \param problem  A symmetric; others are refused by the status
  /// \param result   the answer; `pivots` and `multiplications` are of all problems together
  void solve(const LcpProblem& problem, LcpResult& result);

 private:
  bool scale(const LcpProblem& problem);
  bool approach(LcpResult& result);
  double residual(std::span<const double> f);

  ScaledProblem units_;
  LcpProblem scaled_;             // the scaled problem, b of unit size
  std::vector<double> f_, next_;  // (n) forces of two rounds, scaled
  std::vector<double> a_;         // (n) accelerations
  LcpProblem soft_;               // with softness, and b of a round
  TwinProblem twins_;
  ComplementaritySolver solver_;
  ComplementarityResult answer_;
  double largest_ = 1.0;  // [m/s²] by which b has been divided
};

}  // namespace tumble
