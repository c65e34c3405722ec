/// \file
/// \brief The claims of 3.3.1 on joining impacts and contact forces, and of 4.3 on sticky collisions.
#include "driver/quick.hpp"
#include "support/catch.hpp"

using namespace tumble;
using namespace tumble::chapters;

TEST_CASE("A box bounces, sticks, rests, slides and topples in one run of the joined simulator",
          "[claims][analytic_lcp]") {
  // Also with a step of another length: what is measured is physics, not the step.
  for (const std::string& step :
       std::vector<std::string>{"step=0.016666666666666666", "step=0.01"}) {
    const FigureUnderTest figure("claim_3_3_1d_joined", {step});
    CHECK(figure.number("of five phases (bounce, sticky collision, rest, slide, topple), those "
                        "that the joined simulator passes") == 5.0);
    // Five resolutions of 1 ns for each of six impacts; measured 4.5e-9 s.
    CHECK(figure.number("bounce: largest error of six impact times") < 3e-8);
    CHECK(figure.number("sticky collision: impacts until the cube rests") == 7.0);
    // [J] rounding of 40 J; measured 2.5e-14.
    CHECK(figure.number("largest gain of energy in a step that is not booked") < 1e-10);
  }
}

TEST_CASE(
    "Exact impact times cost less than time stepping, and their price grows faster with the number "
    "of bodies",
    "[claims][analytic_lcp]") {
  const FigureUnderTest few("claim_3_3_1e_exact_times");
  CHECK(few.number("the same ratio for one cube") < 0.5);  // [-] measured 0.17
  const double ten = few.number(
      "separations and integrations with exact impact times over those of "
      "time stepping, at equal error");
  CHECK(ten < 0.5);  // [-] measured 0.13
  const FigureUnderTest many("claim_3_3_1e_exact_times", {"cubes=64"});
  CHECK(many.number("the same ratio for the most cubes") > 2.0 * ten);  // [-] measured 0.51
}

TEST_CASE("Sticky collisions spare about half of the collisions of a die",
          "[claims][analytic_lcp]") {
  const FigureUnderTest figure("claim_4_3a_sticky");
  const double share =
      figure.number("collisions until rest with sticky collisions over those without");
  // [-] measured 0.51 over 20 dice, three here
  CHECK(share > 0.4);
  CHECK(share < 0.65);
  CHECK(figure.number("the same collisions, half the threshold") > share);
  CHECK(figure.number("the same collisions, twice the threshold") < share);
  CHECK(figure.number("thresholds at which a flat drop misses its closed form") == 0.0);
}

TEST_CASE("A die whose every collision is sticky does not leave the ground again",
          "[claims][analytic_lcp]") {
  const FigureUnderTest figure("claim_4_3b_all_sticky");
  CHECK(figure.number("bounces seen with every collision sticky over those seen without") == 0.0);
  // [-] measured 0.21 over 20 dice
  CHECK(figure.number("way from the first contact on, every collision sticky, over that without") <
        0.4);
}
