/// \file
/// \brief The method of multipliers against problems by hand, other solvers, and what breaks those.
#include "tumble/lcp_solvers/augmented_lagrangian.hpp"

#include "tumble/lcp_solvers/baraff.hpp"
#include "tumble/lcp_solvers/least_constraint.hpp"

#include "lcp_solvers/pyramid_problem.hpp"
#include "lcp_solvers/random_contacts.hpp"
#include "support/test.hpp"

namespace {

// [m/s²], [N] residual of 1e-12, times loads up to 50 and the condition of small problems: measured
// 1.8e-11.
constexpr double rounding = 1e-10;

LcpResult solved(const LcpProblem& problem, const AugmentedLagrangianOptions& options = {}) {
  return solved_with<AugmentedLagrangianSolver>(problem, options);
}

}  // namespace

TEST_CASE("Redundant contacts share a force as equal springs do", "[exact][lcp][analytic_lcp]") {
  for (const bool factors : {true, false}) {
    const LcpProblem centred = cube_on_ground(9.81, 0, 0);
    const LcpResult result = solved(factors ? centred : without_factors(centred));
    const double quarter = 9.81 / 4;
    // [N] Differences that move nothing keep the rounding of the first round, 2e-16 over 1e-6, times
    // the load: measured 2e-10.
    CHECK(near(result.f, {quarter, quarter, quarter, quarter}, 2e-9));
  }
}

TEST_CASE("The method of multipliers solves pyramids of singular contacts to rounding",
          "[unit][lcp][analytic_lcp]") {
  AugmentedLagrangianSolver solver;
  LcpResult result;
  for (const int n : {16, 64, 256, 512, 1024})
    for (const double noise : {0.0, 0.1}) {
      INFO("n = " << n << ", noise " << noise);
      const auto pyramid = chapters::pyramid_problem(n, noise, 1);
      solver.solve(pyramid.problem, result);
      CHECK(result.status == LcpStatus::solved);
      CHECK(result.residual <= 1e-12);  // [-] measured up to 8e-14
      CHECK(result.pivots <= 10);       // measured 1 to 9

      // Sums of a thousand terms of one sign: 2e-16 times a thousand, of loads of up to 16 cubes.
      const auto next = chapters::next_step(pyramid, result.f);
      const std::vector<int> pushing = result.pushing;
      solver.solve(next.problem, result, pushing);
      CHECK(result.residual <= 1e-12);
      CHECK(result.pivots <= 3);  // measured 1 and 2
    }
}

TEST_CASE("Springs whose forces grow for ever prove that contacts contradict each other",
          "[unit][lcp][analytic_lcp]") {
  LcpProblem fixed = on_fixed_box(1.0, -9.81);
  fixed.equality = {1, 0};
  CHECK(solved(fixed).status == LcpStatus::infeasible);  // glue that moves away from it

  // A vice around any body of a random pile.
  Random random(4);
  int missed = 0;
  int factorisations = 0;
  for (int i = 0; i < 500; ++i) {
    LcpProblem heap = random_contacts(random, 4, 16, i % 2 == 0);
    const int n = heap.size();
    LcpFactors::Row row = heap.factors.rows[idx(n - 1)];
    row.linear_first_w = -row.linear_first_w;
    row.angular_first_w = -row.angular_first_w;
    row.linear_second_w = -row.linear_second_w;
    row.angular_second_w = -row.angular_second_w;
    heap.factors.rows.push_back(row);
    multiply_out(heap.factors, heap.A);
    const double b = heap.b[n - 1];
    heap.b.conservativeResize(n + 1);
    heap.b[n] = -b - 0.1;
    const LcpResult result = solved(heap);
    if (result.status != LcpStatus::infeasible) ++missed;
    factorisations = std::max(factorisations, result.pivots);
  }
  CHECK(missed == 0);
  CHECK(factorisations <= 30);  // measured 13
}

TEST_CASE("The method of multipliers notices a matrix that is not semidefinite",
          "[unit][lcp][analytic_lcp]") {
  const auto not_semidefinite = LcpStatus::not_positive_semidefinite;
  CHECK(solved(lcp({1, 2, 2, 1}, {-1, -1})).status == not_semidefinite);
  CHECK(solved(lcp({-1}, {-1})).status == not_semidefinite);
  CHECK(solved(lcp({0, 1, 1, 0}, {-1, -1})).status == not_semidefinite);
  CHECK(solved(lcp({1, 1, 0, 1, 1, 1, 0, 1, 0}, {1, 1, 1})).status == not_semidefinite);
  CHECK(solved(lcp({1, 2, 2, 1}, {-1, -1})).f == std::vector<double>{0, 0});
}

