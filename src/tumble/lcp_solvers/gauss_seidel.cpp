/// \file
/// \brief Contact forces by projected Gauss-Seidel sweeps (thesis 2.6, 3.3.1).
#include "tumble/lcp_solvers/gauss_seidel.hpp"

#include "tumble/base/error.hpp"
#include "tumble/base/index.hpp"

#include <algorithm>
#include <cmath>

namespace tumble {
namespace {

// Puts row i right; returns by how much it was wrong, as lcp_residual() sees it: where the force is
// set to 0 that is A_ii f_i, otherwise a_i.
double put_right(const LcpProblem& problem, int i, std::span<double> f) {
  double a = problem.b[i];
  for (int j = 0; j < problem.size(); ++j) a += problem.A(i, j) * f[idx(j)];
  const double before = f[idx(i)];
  double& force = f[idx(i)];
  force = before - a / problem.A(i, i);
  if (is_equality(problem, i) || force >= 0.0) return std::abs(a);
  force = 0.0;
  return std::abs(problem.A(i, i) * before);
}

}  // namespace

GaussSeidelSolver::GaussSeidelSolver(const GaussSeidelOptions& options) : options_(options) {
  require::that(options.sweeps >= 0, "sweeps: give at least 0");
  require::that(options.multiplications >= 0, "multiplications: give at least 0");
  require::not_negative(options.residual, "residual");
}

void GaussSeidelSolver::solve(const LcpProblem& problem, LcpResult& result,
                              std::span<const int> start) {
  require_valid(problem, LcpMatrix::positive_diagonal);
  require_valid_start(problem.size(), start);
  begin(problem, result);
  const int n = problem.size();
  const double scale = n > 0 ? problem.b.cwiseAbs().maxCoeff() : 0.0;
  const double limit = options_.residual * (scale > 0.0 ? scale : 1.0);

  // A row is judged when it is visited and may be put wrong again by later ones. So when all were
  // right on their visit, the forces are judged once more as they are.
  complete(problem, result);
  while (!(result.residual <= options_.residual) && result.pivots < options_.sweeps &&
         result.multiplications < options_.multiplications) {
    double worst = 0.0;
    for (int i = 0; i < n; ++i) {
      const double wrong = put_right(problem, i, result.f);
      if (!(wrong <= worst)) worst = wrong;
      if (!std::isfinite(worst)) break;  // the next row would hide it
    }
    ++result.pivots;
    result.multiplications += std::int64_t{n} * (n + 1);

    // Only a matrix that the method is not for makes forces overflow.
    if (!std::isfinite(worst)) {
      result.status = LcpStatus::not_positive_semidefinite;
      std::fill(result.f.begin(), result.f.end(), 0.0);
      break;
    }
    if (worst <= limit) complete(problem, result);
  }
  complete(problem, result);
  if (result.status == LcpStatus::solved && !(result.residual <= options_.residual))
    result.status = LcpStatus::cap_reached;
  conclude(problem, result);  // rows in units much smaller than the others' may still be wrong
}

// The forces to begin with. Those of contacts may not pull.
void GaussSeidelSolver::begin(const LcpProblem& problem, LcpResult& result) const {
  const auto n = idx(problem.size());
  result.status = LcpStatus::solved;
  result.pivots = 0;
  result.multiplications = 0;
  if (!options_.warm || result.f.size() != n) {
    result.f.assign(n, 0.0);
    return;
  }
  for (int i = 0; i < problem.size(); ++i) {
    double& f = result.f[idx(i)];
    require::finite(f, "result.f, the forces to begin with");
    if (!is_equality(problem, i)) f = std::max(f, 0.0);
  }
}

}  // namespace tumble
