/// \file
/// \brief Claims 3.1a, 4.5a and 6.1a: faces down, work of what moves, pairs in a step.
#include "impulse_damped/rest_experiments.hpp"

#include "driver/quick.hpp"
#include "support/catch.hpp"

#include <cmath>
#include <string>
#include <vector>

using namespace tumble;
using namespace tumble::chapters;

namespace {

FigureUnderTest drawn(const std::string& name) {
  std::vector<Figure> figures;
  add_rest_figures(figures);
  return FigureUnderTest(figures, name);
}

}  // namespace

TEST_CASE("Most boxes of a settled clump have a face down", "[claims][impulse_damped]") {
  const FigureUnderTest figure = drawn("claim_3_1a_faces");
  // [-] 24 boxes; the whole run has 1980
  CHECK(figure.number("share of the boxes of settled clumps that rest with a face down, within a "
                      "degree") >= 0.7);
  // Every box rests; a box can have no tilt beyond that of a cube on its corner.
  CHECK(figure.number("share of the boxes that rest in the end") == 1.0);
  CHECK(figure.result.tables.front().rows.back()[1] == 1.0);  // 60 degrees
  CHECK(figure.number("the same, within five degrees") >=
        figure.number("share of the boxes of settled clumps that rest with a face down, within a "
                      "degree"));
}

TEST_CASE("A step costs what moves, and a box that loses its support wakes its heap at once",
          "[claims][impulse_damped]") {
  const FigureUnderTest figure = drawn("claim_4_5a_sleeping");
  // A tenth of the boxes moves, in stacks that do not touch: a tenth of the pairs and bodies.
  CHECK(std::abs(figure.number("the same, pair tests") - 0.1) < 1e-12);
  CHECK(std::abs(figure.number("the same, integrations") - 0.1) < 1e-12);
  // [-] sweeps end a little earlier or later in each stack
  CHECK(std::abs(figure.number("pair tests, impulses and integrations of a step with a tenth of "
                               "the boxes moving, over those with all of them moving") -
                 0.1) < 0.02);
  // Awake, a stack at rest costs a sweep that finds nothing to do: half as much again in all.
  CHECK(figure.number("the same, nothing sleeps") > 0.13);
  CHECK(figure.number("work of a step with nothing moving") == 0.0);
  // Two stacks of three: the two boxes that are left of the first wake, the second sleeps on.
  CHECK(figure.number("lowest box taken away: boxes asleep before") == 6.0);
  CHECK(figure.number("lowest box taken away: boxes that wake") == 2.0);
  CHECK(figure.number("lowest box taken away: steps until the last one wakes") == 1.0);
  CHECK(figure.number("lowest box taken away: steps until all sleep again") < 200.0);
  // Heaps wake as a whole: that is what it costs.
  CHECK(figure.number("pyramid, top box pushed: boxes that move") == 1.0);
  CHECK(figure.number("pyramid, top box pushed: boxes that wake") == 55.0);
}

TEST_CASE("More boxes in a clump mean more pairs to test, and fewer than all",
          "[claims][impulse_damped]") {
  std::vector<Figure> figures;
  add_rest_figures(figures);
  const FigureUnderTest figure(figures, "claim_6_1a_frame_rate", {"per_edge=3"});
  const std::vector<std::vector<double>>& rows = figure.result.tables.front().rows;
  REQUIRE(rows.size() == 2);
  CHECK(rows[0][0] == 8.0);
  CHECK(rows[1][0] == 27.0);
  CHECK(rows[1][1] > rows[0][1]);
  CHECK(figure.number("pairs in all, the ground included") == 378.0);  // 27 * 28 / 2
  CHECK(figure.number("pairs tested in a step of the clump, on average, contact_damped") < 378.0);
  CHECK(figure.number("pairs that were tested for contact in a step of the clump of figure 6.7, on "
                      "average") <= figure.number("most pairs tested in a step of the clump"));
}
