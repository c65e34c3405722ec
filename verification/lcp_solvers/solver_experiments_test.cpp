/// \file
/// \brief The claims on solvers, and the forces of figure 3.5 step by step, run small.

#include "driver/quick.hpp"
#include "lcp_solvers/lcp_cases.hpp"
#include "lcp_solvers/pivot_trace.hpp"
#include "lcp_solvers/planks.hpp"
#include "lcp_solvers/redundant_contacts.hpp"
#include "support/test.hpp"

using namespace tumble::chapters;

TEST_CASE(
    "A load below an absolute tolerance sinks with the square of time, with a relative one it "
    "rests",
    "[claims][lcp][lcp_solvers]") {
  const FigureUnderTest figure("claim_3_3_1b_negative_forces");
  const double depth = figure.number("P5: depth of a load below the tolerance, at the end");
  CHECK(depth > 0.5 * 0.5 * 9e-6 * 60.0 * 60.0);  // [m] a corner with most of the load; 0.0105
  CHECK(figure.number("P5: the same with a tolerance relative to the load") <= 1e-12);  // 5e-19
}

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
