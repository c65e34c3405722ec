/// \file
/// \brief The largest clump of figure 6.7 that each technique runs at 20 frames a second (thesis 6.1).
///
/// Cubes along an edge of the grid are raised until a step in a hundred takes longer than a frame, or the whole
/// run longer than a minute; times are the processor's. Claim 6.1e: they are of this machine and decide nothing.
///
/// Run `frame_rate [most cubes along an edge] [technique...]`.
#include "tumble/scenes/library.hpp"
#include "tumble/scenes/simulation.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>
#include <vector>

using namespace tumble;

namespace {

constexpr double kFrame = 1.0 / 20.0;  // [s] of the thesis's slower figure
constexpr double kStep = 1.0 / 60.0;   // [s]
constexpr int kSteps = 300;            // of a run: cubes meet, fall and settle
constexpr double kBudget = 60.0;       // [s] of the processor for a run

struct Times {
  std::vector<double> steps;  // [s] ascending
  bool ended = false;         // all steps were made
  double median() const { return steps[steps.size() / 2]; }
  double rare() const { return steps[steps.size() * 99 / 100]; }
  bool keeps_up() const { return ended && rare() <= kFrame; }
};

Times run(const std::string& technique, int per_edge) {
  Simulation simulation(make_scene("fig6_7", {"per_edge=" + std::to_string(per_edge)}), technique);
  Times times;
  double used = 0.0;
  for (int k = 0; k < kSteps && used < kBudget; ++k) {
    const std::clock_t begin = std::clock();
    simulation.step(kStep);
    times.steps.push_back(static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
    used += times.steps.back();
  }
  times.ended = times.steps.size() == static_cast<std::size_t>(kSteps);
  std::ranges::sort(times.steps);
  return times;
}

}  // namespace

int main(int argc, char** argv) {
  const int most = argc > 1 ? std::max(2, std::atoi(argv[1])) : 10;
  std::vector<std::string> names(argv + std::min(argc, 2), argv + argc);
  if (names.empty()) names = {"damped", "contact_damped", "impulse", "analytic", "time_stepping"};
  std::printf("%-15s %6s %12s %12s %12s\n", "technique", "cubes", "median ms", "99 % ms",
              "worst ms");
  for (const std::string& name : names) {
    for (int per_edge = 2; per_edge <= most; ++per_edge) {
      const Times times = run(name, per_edge);
      std::printf("%-15s %6d %12.3g %12.3g %12.3g %s\n", name.c_str(),
                  per_edge * per_edge * per_edge, 1e3 * times.median(), 1e3 * times.rare(),
                  1e3 * times.steps.back(), times.keeps_up() ? "" : "too slow");
      std::fflush(stdout);
      if (!times.keeps_up()) break;
    }
  }
  return 0;
}
