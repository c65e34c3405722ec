/// \file
/// \brief The figures on envelopes, run small (claims 5.5c and 5.5d).
#include "driver/quick.hpp"
#include "support/test.hpp"

using namespace tumble::chapters;

TEST_CASE("A wider envelope lets a body that chatters rest for more frames",
          "[claims][filtering]") {
  const FigureUnderTest figure("claim_5_5c_envelope");
  const Table& sweep = figure.result.tables[0];
  for (const std::string whose : {"thesis", "soft"}) {
    const std::vector<double> still = column_of(sweep, whose + "_still");
    CHECK(still.front() < still.back());
    CHECK(std::ranges::all_of(still, [](double s) { return s >= 0.0 && s <= 1.0; }));
  }
  // From its own envelope on the thesis's pops are longer than the envelope, by a corner's way.
  const std::vector<double> radius = column_of(sweep, "radius_mm");
  const std::vector<double> step = column_of(sweep, "thesis_step_mm");
  const std::vector<double> pops = column_of(sweep, "thesis_pops");
  for (std::size_t k = 0; k < radius.size(); ++k)
    if (pops[k] > 0.0) CHECK(step[k] >= 0.8 * radius[k]);
}

TEST_CASE("Bodies faster than the envelope are shown where they are, but for a hundredth",
          "[claims][filtering]") {
  const FigureUnderTest figure("claim_5_5d_fast");
  CHECK(figure.number("frames of fast bodies, of all seeds") > 1000.0);
  CHECK(
      figure.number("share of the frames of bodies faster than the envelope in a frame which show "
                    "the computed pose") >= 0.99);
  CHECK(figure.number("the same, tossed cubes alone") == 1.0);
  CHECK(figure.number("the same, soft envelope") == 1.0);
  CHECK(figure.number(
            "largest distance from shown to computed of a tossed cube while it is fast") == 0.0);
}

TEST_CASE("At constant speed all three filters agree with their closed forms",
          "[exact][filtering]") {
  const FigureUnderTest figure("claim_5_5d_fast");
  // [m] rounding of places of up to 48 m
  CHECK(figure.number("largest difference from closed forms at constant speed") <= 1e-12);
  CHECK(figure.number("pop of a ramp of 3 mm a frame") == near(12.0, 1e-9));
  CHECK(figure.number("frames from pop to pop of a ramp of 3 mm a frame") == 4.0);
  // Between half the envelope's speed and all of it every other frame is as computed.
  const Table& speeds = figure.result.tables[1];
  const std::vector<double> speed = column_of(speeds, "speed");
  const std::vector<double> exact = column_of(speeds, "thesis_exact");
  const std::vector<double> ours = column_of(speeds, "soft_exact");
  for (std::size_t k = 0; k < speed.size(); ++k) {
    if (speed[k] > 0.5 && speed[k] < 1.0) CHECK(exact[k] == near(0.5, 1e-9));
    if (speed[k] > 1.0) CHECK(exact[k] == near(1.0, 1e-9));
    CHECK(ours[k] == near(speed[k] > 1.0 ? 1.0 : 0.0, 1e-9));
  }
}
