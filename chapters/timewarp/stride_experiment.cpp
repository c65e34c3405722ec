/// \file
/// \brief The work of full timewarp against the length of its flights.
#include "driver/experiment.hpp"
#include "timewarp/cage_runs.hpp"

namespace tumble::chapters {
namespace {

constexpr std::array<double, 8> kStrides = {0.5, 1.0, 2.0, 4.0, 8.0, 16.0, 32.0, 64.0};  // [frames]

Result measure_stride(const Parameters& settings) {
  const int seeds = settings.count("seeds");
  CageStretch stretch = stretch_of(settings, settings.count("count"));
  std::array<Works, kStrides.size()> works;
  Works swept;  // takes back exactly the bodies that collide
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
  const auto each = [&](const std::string& name, std::size_t i, double CageWork::*count) {
    return over_seeds(name, "-", seeds, [&](int k) { return per_event(works[i], count, k); });
  };
  Table table{"", {{"stride", "-", "length of a flight, in frames"}}};
  for (const char* column : {"integrations", "pair_tests", "taken_back"})
    add_interval_columns(column, "-", "per collision; ends of its interval of 95 %", table);
  table.columns.push_back({"between", "-", between.name});
  for (std::size_t i = 0; i < kStrides.size(); ++i)
    table.add(kStrides[i], with_interval(each("", i, &CageWork::integrations)),
              with_interval(each("", i, &CageWork::pair_tests)),
              with_interval(each("", i, &CageWork::rewinds)), between.value);

  std::vector<Quantity> quantities;
  const auto add = [&](const std::string& what, double CageWork::*count,
                       const std::vector<int>& strides) {
    for (const int stride : strides) {
      const auto place = std::find(kStrides.begin(), kStrides.end(), stride) - kStrides.begin();
      const std::string frames = stride == 1 ? "a frame" : std::to_string(stride) + " frames";
      quantities.push_back(each(what + " per collision, " + frames + " at a time",
                                static_cast<std::size_t>(place), count));
    }
  };
  add("pair tests", &CageWork::pair_tests, {1, 8, 64});
  add("integrations", &CageWork::integrations, {1, 64});
  quantities.push_back(between);
  return {{table}, quantities};
}

const Registered timewarp_stride_figure{
    {.name = "timewarp_stride",
     .parameters = cage_settings()
                       .add_whole("count", 64, 8, 1000, "cubes in the cage")
                       .add_whole("frames", 32, 1, 1000,
                                  "in which work is counted, or one flight if that is longer"),
     .quick = {"seeds=2", "count=27", "lead=20", "frames=8"},
     .experiment = measure_stride}};

}  // namespace
}  // namespace tumble::chapters
