/// \file
/// \brief The thesis's form of Baraff's method: what it solves, and where its two changes matter.
#include "tumble/lcp_solvers/as_printed/baraff_as_printed.hpp"

#include "lcp_solvers/lcp_cases.hpp"
#include "support/test.hpp"

namespace {

LcpResult solved(const LcpProblem& problem, const BaraffAsPrintedOptions& options = {}) {
  return solved_with<BaraffAsPrintedSolver>(problem, options);
}

}  // namespace

TEST_CASE("The thesis's form counts a contact that pushed at first and then separates",
          "[exact][lcp][analytic_lcp]") {
  const LcpResult result = solved(lcp({4, 3, 3, 4}, {-1, -4}));
  CHECK(result.pivots == 3);  // 0 pushes, 0 separates again, 1 pushes
  CHECK(result.pushing == std::vector<int>{1});
  // A df: 4 each time. Elimination with C = {}, {0}, {}: one division. f and a: 4 each time.
  CHECK(result.multiplications == 3 * 4 + 1 + 3 * 4);
}

TEST_CASE("The thesis's form detects bodies that are squeezed and systems without solution",
          "[unit][lcp][analytic_lcp]") {
  CHECK(solved(lcp({1, -1, -1, 1}, {-1, -1})).status == LcpStatus::infeasible);
  CHECK(solved(lcp({0}, {-1})).status == LcpStatus::infeasible);
  // Not semidefinite: both contacts of C get the same row.
  CHECK(solved(lcp({1, 1, -2, 1, 1, 1, -2, 1, 2}, {-1, -3, -4})).status == LcpStatus::singular);
  CHECK(solved(stack(5), {.pivots_per_row = 1}).status == LcpStatus::solved);
  CHECK(solved(cube_on_ground(9.81, 0, 0), {.eps = 0.0}).pivots <= 250);
}

TEST_CASE("The thesis's form refuses what it cannot take", "[unit][lcp][analytic_lcp]") {
  LcpProblem problem = lcp({2, 1, 1, 2}, {-5, -6});
  problem.equality = {0, 1};
  CHECK_THROWS_WITH(solved(problem), Contains("equality"));
  problem.equality = {0, 0};
  CHECK(solved(problem).status == LcpStatus::solved);
  problem.A(0, 1) = 3.0;
  CHECK_THROWS_AS(solved(problem), std::invalid_argument);
  CHECK_THROWS_WITH(BaraffAsPrintedSolver({.eps = -1.0}), Contains("eps = -1"));
  CHECK_THROWS_AS(BaraffAsPrintedSolver({.pivots_per_row = 0}), std::invalid_argument);
}