TEST_CASE("The rows that push save all factorisations but one, and their forces that one too",
          "[unit][lcp][analytic_lcp]") {
  const auto pyramid = chapters::pyramid_problem(256, 0.1, 1);
  AugmentedLagrangianSolver solver;
  LcpResult result;
  solver.solve(pyramid.problem, result);
  CHECK(result.pivots > 3);
  solver.solve(pyramid.problem, result, result.pushing);
  CHECK(result.pivots == 1);
  CHECK(result.residual <= 1e-12);
  AugmentedLagrangianSolver warm({.warm = true});
  warm.solve(pyramid.problem, result);
  CHECK(result.pivots == 0);
  CHECK(result.residual <= 1e-12);

  // A wrong start costs work and no more.
  const std::vector<int> wrong{0};
  solver.solve(cube_on_ground(9.81, 0.6, 0), result, wrong);
  CHECK(near(result.f, {0, 5.4936, 5.4936, 0}, rounding));
  result.f = {-3, 100, 0, 7};
  warm.solve(cube_on_ground(9.81, 0.6, 0), result);
  CHECK(near(result.f, {0, 5.4936, 5.4936, 0}, rounding));
}

TEST_CASE("Caps on factorisations and rounds end in a status", "[unit][lcp][analytic_lcp]") {
  const LcpProblem problem = chapters::pyramid_problem(64, 0.1, 1).problem;
  CHECK(solved(problem, {.factorisations = 0}).status == LcpStatus::cap_reached);
  const LcpResult capped = solved(problem, {.factorisations = 1});
  CHECK(capped.status == LcpStatus::cap_reached);
  CHECK(capped.pivots == 1);
  CHECK(solved(problem, {.rounds = 1}).status == LcpStatus::cap_reached);
  CHECK(solved(problem, {.rounds = 1}).residual <= 1e-3);  // one round's worth: measured 2.6e-6
  CHECK(solved(stack(2), {.factorisations = 1}).status == LcpStatus::solved);
}

TEST_CASE("The method of multipliers refuses what it cannot take", "[unit][lcp][analytic_lcp]") {
  CHECK_THROWS_WITH(solved(lcp({2, 1, 0, 2}, {-1, -1})), Contains("give a symmetric matrix"));
  CHECK_THROWS_AS(solved(lcp({kNan}, {-1})), std::invalid_argument);
  LcpProblem problem = stack(2);
  problem.factors.rows.pop_back();
  CHECK_THROWS_WITH(solved(problem), Contains("factors have 1 rows: give none or 2"));
  problem = stack(2);
  problem.A(0, 0) = 3.0;
  CHECK_THROWS_WITH(solved(problem), Contains("row 0 of the factors makes 1 of A_ii = 3"));
  problem = stack(2);
  problem.factors.rows[1].first = 2;
  CHECK_THROWS_WITH(solved(problem), Contains("indices of bodies"));

  AugmentedLagrangianSolver solver({.warm = true});
  LcpResult result;
  const std::vector<int> twice{1, 1};
  CHECK_THROWS_WITH(solver.solve(stack(2), result, twice), Contains("row 1 twice"));
  result.f = {0.0, kNan};
  CHECK_THROWS_WITH(solver.solve(stack(2), result), Contains("result.f"));

  CHECK_THROWS_WITH(AugmentedLagrangianSolver({.residual = -1.0}), Contains("residual = -1"));
  CHECK_THROWS_WITH(AugmentedLagrangianSolver({.softness = 0.0}), Contains("softness = 0"));
  CHECK_THROWS_WITH(AugmentedLagrangianSolver({.softness = 2.0}), Contains("softness = 2"));
  CHECK_THROWS_WITH(AugmentedLagrangianSolver({.factorisations = -1}),
                    Contains("factorisations: give at least 0"));
  CHECK_THROWS_WITH(AugmentedLagrangianSolver({.rounds = -1}), Contains("rounds: give at least 0"));
}
