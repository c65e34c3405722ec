/// \file
/// \brief The figures on the box filter (claims 5.5a and 5.5b, erratum P13), and what they measure with.

#include "tumble/filtering/box_filter.hpp"

#include "driver/quick.hpp"
#include "driver/statistics.hpp"
#include "filtering/shown_clump.hpp"
#include "support/test.hpp"

using namespace tumble::chapters;

namespace {

// Corners that jump at random about where they rest, by the same in each frame for all of them.
std::vector<Corners> white_noise(int count, int width) {
  Random chance(9);
  Trajectory run;
  const std::vector<BodyId> ids = {BodyId{1}};
  std::vector<BodyState> states(1);
  for (int n = 0; n < count; ++n) {
    states[0].position_w = chance.in_cube(1e-3);
    run.record(Frame{n / 60.0, n, ids, states});
  }
  return corner_path(filtered(run, BoxFilter(width)), ids[0], BodyProperties{});
}

}  // namespace

TEST_CASE("A box over five frames cuts the amplitude of chatter and leaves most of the squirm",
          "[claims][filtering]") {
  // Measured over eight clumps of 125 cubes 0.34, 0.70 and 0.14; here two of 64 cubes.
  const FigureUnderTest figure("claim_5_5a_spectra");
  CHECK(figure.number("amplitude after a box of five over before") < 0.6);
  CHECK(figure.number("squirm after a box of five over before") > 0.5);
  CHECK(figure.number("squirm after a box of five over before") < 1.0);
  CHECK(figure.number("acceleration after a box of five over before") < 0.3);
  CHECK(figure.number("bodies that chatter, all seeds") > 2.0);
  // The spectrum: next to nothing is left at 12 Hz, where the response is 0.
  const Table& lines = figure.result.tables[0];
  for (const std::vector<double>& row : lines.rows)
    if (std::abs(row[0] - 12.0) < 1e-9) CHECK(row[2] < 0.1 * row[1]);
  // Raw over raw is 1 for amplitude and squirm.
  CHECK(figure.result.tables[1].rows[0][1] == 1.0);
  CHECK(figure.result.tables[1].rows[0][4] == 1.0);
}

TEST_CASE("Fifteen frames leave half of the squirm that five leave, and a third of the sharpness",
          "[claims][filtering]") {
  const FigureUnderTest figure("claim_5_5b_width");
  // [-] measured over eight clumps 0.42, from 0.39 to 0.45; here two small ones
  CHECK(figure.number("squirm at 15 frames over that at 5") < 0.6);
  // An impact within a frame or two, and rest after it: the change of speed is shared by the window.
  CHECK(figure.number("sharpness of an impact at 15 frames over that at 5") ==
        near(1.0 / 3.0, 1e-12));
  CHECK(figure.number("sharpness of a bounce at 15 frames over that at 5") < 0.5);
  // In single frames filtering makes overlap; of a flat fall on the ground, which is convex, none.
  CHECK(figure.number("most that filtering over 15 frames adds to the overlap of a frame") >
        5e-3);  // [m] measured 0.036 in 24 clumps
  const Table& widths = figure.result.tables[0];
  REQUIRE(widths.columns[12].name == "added_m");
  CHECK(widths.rows[7][12] > widths.rows[1][12]);  // 15 frames add more than 3
  CHECK(figure.number(
            "overlap with the ground of a landing cube that filtering over 15 frames adds") <
        1e-12);
  CHECK(figure.number("height by which a falling cube is shown too low at 5 frames") ==
        near(9.81 / 3600.0, 1e-12));
}

TEST_CASE("Squirm of white noise under box filters is the root of summed squares of weights",
          "[exact][filtering]") {
  const double raw = squirm(white_noise(20000, 1), 1.0 / 60.0);
  for (const int width : {5, 9, 15}) {
    const double ratio = squirm(white_noise(20000, width), 1.0 / 60.0) / raw;
    // [-] a sum over 20000 samples is off by a hundredth
    CHECK(ratio == near(squirm_of_white_noise("", width, 1).value, 0.02));
  }
  CHECK(squirm_of_white_noise("", 5, 5).value == 1.0);
}
