/// \file
/// \brief Time and memory of the default technique as scenes grow, awake and asleep (thesis 6.1).
///
/// Stacks of four cubes in a square field, a wall of bricks, and cubes that fall together, with 1000 to 10 000 bodies.
/// Structures: the first step, from nothing, and the median of the steps of the second second, once awake and once
/// asleep. Clumps fall for two seconds, all steps. The last column is the exponent p of what stands left of it,
/// ~ n^p, from the smallest scene on: 1 is linear.
///
/// Run `scale [largest number of bodies]`.
#include "tumble/scenes/library.hpp"
#include "tumble/scenes/simulation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <malloc.h>
#include <string>
#include <vector>

using namespace tumble;

namespace {

constexpr double kStep = 1.0 / 60.0;  // [s]

// A square field with per_edge² stacks of four cubes.
Scene field(int per_edge) {
  constexpr double kSpacing = 2.0;  // [m] centre to centre
  Scene scene;
  scene.ground.emplace();
  for (int i = 0; i < per_edge; ++i)
    for (int k = 0; k < per_edge; ++k)
      for (int level = 0; level < 4; ++level) {
        scene.boxes.push_back(SceneBox{.position_w = {i * kSpacing, 0.5 + level, k * kSpacing}});
      }
  return scene;
}

struct Cost {
  double first = 0.0;   // [s] first step
  double median = 0.0;  // [s]
  double worst = 0.0;   // [s]
  double memory = 0.0;  // [B]
};

// Seconds are counted from the first step; the median is over those after `from`.
Cost measured(const Scene& scene, bool sleeping, double from, double seconds) {
  const std::size_t before = mallinfo2().uordblks + mallinfo2().hblkhd;
  Simulation simulation(scene, "contact_damped", {sleeping ? "sleeping=on" : "sleeping=off"});
  std::vector<double> steps;
  Cost cost;
  for (int k = 0; k * kStep < seconds; ++k) {
    const std::clock_t begin = std::clock();
    simulation.step(kStep);
    const double used = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    if (k == 0) cost.first = used;
    if (k * kStep >= from) steps.push_back(used);
    cost.worst = std::max(cost.worst, used);
  }
  cost.memory = static_cast<double>(mallinfo2().uordblks + mallinfo2().hblkhd - before);
  std::nth_element(steps.begin(), steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2),
                   steps.end());
  cost.median = steps[steps.size() / 2];
  return cost;
}

// One line for each size, with growth against the smallest.
class Table {
 public:
  Table(const char* scene, const char* state) : scene_(scene), state_(state) {}
  void add(const Scene& scene, const Cost& cost) {
    const auto bodies = static_cast<double>(scene.boxes.size());
    if (smallest_ == 0.0) {
      smallest_ = bodies;
      small_ = cost;
    }
    const auto exponent = [&](double now, double then) {
      return bodies > smallest_ && then > 0.0 ? std::log(now / then) / std::log(bodies / smallest_)
                                              : 1.0;
    };
    std::printf("%-6s %-6s %6.0f %10.3g %5.2f %10.3g %5.2f %10.3g %10.2f %5.2f\n", scene_, state_,
                bodies, 1e3 * cost.first, exponent(cost.first, small_.first), 1e3 * cost.median,
                exponent(cost.median, small_.median), 1e3 * cost.worst,
                cost.memory / bodies / 1024.0, exponent(cost.memory, small_.memory));
    std::fflush(stdout);
  }

 private:
  const char* scene_;
  const char* state_;
  double smallest_ = 0.0;  // bodies of the first scene
  Cost small_;
};

}  // namespace

int main(int argc, char** argv) {
  const double most = argc > 1 ? std::atof(argv[1]) : 10000.0;
  std::printf("%-6s %-6s %6s %10s %5s %10s %5s %10s %10s %5s\n", "scene", "", "bodies", "first ms",
              "p", "median ms", "p", "worst ms", "kB a body", "p");
  constexpr std::array kShares = {0.1, 0.32, 1.0};  // of the largest number
  for (const bool sleeping : {false, true}) {
    const char* const state = sleeping ? "asleep" : "awake";
    Table fields("field", state);
    for (const double share : kShares) {
      const Scene scene = field(static_cast<int>(std::lround(std::sqrt(share * most / 4.0))));
      fields.add(scene, measured(scene, sleeping, 1.0, 2.0));
    }
    Table walls("wall", state);
    for (const double share : kShares) {
      const std::string courses = std::to_string(std::lround(std::sqrt(share * most)));
      const Scene scene = make_scene("wall", {"courses=" + courses, "bricks=" + courses});
      walls.add(scene, measured(scene, sleeping, 1.0, 2.0));
    }
  }
  Table clumps("clump", "falls");
  for (const double share : kShares) {
    const Scene scene =
        make_scene("clump", {"per_edge=" + std::to_string(std::lround(std::cbrt(share * most)))});
    clumps.add(scene, measured(scene, false, 0.0, 2.0));
  }
  return 0;
}
