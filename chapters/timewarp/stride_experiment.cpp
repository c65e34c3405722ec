/// \file
/// \brief What the length of full timewarp's flights does to its work.
#include "driver/statistics.hpp"
#include "timewarp/cage_runs.hpp"
#include "timewarp/rewind_experiments.hpp"

#include <algorithm>
#include <array>
#include <string>

namespace tumble::chapters {
namespace {

using Works = std::vector<CageWork>;  // by seed

constexpr std::array<double, 8> kStrides = {0.5, 1.0, 2.0, 4.0, 8.0, 16.0, 32.0, 64.0};  // [frames]
constexpr std::size_t kOneFrame = 1;
constexpr std::size_t kEight = 4;
constexpr std::size_t kSixteen = 5;
constexpr std::size_t kLongest = 7;

}  // namespace

Result measure_stride(const Parameters& settings) {
  const int seeds = settings.count("seeds");
  CageStretch stretch;
  stretch.count = settings.count("count");
  stretch.speed = settings.number("speed");
  stretch.spin = settings.number("spin");
  stretch.lead = settings.count("lead");
  std::array<Works, kStrides.size()> works;
  Works swept;  // takes back exactly those who collide
  for (int seed = 1; seed <= seeds; ++seed) {
    const World led = led_cage(stretch, seed);
    stretch.settle = 0;
    stretch.frames = settings.count("frames");
    swept.push_back(work_of(settled_cage(led, stretch), stretch, {"timewarp_swept"}));
    for (std::size_t i = 0; i < kStrides.size(); ++i) {
      // As long as a flight, until flights begin at all times alike.
      stretch.settle = std::max(kLongFlight, static_cast<int>(kStrides[i]));
      stretch.frames = std::max(settings.count("frames"), static_cast<int>(kStrides[i]));
      works[i].push_back(work_of(settled_cage(led, stretch), stretch, full_timewarp(kStrides[i])));
    }
  }

  const Quantity between =
      over_seeds("frames from one collision of a body to its next", "-", seeds, [&](int k) {
        return stretch.count * total(swept, &CageWork::frames, k) /
               total(swept, &CageWork::rewinds, k);
      });
  Table table{"", {{"stride", "-", "length of a flight, in frames"}}};
  constexpr std::array<double CageWork::*, 3> counts = {&CageWork::integrations,
                                                        &CageWork::pair_tests, &CageWork::rewinds};
  for (const char* column : {"integrations", "pair_tests", "taken_back"})
    for (const char* end : {"", "_low", "_high"})
      table.columns.push_back(
          {std::string(column) + end, "-", "per collision; ends of its interval of 95 %"});
  table.columns.push_back({"between", "-", between.name});
  for (std::size_t i = 0; i < kStrides.size(); ++i) {
    table.rows.push_back({kStrides[i]});
    for (double CageWork::*const count : counts) {
      const Quantity each = over_seeds(
          "", "-", seeds, [&](int left_out) { return per_event(works[i], count, left_out); });
      table.rows.back().insert(table.rows.back().end(), {each.value, each.low, each.high});
    }
    table.rows.back().push_back(between.value);
  }

  std::vector<Quantity> quantities;
  const auto add = [&](const std::string& name, std::size_t i, double CageWork::*count) {
    quantities.push_back(over_seeds(
        name, "-", seeds, [&, i, count](int k) { return per_event(works[i], count, k); }));
  };
  add("pair tests per collision, a frame at a time", kOneFrame, &CageWork::pair_tests);
  add("pair tests per collision, 8 frames at a time", kEight, &CageWork::pair_tests);
  add("pair tests per collision, 16 frames at a time", kSixteen, &CageWork::pair_tests);
  add("pair tests per collision, 64 frames at a time", kLongest, &CageWork::pair_tests);
  add("integrations per collision, a frame at a time", kOneFrame, &CageWork::integrations);
  add("integrations per collision, 8 frames at a time", kEight, &CageWork::integrations);
  add("integrations per collision, 64 frames at a time", kLongest, &CageWork::integrations);
  add("bodies taken back per collision, a frame at a time", kOneFrame, &CageWork::rewinds);
  add("bodies taken back per collision, 64 frames at a time", kLongest, &CageWork::rewinds);
  quantities.push_back(between);
  return {{table}, quantities};
}

}  // namespace tumble::chapters
