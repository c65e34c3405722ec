/// \file
/// \brief The figures that show contact forces: pyramids, and the steps of Baraff's algorithm.
#include "tumble/lcp_solvers/baraff.hpp"

#include "driver/quick.hpp"
#include "lcp_solvers/brick_pyramid.hpp"
#include "lcp_solvers/force_range.hpp"
#include "lcp_solvers/lcp_cases.hpp"
#include "lcp_solvers/pivot_trace.hpp"
#include "lcp_solvers/planks.hpp"
#include "support/catch.hpp"

using namespace tumble;
using namespace tumble::chapters;
using namespace tumble::test;

namespace {

std::vector<double> forces(const LcpProblem& problem) {
  BaraffSolver solver;
  LcpResult result;
  solver.solve(problem, result);
  REQUIRE(result.status == LcpStatus::solved);
  return result.f;
}

}  // namespace

// --- pyramids -----------------------------------------------------------------------------------

TEST_CASE("On feet, loads go straight down a pyramid and arrive as 3/2, 7/2, 5, 7/2, 3/2 weights",
          "[exact][lcp][lcp_solvers]") {
  // A foot stands right above one of the next row, so each column of feet bears half the weight of every
  // brick that it passes: min(c, 2 rows + 1 - c) / 2 in column c from 1.
  const std::array<std::vector<double>, 4> loads{std::vector<double>{1.5, 1.5},
                                                 {1.5, 3.0, 1.5},
                                                 {1.5, 3.5, 3.5, 1.5},
                                                 {1.5, 3.5, 5.0, 3.5, 1.5}};
  for (int rows = 2; rows <= 5; ++rows) {
    const BrickPyramid pyramid = make_brick_pyramid(rows, 1.05, Stand::feet);
    const std::vector<double> f = forces(pyramid.problem.lcp());
    const std::vector<Resultant> got = resultants(pyramid, f);
    const std::vector<double>& want = loads[static_cast<std::size_t>(rows - 2)];
    double worst = 0.0;
    for (std::size_t k = 0; k < want.size(); ++k)
      worst = std::max(worst, std::abs(got[k].force / weight_of_brick(pyramid) - want[k]));
    CHECK(worst < 1e-12);  // [weights] rounding of 30 rows: measured 2e-15
    if (rows != 3) continue;
    // The ground's contacts come first, two feet each.
    const std::array<double, 6> feet{0.5, 1.0, 1.5, 1.5, 1.0, 0.5};
    for (std::size_t i = 0; i < 6; ++i)
      CHECK(f[i] / weight_of_brick(pyramid) == Approx(feet[i]).epsilon(1e-12));
    CHECK(got[0].place == Approx(-1.05 + 1.05 / 12.0).epsilon(1e-12));  // nearer to the inner foot
  }
}

TEST_CASE("A cube loaded near a corner leaves each corner a range of forces 0.981 N long",
          "[exact][lcp][lcp_solvers]") {
  // The load at (0.4, 0.3): least squares plus t (1, -1, 1, -1) with t from 0.981 to 1.962.
  const LcpProblem cube = cube_on_ground(9.81, 0.4, 0.3);
  const ForceRange range(cube.A, cube.b);
  const std::array<double, 4> least{0.0, 0.981, 6.867, 0.0};
  for (int i = 0; i < 4; ++i) {
    const ForceInterval got = range.of(std::vector<int>{i});
    // Rounding of a few pivots: measured 1e-15.
    CHECK(got.least == Approx(least[static_cast<std::size_t>(i)]).margin(1e-13));
    CHECK(got.most == Approx(least[static_cast<std::size_t>(i)] + 0.981).epsilon(1e-13));
  }
  const ForceInterval all = range.of(std::vector<int>{0, 1, 2, 3});
  CHECK(all.least == Approx(9.81).epsilon(1e-14));
  CHECK(all.most == Approx(9.81).epsilon(1e-14));

  const LcpProblem tips = cube_on_ground(9.81, 0.6, 0.0);
  CHECK_THROWS_AS(ForceRange(tips.A, tips.b), std::runtime_error);
  // Two bodies squeezed against each other: the same force on both sides may be any.
  const LcpProblem squeezed = lcp({1, -1, -1, 1}, {0, 0});
  const ForceRange any(squeezed.A, squeezed.b);
  CHECK_THROWS_AS(any.of(std::vector<int>{0}), std::runtime_error);
}

TEST_CASE("The ends of a brick on two others bear from 1/21 to 20/21 of its weight",
          "[exact][lcp][lcp_solvers]") {
  // It touches from 1/40 to 1/2 m on either side of its middle, so forces are as 20 to 1 at most.
  const FigureUnderTest figure("pyramid_forces");
  // Faces are widened by 1e-12 to be clipped: measured 1e-12.
  CHECK(figure.number("two rows on faces: smallest force under an end of the top brick, over its "
                      "weight") == Approx(1.0 / 21.0).epsilon(1e-9));
  const Table& pairs = figure.result.tables.front();
  REQUIRE(pairs.rows.size() == 4);
  for (std::size_t k = 0; k < 2; ++k) {  // on the ground, with their own weight
    CHECK(pairs.rows[k][4] == Approx(22.0 / 21.0).epsilon(1e-9));
    CHECK(pairs.rows[k][5] == Approx(41.0 / 21.0).epsilon(1e-9));
  }
}

