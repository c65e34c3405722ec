/// \file
/// \brief Claim 5.5a: the settled clump before and after filters, in amplitude, squirm and spectrum.
#include "tumble/filtering/filters.hpp"

#include "filtering/shown_clump.hpp"
#include "filtering/spectrum.hpp"

namespace tumble::chapters {
namespace {

struct ShownBy {
  const char* name;    // a column's
  const char* filter;  // as a user writes it; empty: raw
};
constexpr std::array<ShownBy, 5> kShown = {{{"raw", ""},
                                            {"box", "box:5"},
                                            {"soft_envelope", "soft_envelope"},
                                            {"one_euro", "one_euro"},
                                            {"envelope", "envelope"}}};
constexpr std::size_t kUnfiltered = 0;
constexpr std::size_t kBoxOfFive = 1;
constexpr double kHalf = 0.5;  // what the claim's two sayings compare with

// Sums of squares at each frequency, over the bodies that chatter of all seeds.
using Lines = std::vector<double>;

// Adds the squares of a body: the mean over its corners, the sum over the three coordinates.
void add_spectrum(const std::vector<Corners>& path, Lines& squares,
                  std::vector<double>& frequency) {
  std::vector<double> signal(path.size() - 1);  // a whole number of half seconds
  for (std::size_t corner = 0; corner < 8; ++corner)
    for (int axis = 0; axis < 3; ++axis) {
      for (std::size_t n = 0; n < signal.size(); ++n) signal[n] = path[n][corner][axis];
      const Spectrum lines = spectrum_of(signal, kStep, SpectrumWindow::hann);
      frequency = lines.frequency;
      squares.resize(frequency.size(), 0.0);
      for (std::size_t k = 0; k < frequency.size(); ++k)
        squares[k] += lines.amplitude[k] * lines.amplitude[k] / 8.0;
    }
}

// What one seed gives, by filter: medians over the bodies that chatter.
using SeedOfAll = std::array<Shake, kShown.size()>;

// What all seeds give.
struct Measured {
  std::vector<SeedOfAll> seeds;
  std::array<Lines, kShown.size()> lines;
  std::vector<double> frequency;  // [Hz]
  int bodies = 0;                 // that chatter

  // The median of a measure, shown over computed; the mean over the seeds.
  [[nodiscard]] Quantity ratio(const std::string& name, std::size_t filter,
                               double Shake::*number) const {
    return mean_of(name, "-", seeds, [&](const SeedOfAll& seed) {
      return seed[filter].*number / seed[kUnfiltered].*number;
    });
  }
};

void measure(const ChatteringClump& clump, Measured& all) {
  SeedOfAll seed;
  for (std::size_t f = 0; f < kShown.size(); ++f) {
    const Trajectory shown = f == kUnfiltered
                                 ? clump.run.frames
                                 : filtered(clump.run.frames, *filter_of(kShown[f].filter));
    seed[f] = median_shake(clump.shakes(shown));
    for (const std::size_t body : clump.bodies)
      add_spectrum(clump.path(shown, body), all.lines[f], all.frequency);
  }
  all.seeds.push_back(seed);
  all.bodies += static_cast<int>(clump.bodies.size());
}

Table spectra(const Measured& all) {
  Table table{"", {{"frequency_hz", "Hz", "of a line"}}};
  for (const ShownBy& shown : kShown)
    table.columns.push_back({std::string(shown.name) + "_m", "m",
                             std::string("root mean square amplitude of a corner, ") + shown.name});
  for (std::size_t k = 1; k < all.frequency.size(); ++k) {
    std::vector<double> cells;
    for (const Lines& lines : all.lines) cells.push_back(std::sqrt(lines[k] / all.bodies));
    table.add(all.frequency[k], cells);
  }
  return table;
}

Table bars(const Measured& all) {
  Table table{"measures",
              {{"filter", "-", "0 raw, 1 box, 2 soft envelope, 3 one-euro, 4 envelope"}}};
  for (const char* number : {"amplitude", "squirm"})
    add_interval_columns(number, "-", "over that computed, mean over the seeds", table);
  for (std::size_t f = 0; f < kShown.size(); ++f)
    table.add(f, with_interval(all.ratio("", f, &Shake::amplitude)),
              with_interval(all.ratio("", f, &Shake::squirm)));
  return table;
}

Result measure_box_spectra(const Parameters& settings) {
  Measured all;
  for (int seed = 1; seed <= settings.count("seeds"); ++seed)
    measure(chattering_clump(settings, seed), all);

  const Quantity amplitude =
      all.ratio("amplitude after a box of five over before", kBoxOfFive, &Shake::amplitude);
  const Quantity squirm =
      all.ratio("squirm after a box of five over before", kBoxOfFive, &Shake::squirm);
  return {
      {spectra(all), bars(all)},
      {{"of two sayings about a box filter of five frames those that hold: amplitude falls to a "
        "half or less, squirm stays at a half or more",
        "-", (amplitude.value <= kHalf ? 1 : 0) + (squirm.value >= kHalf ? 1 : 0)},
       amplitude,
       squirm,
       all.ratio("acceleration after a box of five over before", kBoxOfFive, &Shake::acceleration),
       squirm_of_white_noise("squirm after over before if chatter were white noise", 5, 1),
       {"bodies that chatter, all seeds", "-", all.bodies}}};
}

const Registered claim_5_5a_spectra_figure{
    {.name = "claim_5_5a_spectra",
     .parameters = chattering_clump_parameters(),
     .quick = {"seeds=2", "per_edge=4", "settling=6", "watched=2"},
     .experiment = measure_box_spectra}};

}  // namespace
}  // namespace tumble::chapters
