/// \file
/// \brief Runs many random worlds with a technique, and counts what no technique may do.
#include "fuzz/random_world.hpp"

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>

namespace {

using namespace tumble::fuzz;

struct Counts {
  int worlds = 0, unfinished = 0, energy_1 = 0, energy_10 = 0, unbooked = 0, momentum = 0,
      overlap = 0, thrown = 0, silent = 0;
  double most_energy = 0.0, most_unbooked = 0.0, most_momentum = 0.0, most_overlap = 0.0;
};

void run(const std::string& technique, unsigned long first, unsigned long count, bool list) {
  Counts all;
  for (unsigned long seed = first; seed < first + count; ++seed) {
    const WorldVerdict v = judge(random_world(seed), technique);
    ++all.worlds;
    all.thrown += v.thrown.empty() ? 0 : 1;
    all.unfinished += v.status != tumble::StepStatus::done || !v.finite ? 1 : 0;
    all.energy_1 += v.energy_rise > 0.01 ? 1 : 0;
    all.energy_10 += v.energy_rise > 0.1 ? 1 : 0;
    all.unbooked += v.unbooked_rise > 0.01 ? 1 : 0;
    all.momentum += v.momentum_change > 1e-9 ? 1 : 0;
    all.overlap += v.overlap > 0.1 ? 1 : 0;
    const bool wrong = v.unbooked_rise > 0.01 || v.overlap > 0.1;
    all.silent += wrong && !v.reported && v.thrown.empty() ? 1 : 0;
    all.most_energy = std::max(all.most_energy, v.energy_rise);
    all.most_unbooked = std::max(all.most_unbooked, v.unbooked_rise);
    all.most_momentum = std::max(all.most_momentum, v.momentum_change);
    all.most_overlap = std::max(all.most_overlap, v.overlap);
    if (list && (!v.thrown.empty() || v.energy_rise > 0.01 || v.unbooked_rise > 0.01 ||
                 v.momentum_change > 1e-9 || v.overlap > 0.1))
      std::printf(
          "  seed %lu: energy %.3g unbooked %.3g momentum %.3g overlap %.3g status %d reported %d "
          "%s\n",
          seed, v.energy_rise, v.unbooked_rise, v.momentum_change, v.overlap,
          static_cast<int>(v.status), v.reported ? 1 : 0, v.thrown.c_str());
  }
  std::printf(
      "%-16s %6d worlds: unfinished %d, thrown %d, energy >1%% %d (>10%% %d, most %.3g), unbooked "
      "%d (%.3g), "
      "momentum %d (%.3g), overlap %d (%.3g), wrong with code 0 %d\n",
      technique.c_str(), all.worlds, all.unfinished, all.thrown, all.energy_1, all.energy_10,
      all.most_energy, all.unbooked, all.most_unbooked, all.momentum, all.most_momentum,
      all.overlap, all.most_overlap, all.silent);
}

}  // namespace

int main(int count, char** values) {
  if (count < 4) {
    std::fputs("usage: fuzz_worlds TECHNIQUE FIRST_SEED COUNT [list]\n", stderr);
    return 2;
  }
  run(values[1], std::strtoul(values[2], nullptr, 10), std::strtoul(values[3], nullptr, 10),
      count > 4);
}
