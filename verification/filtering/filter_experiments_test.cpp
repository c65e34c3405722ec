/// \file
/// \brief The figures on box filters and envelopes (claims 5.5a to 5.5d, erratum P13), and what they measure with:
///        amplitude spectra of pure tones, Parseval's theorem, windows.
#include "tumble/filtering/box_filter.hpp"

#include "driver/quick.hpp"
#include "driver/statistics.hpp"
#include "filtering/shown_clump.hpp"
#include "filtering/spectrum.hpp"
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

// A cosine with a whole or broken number of periods in the samples, on a constant.
std::vector<double> tone(int count, double periods, double amplitude, double mean) {
  std::vector<double> signal;
  for (int n = 0; n < count; ++n)
    signal.push_back(
        mean + amplitude * elementary::cos(2.0 * std::numbers::pi * periods * n / count + 0.4));
  return signal;
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

TEST_CASE("A cosine with whole periods is one line of its amplitude, under either window",
          "[exact][filtering]") {
  for (const SpectrumWindow window : {SpectrumWindow::none, SpectrumWindow::hann})
    for (const int count : {60, 64, 97, 240})
      for (const int periods : {3, 5, 7}) {
        const Spectrum lines = spectrum_of(tone(count, periods, 0.25, -2.0), 1.0 / 60.0, window);
        REQUIRE(lines.amplitude.size() == static_cast<std::size_t>(count / 2 + 1));
        for (std::size_t k = 0; k < lines.amplitude.size(); ++k) {
          const bool beside =
              window == SpectrumWindow::hann && std::abs(static_cast<int>(k) - periods) == 1;
          const double expected = k == 0                           ? 2.0
                                  : static_cast<int>(k) == periods ? 0.25
                                  : beside                         ? 0.125
                                                                   : 0.0;
          CHECK(lines.amplitude[k] == near(expected, 1e-13));
          CHECK(lines.frequency[k] == near(60.0 * static_cast<double>(k) / count, 1e-12));  // [Hz]
        }
      }
}

TEST_CASE("The squares of the lines add up to the mean square of the signal",
          "[exact][filtering]") {
  Random chance(3);
  for (const int count : {2, 3, 4, 31, 32, 210, 241}) {
    std::vector<double> signal;
    double square = 0.0;
    for (int n = 0; n < count; ++n) {
      signal.push_back(chance.uniform(-1.0, 2.0));
      square += signal.back() * signal.back() / count;
    }
    const Spectrum lines = spectrum_of(signal, 0.01);
    double sum = lines.amplitude[0] * lines.amplitude[0];
    for (std::size_t k = 1; k < lines.amplitude.size(); ++k) {
      const bool last = 2 * static_cast<int>(k) == count;
      sum += (last ? 1.0 : 0.5) * lines.amplitude[k] * lines.amplitude[k];
    }
    CHECK(sum == near(square, 1e-12));  // measured 2e-13 over 241, a prime
  }
}

TEST_CASE("Hann's window keeps a tone with broken periods from far lines", "[unit][filtering]") {
  const std::vector<double> signal = tone(240, 20.5, 1.0, 5.0);
  double open = 0.0;
  double hann = 0.0;
  const Spectrum without = spectrum_of(signal, 1.0);
  const Spectrum with = spectrum_of(signal, 1.0, SpectrumWindow::hann);
  for (std::size_t k = 60; k <= 120; ++k) {
    open = std::max(open, without.amplitude[k]);
    hann = std::max(hann, with.amplitude[k]);
  }
  CHECK(open > 5e-3);  // measured 0.015
  CHECK(hann < 1e-4);  // measured 1e-5
}

TEST_CASE("A spectrum of a single sample or without an interval is refused", "[unit][filtering]") {
  const std::vector<double> one = {1.0};
  const std::vector<double> two = {1.0, 2.0};
  CHECK_THROWS_AS(spectrum_of(one, 1.0), std::invalid_argument);
  CHECK_THROWS_AS(spectrum_of(two, 0.0), std::invalid_argument);
  CHECK_THROWS_AS(spectrum_of(two, kNan), std::invalid_argument);
}
