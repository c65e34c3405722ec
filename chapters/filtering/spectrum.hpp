/// \file
/// \brief Which frequencies a signal is made of: amplitude spectra by GSL's FFT (thesis 5.5).
#pragma once

#include "driver/experiment.hpp"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_fft_real.h>

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

// Hann's window of period N: 0 at the first sample, 1 in the middle.
inline double weight(SpectrumWindow window, std::size_t n, std::size_t count) {
  if (window == SpectrumWindow::none) return 1.0;
  return 0.5 - 0.5 * elementary::cos(2.0 * std::numbers::pi * static_cast<double>(n) /
                                     static_cast<double>(count));
}

// Fourier sums as GSL packs them: the real part at 0, then real and imaginary parts by turns.
inline void transform(std::vector<double>& data) {
  const std::unique_ptr<gsl_fft_real_wavetable, decltype(&gsl_fft_real_wavetable_free)> table(
      gsl_fft_real_wavetable_alloc(data.size()), gsl_fft_real_wavetable_free);
  const std::unique_ptr<gsl_fft_real_workspace, decltype(&gsl_fft_real_workspace_free)> work(
      gsl_fft_real_workspace_alloc(data.size()), gsl_fft_real_workspace_free);
  if (!table || !work ||
      gsl_fft_real_transform(data.data(), 1, data.size(), table.get(), work.get()) != GSL_SUCCESS)
    throw std::runtime_error("no Fourier transform of " + std::to_string(data.size()) + " samples");
}

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
inline Spectrum spectrum_of(std::span<const double> signal, double interval,
                            SpectrumWindow window = SpectrumWindow::none) {
  require::that(signal.size() >= 2,
                "a spectrum of " + std::to_string(signal.size()) + " samples: expected at least 2");
  require::positive(interval, "interval of spectrum_of()");
  const std::size_t count = signal.size();
  double mean = 0.0;
  for (const double x : signal) mean += x / static_cast<double>(count);
  std::vector<double> data;
  double weights = 0.0;
  for (std::size_t n = 0; n < count; ++n) {
    const double w = weight(window, n, count);
    data.push_back(w * (signal[n] - mean));
    weights += w;
  }
  transform(data);

  Spectrum out;
  for (std::size_t k = 0; k <= count / 2; ++k) {
    out.frequency.push_back(static_cast<double>(k) / (static_cast<double>(count) * interval));
    if (k == 0)
      out.amplitude.push_back(std::abs(mean));
    else if (2 * k == count)
      out.amplitude.push_back(std::abs(data[count - 1]) / weights);
    else
      out.amplitude.push_back(2.0 * std::hypot(data[2 * k - 1], data[2 * k]) / weights);
  }
  return out;
}

}  // namespace tumble::chapters
