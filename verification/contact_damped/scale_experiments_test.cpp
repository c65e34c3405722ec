/// \file
/// \brief Claim 6.3.1a: the same motion at any size, and Coulomb's stopping distance.
#include "driver/quick.hpp"
#include "support/catch.hpp"

using namespace tumble::chapters;

TEST_CASE(
    "The motion of boxes is the same to the bit at 64 times their size, and alike at 0.01 and 100",
    "[claims][contact_damped]") {
  const FigureUnderTest figure("claim_6_3_1a_size");
  // Roots of powers of four are exact: not a bit differs.
  CHECK(figure.number("the same, 1/64, 1 and 64 times the size, where nothing is rounded") == 0.0);
  // [edges] 0.01 is rounded, and a stack that is pushed over makes rounding grow. The line up to which
  // the claim is confirmed.
  CHECK(figure.number("largest difference of the dimensionless motion between boxes of 0.01, 1 and "
                      "100 times the size, in edges") < 1e-6);
  CHECK(figure.number("the same, densities of 0.001, 1 and 1000") < 1e-6);
  // Damping is a factor for a time, and knows no size: the thesis's is another motion at each.
  CHECK(figure.number("the same, damped as in the thesis") > 1.0);
  CHECK(std::abs(figure.number("stopping distance of Coulomb") - 1.529051988) < 1e-9);  // [m]
  // The scheme stops short by half a step at full speed, v0 h / 2, 1.6 % of the way.
  CHECK(std::abs(figure.number("its error, over Coulomb's")) < 0.017);
  CHECK(std::abs(figure.number("its error with steps of 1/960 s")) < 0.0011);
  CHECK(figure.number("error of the stopping distance, damped as in the thesis") < -0.5);
}
