/// \file
/// \brief Gauss' principle of least constraint against problems by hand and the law of contact
///        forces.
#include "tumble/lcp_solvers/least_constraint.hpp"

#include "tumble/math/complementarity.hpp"

#include "lcp_solvers/random_contacts.hpp"
#include "support/test.hpp"

namespace {

// [m/s²], [N] rounding of problems with numbers up to 50: measured 2e-14.
constexpr double rounding = 1e-11;

LcpResult solved(const LcpProblem& problem) { return solved_with<LeastConstraintSolver>(problem); }

}  // namespace

TEST_CASE("The accelerations that least constraint adds lift a cube and turn it back",
          "[exact][lcp][analytic_lcp]") {
  for (const auto& [x, z] : {std::pair{0.0, 0.0}, {0.2, 0.1}, {0.4, 0.3}, {0.25, -0.25}}) {
    LeastConstraintSolver solver;
    LcpResult result;
    solver.solve(cube_on_ground(9.81, x, z), result);
    CHECK(result.status == LcpStatus::solved);
    // The contacts lift the cube with its weight, and turn back what the load would turn: the
    // moment (z, 0, -x) 9.81 of the upward forces, times 6.
    const auto added = solver.added_accelerations();
    REQUIRE(added.size() == 6);
    const double want[6] = {0, 9.81, 0, -6 * 9.81 * z, 0, 6 * 9.81 * x};
    for (std::size_t k = 0; k < 6; ++k) CHECK(std::abs(added[k] - want[k]) <= 6 * rounding);
  }
}

TEST_CASE("Least constraint keeps its digits on a box of a ton on one of a gram",
          "[exact][lcp][analytic_lcp]") {
  LcpProblem problem = stack(2);
  problem.factors.bodies[0].inverse_mass.setConstant(1e3);
  problem.factors.bodies[1].inverse_mass.setConstant(1e-3);
  multiply_out(problem.factors, problem.A);
  const LcpResult result = solved(problem);
  CHECK(result.status == LcpStatus::solved);
  // Relative 1e-12: measured 4e-16; without the second projection it was 2e-10.
  CHECK(std::abs(result.f[1] / (9.81 * 1e3) - 1.0) <= 1e-12);
  CHECK(std::abs(result.f[0] / (9.81 * 1000.001) - 1.0) <= 1e-12);
}

TEST_CASE("Least constraint begins with the rows that it is given", "[unit][lcp][analytic_lcp]") {
  LeastConstraintSolver solver;
  LcpResult result;
  const LcpProblem problem = stack(8);
  solver.solve(problem, result);
  CHECK(result.pivots == 8);
  solver.solve(problem, result, result.pushing);
  CHECK(result.pivots == 0);
  CHECK(result.residual <= rounding);
  const std::vector<int> wrong{0};
  solver.solve(cube_on_ground(9.81, 0.6, 0), result, wrong);
  CHECK(near(result.f, {0, 5.4936, 5.4936, 0}, rounding));
}

TEST_CASE("Least constraint works on A alone, and refuses factors of another matrix",
          "[unit][lcp][analytic_lcp]") {
  CHECK(near(solved(without_factors(stack(3))).f, {29.43, 19.62, 9.81}, rounding));
  CHECK(near(solved(without_factors(rising_cube(true))).f, {0, 0, -9.81, 0}, rounding));
  CHECK(solved(lcp({-1}, {-1})).status == LcpStatus::not_positive_semidefinite);
  LcpProblem problem = stack(2);
  problem.A(0, 0) = 3.0;
  CHECK_THROWS_WITH(solved(problem), Contains("row 0 of the factors makes 1 of A_ii = 3"));
  problem = stack(2);
  problem.factors.rows[1].first = 2;
  CHECK_THROWS_WITH(solved(problem), Contains("indices of bodies"));
  problem.factors.rows[1].first = 1;
  CHECK_THROWS_WITH(solved(problem), Contains("two different bodies"));
  problem = stack(2);
  problem.factors.bodies[0].inverse_mass[2] = -1.0;
  CHECK_THROWS_WITH(solved(problem), Contains("inverse_mass = -1"));
  problem = stack(2);
  problem.factors.rows[0].angular_second_w[0] = kNan;
  CHECK_THROWS_AS(solved(problem), std::invalid_argument);
  problem = stack(2);
  LeastConstraintSolver solver;
  LcpResult result;
  const std::vector<int> outside{-1};
  CHECK_THROWS_AS(solver.solve(problem, result, outside), std::invalid_argument);
}

TEST_CASE("The product of the factors is the matrix known by hand", "[exact][lcp][analytic_lcp]") {
  LcpProblem problem = cube_on_ground(9.81, 0, 0);
  const MatX by_hand = problem.A;
  multiply_out(problem.factors, problem.A);
  CHECK(problem.A == by_hand);
  const MatX chain = stack(3).A;
  CHECK(chain == lcp({1, -1, 0, -1, 2, -1, 0, -1, 2}, {0, 0, 0}).A);
}
