/// \file
/// \brief Claim 6.1a: pairs in a step.
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
