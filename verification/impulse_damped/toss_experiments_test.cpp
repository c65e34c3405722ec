/// \file
/// \brief Claim 2.4.2a: tossed cubes with and without chance, and the quartiles of measured ones.
#include "contact_damped/measured_tosses.hpp"
#include "driver/quick.hpp"
#include "support/catch.hpp"
#include "support/shared_data.hpp"

using namespace tumble;
using namespace tumble::chapters;
using namespace tumble::test;

TEST_CASE("The measured quartiles of the experiment are those of the data",
          "[reference][impulse_damped]") {
  const auto folder = shared_data("contactnets-cube-tosses");
  if (!folder) return;
  TossNumbers numbers;
  for (const MeasuredToss& toss : read_tosses(*folder)) add(measured_outcome(toss), numbers);
  REQUIRE(numbers.travel.size() == 20);
  for (std::size_t q = 0; q < 3; ++q) {
    const double share = 0.25 * static_cast<double>(q + 1);
    // [m], [s] the constants have eight digits
    CHECK(std::abs(quantile_of(numbers.travel, share) - measured_tosses.travel[q]) < 1e-8);
    CHECK(std::abs(quantile_of(numbers.time_to_rest, share) - measured_tosses.time_to_rest[q]) <
          1e-8);
  }
}

TEST_CASE(
    "Chance changes tosses, and brings travel and time to rest hardly nearer to measured ones",
    "[claims][impulse_damped]") {
  const FigureUnderTest figure("claim_2_4_2a_tosses");
  const double ratio = figure.number(
      "distance of travel and time to rest from the measured quartiles, with randomness over "
      "without");
  // [-] few tosses: the whole run gives a number between the two lines
  CHECK(ratio > 0.3);
  CHECK(ratio < 3.0);
  CHECK(ratio != 1.0);
  // [-] impulses with the measured friction and restitution are within the measured spread
  CHECK(figure.number("distance of travel from the measured quartiles, over their spread, impulses "
                      "alone") < 1.0);
  // A share of tosses is a share, and more of them go farther.
  const Table& shares = figure.result.tables.front();
  for (std::size_t row = 1; row < shares.rows.size(); ++row)
    for (std::size_t column = 1; column < shares.columns.size(); ++column)
      REQUIRE(shares.rows[row][column] >= shares.rows[row - 1][column]);
}
