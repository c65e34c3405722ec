/// \file
/// \brief Runs many random worlds with a technique, counts what no technique may do, and compares with its promises.
#include "tumble/base/number_text.hpp"
#include "tumble/techniques.hpp"

#include "fuzz/random_world.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>

namespace {

using namespace tumble;
using namespace tumble::fuzz;

constexpr double kUnbooked = 0.01;  // [-] a rise of the energy that is counted
constexpr double kMomentum = 1e-9;  // [-] a change of momentum that is counted
constexpr double kOverlap = 0.1;    // [-] an overlap that is counted

struct Counts {
  int worlds = 0, unfinished = 0, thrown = 0, broken = 0, silent = 0;
  int unbooked = 0, momentum = 0, energy = 0, overlap = 0;
  double most_unbooked = 0.0, most_momentum = 0.0;
};

void add(const WorldVerdict& v, const WorldPromise& kept, Counts& all) {
  ++all.worlds;
  all.thrown += v.thrown.empty() ? 0 : 1;
  all.unfinished += v.status == StepStatus::done && v.finite ? 0 : 1;
  all.unbooked += v.unbooked_rise > kUnbooked ? 1 : 0;
  all.momentum += v.momentum_change > kMomentum ? 1 : 0;
  all.energy += v.energy_rise > kUnbooked ? 1 : 0;
  all.overlap += v.overlap > kOverlap ? 1 : 0;
  all.most_unbooked = std::max(all.most_unbooked, v.unbooked_rise);
  all.most_momentum = std::max(all.most_momentum, v.momentum_change);
  const bool wrong = v.unbooked_rise > kUnbooked || v.overlap > kOverlap;
  all.silent += wrong && !v.reported && v.thrown.empty() ? 1 : 0;
  const bool broken = !v.thrown.empty() || !v.finite || v.unbooked_rise > kept.unbooked ||
                      v.momentum_change > kept.momentum || v.overlap > kept.overlap;
  all.broken += broken ? 1 : 0;
}

void list(unsigned long seed, const WorldVerdict& v) {
  if (v.thrown.empty() && v.energy_rise <= kUnbooked && v.unbooked_rise <= kUnbooked &&
      v.momentum_change <= kMomentum && v.overlap <= kOverlap)
    return;
  std::printf("  seed %lu: energy %.3g unbooked %.3g momentum %.3g overlap %.3g status %d %s %s\n",
              seed, v.energy_rise, v.unbooked_rise, v.momentum_change, v.overlap,
              static_cast<int>(v.status), v.reported ? "reported" : "", v.thrown.c_str());
}

// The row of the table in promises.md.
void print(const std::string& technique, const Counts& all) {
  std::printf("| `%s` | %d | %d | %d (%s %%) | %d (%s) | %d | %d |", technique.c_str(), all.worlds,
              all.unfinished, all.unbooked, rounded_text(100.0 * all.most_unbooked, 2).c_str(),
              all.momentum, rounded_text(all.most_momentum, 2).c_str(), all.energy, all.overlap);
  if (all.broken > 0) std::printf(" %d break a promise", all.broken);
  if (all.thrown > 0) std::printf(", %d by an exception", all.thrown);
  if (all.silent > 0) std::printf(" %d wrong with code 0", all.silent);
  std::printf("\n");
}

}  // namespace

// Exit codes: 0 all promises are kept, 1 one is broken, 2 a mistake in the call.
int main(int count, char** values) {
  if (count == 2 && std::string(values[1]) == "techniques") {
    for (const TechniqueRecipe& technique : technique_library())
      std::printf("%s\n", std::string(technique.name).c_str());
    return 0;
  }
  if (count < 4) {
    std::fputs("usage: fuzz_worlds TECHNIQUE FIRST_SEED COUNT [list], or fuzz_worlds techniques\n",
               stderr);
    return 2;
  }
  const std::string technique = values[1];
  const WorldPromise kept = promise_of(technique);
  const unsigned long first = std::strtoul(values[2], nullptr, 10);
  const unsigned long worlds = std::strtoul(values[3], nullptr, 10);
  Counts all;
  for (unsigned long seed = first; seed < first + worlds; ++seed) {
    const WorldVerdict verdict = judge(random_world(seed), technique);
    add(verdict, kept, all);
    if (count > 4) list(seed, verdict);
  }
  print(technique, all);
  return all.broken > 0 ? 1 : 0;
}
