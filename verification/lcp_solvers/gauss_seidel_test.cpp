/// \file
/// \brief Gauss-Seidel sweeps against problems by hand, their exact rate, and the exact solver.
#include "tumble/lcp_solvers/gauss_seidel.hpp"

#include "tumble/math/complementarity.hpp"

#include "lcp_solvers/random_contacts.hpp"
#include "support/test.hpp"

namespace {

LcpResult solved(const LcpProblem& problem, const GaussSeidelOptions& options = {}) {
  return solved_with<GaussSeidelSolver>(problem, options);
}

}  // namespace

TEST_CASE("A row that is an equality may pull", "[exact][lcp][analytic_lcp]") {
  // The second contact is glue: a_2 = 0 whatever its force.
  LcpProblem problem = lcp({2, 1, 1, 2}, {-1, 4});
  CHECK(near(solved(problem).f, {0.5, 0}, 1e-8));
  problem.equality = {0, 1};
  const LcpResult result = solved(problem);
  CHECK(near(result.f, {2, -3}, 1e-8));
  CHECK(near(result.a, {0, 0}, 1e-8));
  CHECK(result.pushing == std::vector<int>{0, 1});
}

TEST_CASE("A sweep takes the error of a stack to the square of the cosine of pi over 2 n",
          "[exact][lcp][analytic_lcp]") {
  // Passes until all forces are right to a millionth of the weight: as theory has it.
  const int passes[] = {20, 136, 550, 2204};
  int stacks = 0;
  for (const int n : {2, 5, 10, 20}) {
    const LcpProblem problem = stack(n);
    GaussSeidelSolver sweep({.sweeps = 1, .residual = 0.0, .warm = true});
    LcpResult result;
    double before = 0.0;
    double error = 9.81 * n;
    int pass = 0;
    while (error > 9.81e-6 * n) {
      sweep.solve(problem, result);
      before = error;
      error = 0.0;
      for (int k = 0; k < n; ++k)
        error = std::max(error, std::abs(result.f[idx(k)] - 9.81 * (n - k)));
      ++pass;
    }
    const double cosine = elementary::cos(0.5 * std::numbers::pi / n);
    // 1e-9: rounding of forces, 3e-14 N, beside the error itself, 2e-5 N (measured 9e-11).
    CHECK(std::abs(error / before - cosine * cosine) <= 1e-9);
    CHECK(pass == passes[stacks++]);
  }
}

TEST_CASE("Sweeps that begin with the former forces need none for the same problem",
          "[unit][lcp][analytic_lcp]") {
  GaussSeidelSolver solver({.warm = true});
  LcpResult result;
  LcpProblem problem = stack(10);
  solver.solve(problem, result);
  const int cold = result.pivots;  // measured 800
  CHECK(cold > 500);
  solver.solve(problem, result);
  CHECK(result.pivots == 0);
  CHECK(result.status == LcpStatus::solved);
  problem.b[0] *= 1.001;
  solver.solve(problem, result);
  CHECK(result.pivots < cold);  // measured 521: three digits of nine were there already
  CHECK(result.residual <= 1e-9);
  result.f.assign(10, -5.0);  // contacts cannot begin by pulling
  solver.solve(problem, result);
  CHECK(result.pivots == solved(problem).pivots);
  result.f[3] = kNan;
  CHECK_THROWS_WITH(solver.solve(problem, result), Contains("result.f"));
}

TEST_CASE("Sweeps that lead nowhere end at the cap or when forces overflow",
          "[unit][lcp][analytic_lcp]") {
  const LcpResult squeezed = solved(lcp({1, -1, -1, 1}, {-1, -1}), {.sweeps = 100});
  CHECK(squeezed.status == LcpStatus::cap_reached);
  CHECK(squeezed.pivots == 100);
  CHECK(squeezed.multiplications == 100 * 2 * 3);
  CHECK(squeezed.f[0] > 100.0);  // they press harder and harder
  // A large problem is ended by its work: as many sweeps would take minutes.
  const LcpResult short_of_work = solved(lcp({1, -1, -1, 1}, {-1, -1}), {.multiplications = 100});
  CHECK(short_of_work.status == LcpStatus::cap_reached);
  CHECK(short_of_work.pivots == 17);
  const LcpResult none = solved(stack(3), {.sweeps = 0});
  CHECK(none.status == LcpStatus::cap_reached);
  CHECK(none.residual == 1.0);
  // Not semidefinite: each row makes the next one worse.
  const LcpResult wild = solved(lcp({1, -2, -2, 1}, {-1, -1}));
  CHECK(wild.status == LcpStatus::not_positive_semidefinite);
  CHECK(near(wild.f, {0, 0}, 0.0));
  CHECK(wild.residual == 1.0);
}

TEST_CASE("Sweeps refuse what they cannot take", "[unit][lcp][analytic_lcp]") {
  CHECK_THROWS_AS(solved(lcp({0}, {-1})), std::invalid_argument);
  CHECK_THROWS_AS(solved(lcp({-1}, {-1})), std::invalid_argument);
  CHECK(solved(lcp({2, 1, 0, 2}, {-5, -6})).status == LcpStatus::solved);  // not symmetric
  CHECK_THROWS_AS(GaussSeidelSolver({.sweeps = -1}), std::invalid_argument);
  CHECK_THROWS_AS(GaussSeidelSolver({.residual = -1e-9}), std::invalid_argument);
}
