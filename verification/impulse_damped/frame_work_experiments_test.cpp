/// \file
/// \brief Pictures of 6.1 and 2.5.2 by numbers: pairs in a step (6.1a), damping as reported, levels of a pyramid, tuning.
#include "driver/quick.hpp"
#include "support/catch.hpp"

using namespace tumble::chapters;

TEST_CASE("More boxes in a clump mean more pairs to test, and fewer than all",
          "[claims][impulse_damped]") {
  const FigureUnderTest figure("claim_6_1a_frame_rate", {"per_edge=3"});
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

TEST_CASE("With the damping of as_reported figures 6.6 and 6.7 end without faults, with ours not",
          "[claims][impulse_damped][.long]") {
  const FigureUnderTest figure("as_reported_6_1");
  for (const char* what : {"chatter in the end", "kinetic energy in the end"})
    CHECK(figure.number(std::string(what) + ", figure 6.6, as_reported, largest") <
          0.5 * figure.number(std::string(what) + ", figure 6.6, as_meant, largest"));
  CHECK(figure.number("the same, as_reported") > 3.0);
  CHECK(
      figure.number("sayings of four that hold at the end of figures 6.6 and 6.7: no overlap above "
                    "a hundredth of an edge, no box that rests with nothing below it, no step that "
                    "adds energy worth a hundredth of m g L, no box at rest that shakes by a "
                    "hundredth of an edge; mean over runs") < 3.0);
}

TEST_CASE("Impulses carry three scenes in all settings, and penalty forces in none of theirs",
          "[claims][impulse][impulse_damped]") {
  const FigureUnderTest figure("claim_2_5_2b_tuning");
  CHECK(figure.number("share of the settings that carry all three scenes, impulses") > 0.9);
  CHECK(figure.number("share of the settings that carry all three scenes, penalty forces") < 0.1);
  CHECK(figure.number("deepest overlap with the usual setting of impulses") < 10.0);  // [mm]
}

TEST_CASE("Impulses take a small part of the lines of analytic forces", "[claims][impulse]") {
  const FigureUnderTest figure("claim_3_3_2c_simpler");
  CHECK(figure.number("lines of code of impulses over those of analytic forces") < 0.5);
  CHECK(figure.number("random piles that impulses do not run through, repair=on") == 0.0);
}

TEST_CASE(
    "A pyramid stays where it is by impulses whose restitution rises in the sweeps of a level",
    "[claims][impulse][impulse_damped]") {
  const FigureUnderTest figure("impulse_levels");
  CHECK(figure.number("drift of the highest pyramid, rising") < 3.0);  // [mm]
  CHECK(figure.number("drift of the highest pyramid, rising") <
        0.3 * figure.number("drift of the highest pyramid, constant"));
  CHECK(figure.number("largest spin that the first step leaves in the pyramid, rising") <
        0.5 * figure.number("largest spin that the first step leaves in the pyramid, constant"));
}
