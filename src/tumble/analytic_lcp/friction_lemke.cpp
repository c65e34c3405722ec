/// \file
/// \brief Lemke's method for contacts with friction whose rows nearly depend on each other.
#include "tumble/analytic_lcp/friction_lemke.hpp"

#include "tumble/analytic_lcp/tolerances.hpp"

#include <cmath>
#include <limits>

namespace tumble {

FrictionLemkeSolver::FrictionLemkeSolver()
    : slack_solvers_{LemkeSolver({.pivot_cap = kSlackPivots, .slack = tolerance::slack}),
                     LemkeSolver({.pivot_cap = kSlackPivots, .slack = 100.0 * tolerance::slack})} {}

void FrictionLemkeSolver::solve(const LcpProblem& problem, LcpResult& result,
                                std::span<const int> start) {
  int pivots = 0;
  std::int64_t multiplications = 0;
  double least = std::numeric_limits<double>::infinity();
  const auto tried = [&](bool solved) {
    pivots += result.pivots;
    multiplications += result.multiplications;
    if (!solved && result.residual < least) {
      least = result.residual;
      nearest_ = result.f;
    }
    return solved;
  };
  const auto solves = [&](LcpSolver& solver) {
    solver.solve(problem, result, start);
    return tried(result.solved_within(tolerance::step_residual));
  };
  bool solved = solves(slack_solvers_[0]) || solves(slack_solvers_[1]);
  const bool small = problem.size() <= kMostToTryAll;
  const std::int64_t most = small ? std::numeric_limits<std::int64_t>::max() : kMostWork;
  for (const double share : {1.0, 0.1, 10.0, 0.01, 100.0})
    for (LemkeSolver& solver : slack_solvers_)
      if (!solved && multiplications < most)
        solved = tried(approach(problem, share * tolerance::compliance, most - multiplications,
                                solver, result));
  if (small && !solved) solved = solves(exact_solver_);
  // Masses that differ by thousands leave rows in units that do.
  if (small && !solved && restarts_.solve(problem, result))
    solved = tried(result.solved_within(tolerance::step_residual));
  if (!solved) {
    if (result.status == LcpStatus::solved) result.status = LcpStatus::singular;
    if (least < std::numeric_limits<double>::infinity()) {
      result.f = nearest_;
      complete(problem, result);
    }
  }
  result.pivots = pivots;
  result.multiplications = multiplications;
}

// Rounds of the proximal point method, of about so many multiplications at most. Leaves the count of all of them in the result.
bool FrictionLemkeSolver::approach(const LcpProblem& problem, double compliance, std::int64_t most,
                                   LcpSolver& solver, LcpResult& result) {
  yielding_.A = problem.A;
  yielding_.A.diagonal() *= 1.0 + compliance;
  yielding_.b = problem.b;
  yielding_.equality = problem.equality;
  int pivots = 0;
  std::int64_t multiplications = 0;
  bool solved = false;
  for (int round = 0; round < kMostRounds && !solved && multiplications < most; ++round) {
    solver.solve(yielding_, result);
    pivots += result.pivots;
    multiplications += result.multiplications;
    if (result.status != LcpStatus::solved || !std::isfinite(result.residual)) break;
    for (int i = 0; i < problem.size(); ++i)
      yielding_.b[i] =
          problem.b[i] - compliance * problem.A(i, i) * result.f[static_cast<std::size_t>(i)];
    complete(problem, result);
    solved = result.solved_within(tolerance::step_residual);
  }
  result.pivots = pivots;
  result.multiplications = multiplications;
  return solved;
}

}  // namespace tumble
