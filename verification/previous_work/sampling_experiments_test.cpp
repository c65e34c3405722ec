/// \file
/// \brief The experiment about motion chosen by sampling, small.
#include "driver/quick.hpp"
#include "support/catch.hpp"

using namespace tumble::chapters;

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
