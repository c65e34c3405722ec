/// \file
/// \brief Claims 3.1a and 4.5a: faces down, work of what moves; the crate of 1.1.
#include "driver/quick.hpp"
#include "support/catch.hpp"

using namespace tumble::chapters;

TEST_CASE("Most boxes of a settled clump have a face down", "[claims][contact_damped]") {
  const FigureUnderTest figure("claim_3_1a_faces");
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

TEST_CASE("A step costs what moves, and a box that loses its support wakes its island at once",
          "[claims][contact_damped]") {
  const FigureUnderTest figure("claim_4_5a_sleeping");
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
  // An island wakes as a whole: one pushed box wakes all 55.
  CHECK(figure.number("pyramid, top box pushed: boxes that move") == 1.0);
  CHECK(figure.number("pyramid, top box pushed: boxes that wake") == 55.0);
}

TEST_CASE("A crate slides off a table and ends on a face, damped and with friction",
          "[claims][contact_damped]") {
  const FigureUnderTest figure("crate_off_table");
  for (const std::string words : {"damped", "Coulomb"}) {
    CHECK(figure.number("speed of the crate as its centre passes the edge, " + words) > 1.0);
    CHECK(figure.number("where it rests, from the edge, " + words) > 0.15);           // [m]
    CHECK(figure.number("how far a face of it is from level then, " + words) < 0.5);  // [deg]
  }
  // [m] damped at 3.5 m/s; v k dt / (1 - k) = 0.67 but for its slow end. The edge is 1.6 m away.
  const double slides = figure.number("how far it slides, damped, with the start of Coulomb's run");
  CHECK(slides > 0.6);
  CHECK(slides < 0.68);
}
