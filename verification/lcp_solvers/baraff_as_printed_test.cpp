/// \file
/// \brief The thesis's form of Baraff's method: what it solves, and where its two changes matter.
#include "tumble/lcp_solvers/as_printed/baraff_as_printed.hpp"

#include "tumble/math/complementarity.hpp"

#include "lcp_solvers/random_contacts.hpp"
#include "support/catch.hpp"

#include <algorithm>
#include <stdexcept>

using namespace tumble;
using namespace tumble::test;

namespace {

LcpResult solved(const LcpProblem& problem, const BaraffAsPrintedOptions& options = {}) {
  return solved_with<BaraffAsPrintedSolver>(problem, options);
}

// How it ends on random contacts, and how far a is from that of ComplementaritySolver.
struct Tally {
  int solved = 0;
  int infeasible = 0;
  int singular = 0;
  int cap_reached = 0;
  int pulling = 0;            // solved with a negative force
  int wrong = 0;              // solved, and a off by more than 1e-5 max |b|
  double worst_pull = 0.0;    // [N]
  double median_error = 0.0;  // [-] of max |b|, over the solved ones
};

Tally tally_of(const BaraffAsPrintedOptions& options) {
  Random random(1);
  ComplementaritySolver reference;
  ComplementarityResult want;
  BaraffAsPrintedSolver solver(options);
  LcpResult result;
  Tally tally;
  std::vector<double> errors;
  for (int i = 0; i < 2000; ++i) {
    const LcpProblem problem = random_contacts(random, 1, 24, false);
    reference.solve(problem.A, problem.b, want);
    REQUIRE(want.status == ComplementarityStatus::solved);
    solver.solve(problem, result);
    if (result.status == LcpStatus::infeasible) ++tally.infeasible;
    if (result.status == LcpStatus::singular) ++tally.singular;
    if (result.status == LcpStatus::cap_reached) ++tally.cap_reached;
    if (result.status != LcpStatus::solved) continue;
    ++tally.solved;
    const double least = *std::min_element(result.f.begin(), result.f.end());
    if (least < 0.0) ++tally.pulling;
    tally.worst_pull = std::min(tally.worst_pull, least);
    errors.push_back(distance(result.a, want.a) / scale_of(problem));
    if (!(errors.back() <= 1e-5)) ++tally.wrong;
  }
  std::sort(errors.begin(), errors.end());
  tally.median_error = errors[errors.size() / 2];
  return tally;
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

TEST_CASE(
    "With a tolerance of 0 one redundant contact problem in five is not solved, with 1e-5 "
    "one in twenty",
    "[claims][lcp][analytic_lcp]") {
  // 2000 boxes with up to 24 contacts, a third of them twice; every problem has a solution. Counts
  // depend on rounding, so they are the same everywhere; bounds allow for other tie rules.
  const Tally thesis = tally_of({});
  CHECK(thesis.solved >= 1900);                          // measured 1917
  CHECK(thesis.infeasible + thesis.cap_reached <= 100);  // measured 46 and 37
  CHECK(thesis.singular == 0);
  CHECK(thesis.pulling == 0);           // they are clamped
  CHECK(thesis.median_error <= 1e-12);  // measured 3e-16 of max |b|

  const Tally exact = tally_of({.eps = 0.0});
  CHECK(exact.solved <= 1600);      // measured 1393
  CHECK(exact.cap_reached >= 200);  // measured 339
  CHECK(exact.infeasible >= 100);   // measured 260
  CHECK(exact.singular > 0);        // measured 8
  CHECK(exact.wrong == 0);          // what it does solve it solves well: measured 2e-12
}

TEST_CASE("Negative forces come from rounding and not from the tolerance",
          "[claims][lcp][analytic_lcp]") {
  // Without the clamp, the same problems: as often and as weak with a tolerance of 0.
  const Tally thesis = tally_of({.clamp = false});
  CHECK(thesis.pulling >= 30);       // measured 64 of 1917
  CHECK(thesis.wrong == 0);          // accelerations are right all the same: measured 4e-9
  CHECK(thesis.worst_pull <= -0.1);  // measured -0.35 N once, after a nearly singular system;
                                     // the others are above -4e-15 N
  const Tally exact = tally_of({.eps = 0.0, .clamp = false});
  CHECK(exact.pulling >= 20);         // measured 46 of 1393
  CHECK(exact.worst_pull >= -1e-12);  // measured -4e-16 N
  // Clamping the one large force makes its accelerations wrong: measured 0.22 of max |b|.
  CHECK(tally_of({}).wrong == 1);
}

TEST_CASE("An absolute tolerance overlooks a problem that is small",
          "[claims][lcp][analytic_lcp]") {
  LcpProblem problem = cube_on_ground(9.81, 0, 0);
  problem.b *= 1e-6;  // a millionth of the weight: 9.81e-6 m/s² is below the tolerance
  const LcpResult result = solved(problem);
  CHECK(result.status == LcpStatus::solved);
  CHECK(result.pivots == 0);
  CHECK(result.residual == 1.0);
  CHECK(solved(problem, {.eps = 1e-12}).residual <= 1e-9);  // measured 0
}

TEST_CASE("The thesis's form refuses what it cannot take", "[unit][lcp][analytic_lcp]") {
  LcpProblem problem = lcp({2, 1, 1, 2}, {-5, -6});
  problem.equality = {0, 1};
  CHECK_THROWS_WITH(solved(problem), Catch::Contains("equality"));
  problem.equality = {0, 0};
  CHECK(solved(problem).status == LcpStatus::solved);
  problem.A(0, 1) = 3.0;
  CHECK_THROWS_AS(solved(problem), std::invalid_argument);
  CHECK_THROWS_WITH(BaraffAsPrintedSolver({.eps = -1.0}), Catch::Contains("eps = -1"));
  CHECK_THROWS_AS(BaraffAsPrintedSolver({.pivots_per_row = 0}), std::invalid_argument);
}
