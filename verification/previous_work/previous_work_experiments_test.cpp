/// \file
/// \brief The figures of chapter 2, run small.
#include "driver/quick.hpp"
#include "support/test.hpp"

using namespace tumble::chapters;

TEST_CASE("Under optimisation bodies touch in about as many places as under time stepping",
          "[claims][optimised]") {
  const FigureUnderTest figure("claim_2_7_2b_touches");
  const double ratio = figure.number(
      "points at which a body of a heap of 27 cubes touches others after a step of optimisation "
      "based animation, over the same under time stepping");
  CHECK(ratio > 0.7);
  CHECK(ratio < 1.5);  // measured: 1.04
}

TEST_CASE(
    "Four cubes on one another take more than four times the impacts of four beside one another",
    "[claims][microcollisions]") {
  const FigureUnderTest figure("claim_2_5_2a_microcollisions");
  CHECK(figure.number("impacts per second with four cubes on one another over those with one cube, "
                      "under microcollisions") > 16.0);  // measured: 68
  CHECK(figure.number("the same for four cubes beside one another") < 4.5);
  CHECK(figure.number("four cubes on one another over two") > 3.0);  // measured: 4.27
  CHECK(figure.number("impacts per second with four cubes on one another") > 5000.0);
}

TEST_CASE("A chain finds a motion that knocks down the wished pins", "[claims][sampling]") {
  const FigureUnderTest figure("chain_motions");
  CHECK(figure.number("motions tried by the chains until each has found one") <= 60);
  CHECK(figure.number("share of proposals that were accepted") > 0.1);
  CHECK(figure.result.drawings.size() == 3);
  CHECK(figure.number("motions that they have tried") <= 60);
}

TEST_CASE("Chains meet a wish that can be met nearly, and chance is counted beside them",
          "[claims][sampling]") {
  const FigureUnderTest figure("claim_2_4_2b_efficiency");
  CHECK(figure.number("motions that independent noise tries for a wish, mean") <= 30.0);
  CHECK(figure.number("motions that chains try for a wish, mean") >= 1.0);
  CHECK(figure.number("motions that independent noise tries until a wish is met, over those that "
                      "chains try, geometric mean over twenty wishes") > 0.1);
}
