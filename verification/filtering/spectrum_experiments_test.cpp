/// \file
/// \brief Amplitude spectra: pure tones, Parseval's theorem, windows.

#include "filtering/spectrum.hpp"
#include "support/test.hpp"

using namespace tumble::chapters;

namespace {

// A cosine with a whole or broken number of periods in the samples, on a constant.
std::vector<double> tone(int count, double periods, double amplitude, double mean) {
  std::vector<double> signal;
  for (int n = 0; n < count; ++n)
    signal.push_back(
        mean + amplitude * elementary::cos(2.0 * std::numbers::pi * periods * n / count + 0.4));
  return signal;
}

}  // namespace

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
