/// \file
/// \brief Gauss' principle of least constraint against problems by hand and the law of contact
///        forces.
#include "tumble/lcp_solvers/least_constraint.hpp"

#include "tumble/math/complementarity.hpp"

#include "lcp_solvers/random_contacts.hpp"
#include "support/catch.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>

using namespace tumble;
using namespace tumble::test;

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

TEST_CASE("Least constraint finds the accelerations of 2000 singular contact problems",
          "[unit][lcp][analytic_lcp]") {
  Random random(1);
  ComplementaritySolver reference;
  ComplementarityResult want;
  LeastConstraintSolver solver;
  LcpResult result;
  int unsolved = 0;
  int wrong = 0;
  int too_many = 0;
  double worst = 0.0;
  double worst_added = 0.0;
  for (int i = 0; i < 2000; ++i) {
    const LcpProblem problem = random_contacts(random, 4, 24, i % 2 == 0);
    reference.solve(problem.A, problem.b, want);
    solver.solve(problem, result);
    if (result.status != LcpStatus::solved) ++unsolved;
    const double error = distance(result.a, want.a) / scale_of(problem);
    worst = std::max(worst, error);
    if (!(error <= 1e-9) || !(result.residual <= 1e-11)) ++wrong;
    if (result.pushing.size() > 6 * problem.factors.bodies.size() + 1) ++too_many;

    // a = J x + b: the same accelerations without the forces.
    for (int k = 0; k < problem.size(); ++k) {
      const LcpFactors::Row& row = problem.factors.rows[static_cast<std::size_t>(k)];
      double a = problem.b[k];
      const auto add = [&](int body, const Vec3& linear_w, const Vec3& angular_w) {
        if (body < 0) return;
        const double* x = &solver.added_accelerations()[6 * static_cast<std::size_t>(body)];
        a += linear_w.dot(Vec3(x[0], x[1], x[2])) + angular_w.dot(Vec3(x[3], x[4], x[5]));
      };
      add(row.first, row.linear_first_w, row.angular_first_w);
      add(row.second, row.linear_second_w, row.angular_second_w);
      const double off = std::abs(a - result.a[static_cast<std::size_t>(k)]) / scale_of(problem);
      worst_added = std::max(worst_added, off);
    }
  }
  INFO("worst a " << worst << ", worst J x + b " << worst_added);
  CHECK(unsolved == 0);
  CHECK(wrong == 0);  // 1e-9 of max |b| in a, the comparison of two solvers (measured 1e-11), and
                      // a residual of 1e-11 (measured 1.2e-13)
  CHECK(too_many == 0);
  CHECK(worst_added <= 1e-11);  // of max |b|: measured 1e-13
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

TEST_CASE("Equalities pull as well as push, and axes may be locked", "[exact][lcp][analytic_lcp]") {
  // The cube hangs from one glued corner and may not turn: the glue carries all of it.
  CHECK(solved(rising_cube(true)).pushing == std::vector<int>{2});

  // Free to turn, only about x: moments about x alone have to balance.
  LcpProblem axis = cube_on_ground(9.81, 0, 0.4);
  axis.factors.bodies[0].inverse_inertia_w = Vec3(6, 0, 0).asDiagonal();
  multiply_out(axis.factors, axis.A);
  const LcpResult turning = solved(axis);
  CHECK(turning.status == LcpStatus::solved);
  CHECK(near(turning.a, {0, 0, 0, 0}, rounding));
  CHECK(std::abs(turning.f[2] + turning.f[3] - 0.9 * 9.81) <= rounding);
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

TEST_CASE("Least constraint refuses a problem without factors, or with others",
          "[unit][lcp][analytic_lcp]") {
  CHECK_THROWS_WITH(solved(lcp({2}, {-4})), Catch::Contains("needs the factors"));
  LcpProblem problem = stack(2);
  problem.A(0, 0) = 3.0;
  CHECK_THROWS_WITH(solved(problem), Catch::Contains("row 0 of the factors makes 1 of A_ii = 3"));
  problem = stack(2);
  problem.factors.rows[1].first = 2;
  CHECK_THROWS_WITH(solved(problem), Catch::Contains("indices of bodies"));
  problem.factors.rows[1].first = 1;
  CHECK_THROWS_WITH(solved(problem), Catch::Contains("two different bodies"));
  problem = stack(2);
  problem.factors.bodies[0].inverse_mass[2] = -1.0;
  CHECK_THROWS_WITH(solved(problem), Catch::Contains("inverse_mass = -1"));
  problem = stack(2);
  problem.factors.rows[0].angular_second_w[0] = std::numeric_limits<double>::quiet_NaN();
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