TEST_CASE("All solvers' forces in a pyramid lie within what is possible, and they differ",
          "[claims][lcp][lcp_solvers]") {
  const FigureUnderTest figure("pyramid_forces", {"rows=3"});
  // [weights] Gauss-Seidel stops at 1e-9 of g.
  CHECK(figure.number("on faces: how far an answer is outside of its bar, over the weight of a "
                      "brick") < 1e-7);  // measured 1e-14
  CHECK(figure.number("on faces: how far two answers for a pair of faces are apart, over the "
                      "weight of a brick") > 1.0);  // measured 1.45
  CHECK(figure.number("on faces: load of the lowest row, over the weight of a brick") ==
        Approx(6.0).epsilon(1e-12));
  for (const std::vector<double>& row : figure.result.tables.front().rows) CHECK(row[4] < row[5]);
}

// --- Baraff's steps -----------------------------------------------------------------------------

TEST_CASE("On two planks, contact 1 comes to rest, separates and pushes again",
          "[exact][lcp][lcp_solvers]") {
  const Planks planks = make_planks(1.625, 1.5);
  LcpResult result;
  const std::vector<TracedStep> steps = trace_baraff(planks.problem.lcp(), result);
  struct Expected {
    int driven;
    int ended_by;
    StepEnd end;
    const char* during;  // the sets; a dash for contacts not looked at, or driven
  };
  const std::array<Expected, 9> expected{{{0, 0, StepEnd::rests, "-----"},
                                          {1, 1, StepEnd::rests, "C----"},
                                          {2, 2, StepEnd::rests, "CC---"},
                                          {3, 0, StepEnd::stops, "CCC--"},
                                          {3, 2, StepEnd::stops, "NCC--"},
                                          {3, 3, StepEnd::rests, "NCN--"},
                                          {4, 0, StepEnd::returns, "NCNC-"},
                                          {4, 3, StepEnd::stops, "CCNC-"},
                                          {4, 4, StepEnd::rests, "CCNN-"}}};
  REQUIRE(steps.size() == expected.size());
  for (std::size_t k = 0; k < steps.size(); ++k) {
    CHECK(steps[k].driven == expected[k].driven);
    CHECK(steps[k].ended_by == expected[k].ended_by);
    CHECK(steps[k].end == expected[k].end);
    std::string during;
    for (const BaraffSet set : steps[k].during)
      during += set == BaraffSet::C ? 'C' : set == BaraffSet::NC ? 'N' : '-';
    CHECK(during == expected[k].during);
    // The sets hold their conditions: measured 2e-15.
    for (std::size_t i = 0; i < 5; ++i) {
      if (steps[k].during[i] == BaraffSet::C) CHECK(std::abs(steps[k].a[i]) < 1e-13);
      if (steps[k].during[i] == BaraffSet::NC) CHECK(std::abs(steps[k].f[i]) < 1e-13);
      CHECK(steps[k].f[i] > -1e-13);  // [N] measured 0
    }
  }
  // The lower plank on its own, and the upper one tipping over the post 1/8 m beside its middle.
  const double g = 9.81;
  const double tipping = 1.25 * g / (1.0 + 12.0 * 0.125 * 0.125 / (2.5 * 2.5 + 0.1 * 0.1));
  CHECK(near(result.f, {0.25 * g, 0.75 * g, 0.0, 0.0, tipping}, 1e-13));
  // The upper one falls at its middle, and nine and four times as fast up where 3 and 4 were.
  const double falls = g - tipping / 1.25;
  CHECK(near(result.a, {0.0, 0.0, 9.0 * falls, 4.0 * falls, 0.0}, 1e-13));
  CHECK(result.pivots == 9);
}

TEST_CASE("A contact that a later one relieves enters the set C and leaves it again",
          "[exact][lcp][lcp_solvers]") {
  LcpResult result;
  const std::vector<TracedStep> steps = trace_baraff(lcp({4, 3, 3, 4}, {-1, -4}), result);
  REQUIRE(steps.size() == 3);
  CHECK(steps[0].end == StepEnd::rests);
  CHECK(steps[0].f == std::vector<double>{0.25, 0.0});
  CHECK(steps[1].driven == 1);
  CHECK(steps[1].ended_by == 0);
  CHECK(steps[1].end == StepEnd::stops);
  CHECK(steps[2].end == StepEnd::rests);
  CHECK(near(result.f, {0.0, 1.0}, 1e-15));
  CHECK(near(result.a, {2.0, 0.0}, 1e-15));
}

TEST_CASE("A loop that ends as soon as a contact sinks leaves planks in free fall",
          "[exact][lcp][lcp_solvers]") {
  const FigureUnderTest figure("index_sets");
  CHECK(figure.number("P4: fastest sinking that is left, loop until a contact sinks") == 9.81);
  CHECK(figure.number("P4: fastest sinking that is left, loop while a contact sinks") <
        1e-5);  // [m/s²] the thesis's own eps: measured 2e-15
}
