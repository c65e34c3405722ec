/// \file
/// \brief Which frequencies a signal is made of: amplitude spectra by GSL's FFT (thesis 5.5).
#pragma once

#include "driver/experiment.hpp"

namespace tumble::chapters {

// By what a signal is multiplied before it is taken apart.
enum class SpectrumWindow : std::uint8_t {
  none,  // sharp lines, if the signal has whole periods of each
  hann   // lines three frequencies wide, and next to nothing far from them
};

// A signal as a sum of cosines.
struct Spectrum {
  std::vector<double> frequency;  // [Hz] 0, 1/T, 2/T, ... to half the sampling rate
  std::vector<double> amplitude;  // [the signal's unit] at each of them, at least 0
};

// One-sided amplitude spectrum of samples at equal times.
//
// With the window's weights \f$w_n\f$ and N samples of mean \f$\bar x\f$,
// \f[ A_k = \frac{c_k}{\sum_n w_n} \Bigl|\sum_n w_n\,(x_n - \bar x)\,e^{-2\pi i k n/N}\Bigr|,
//     \qquad A_0 = |\bar x|, \f]
// where \f$c_k\f$ is 2, and 1 at half the sampling rate. A cosine of amplitude a with whole periods in
// the samples has the one line a, under either window. Without a window
// \f$A_0^2 + \tfrac12\sum A_k^2\f$ is the mean square of the signal (Parseval), the last line counted in
// full if N is even.
// signal: [any unit] samples, at least 2, of any number
// interval: [s] between them, above 0
// \par Cost
// n log n if n is a product of small primes.
Spectrum spectrum_of(std::span<const double> signal, double interval,
                     SpectrumWindow window = SpectrumWindow::none);

}  // namespace tumble::chapters
