/// \file
/// \brief The clump of figure 6.7 with steps that adapt, against fixed ones (claim 6.3.1b).
#include "tumble/math/elementary.hpp"

#include "driver/statistics.hpp"
#include "filtering/adaptive_experiments.hpp"
#include "filtering/adaptive_runs.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace tumble::chapters {
namespace {

// Set down before the first run: 0.5 and 0.9 are the claim's; chatter is the median amplitude of the
// bodies that rest while they are watched; the time to rest is when nine tenths of the bodies have
// come to rest (see RestingMeasures). The quantities tell what the mean, and the median body, say.
// The number of halvings was not: two, to 1/240 s, is what a figure can afford, and below 1/300 s the
// thresholds of `damped` hold bodies of 1 m that nothing supports, as DampedNumbers says. The page
// tells what four halvings do to the verdict.
constexpr double kHalfTheChatter = 0.5;
constexpr double kSooner = 0.9;

constexpr std::size_t kFixed = 0;
constexpr std::size_t kAdaptive = 1;

// One of the two ways to step, over all seeds.
struct Side {
  std::vector<RestingMeasures> resting;       // by seed
  std::vector<std::vector<double>> substeps;  // by seed and step
  std::vector<StepReport> work;               // by seed
};
using Sides = std::array<Side, 2>;

using Measure = std::function<double(const Side&, std::size_t seed)>;

// Of all seeds together, adaptive over fixed.
Quantity ratio(const std::string& name, const Sides& sides, const Measure& measure) {
  std::array<std::vector<double>, 2> values;
  for (std::size_t side = 0; side < sides.size(); ++side)
    for (std::size_t seed = 0; seed < sides[side].work.size(); ++seed)
      values[side].push_back(measure(sides[side], seed));
  return over_seeds(name, "-", static_cast<int>(values[kFixed].size()), [&](int left_out) {
    const double below = sum_without(values[kFixed], left_out);
    if (!(below > 0.0)) throw std::runtime_error("nothing to compare: 0 at fixed steps");
    return sum_without(values[kAdaptive], left_out) / below;
  });
}

// The mean over the seeds.
Quantity mean(const std::string& name, const std::string& unit, const Side& side,
              const Measure& measure) {
  std::vector<double> values;
  for (std::size_t seed = 0; seed < side.work.size(); ++seed) values.push_back(measure(side, seed));
  return mean_over_seeds(name, unit, values);
}

double chatter(const Side& side, std::size_t seed) { return side.resting[seed].chatter(); }
double mean_chatter(const Side& side, std::size_t seed) {
  return side.resting[seed].mean_chatter();
}
double time_to_rest(const Side& side, std::size_t seed) {
  return side.resting[seed].time_to_rest();
}
double median_time(const Side& side, std::size_t seed) {
  return side.resting[seed].time_to_rest(0.5);
}
double share_resting(const Side& side, std::size_t seed) {
  const RestingMeasures& resting = side.resting[seed];
  return static_cast<double>(resting.amplitudes.size()) / static_cast<double>(resting.times.size());
}
double pair_tests(const Side& side, std::size_t seed) {
  return static_cast<double>(side.work[seed].pair_tests);
}
double integrations(const Side& side, std::size_t seed) {
  return static_cast<double>(side.work[seed].integrations);
}

// By time: who still moves, and how many sub-steps there are; means over the seeds.
Table time_table(const Sides& sides) {
  Table table{"",
              {{"time_s", "s", "end of the step"},
               {"fixed", "-", "share of the bodies that still move, fixed steps"},
               {"adaptive", "-", "ditto, adaptive steps"},
               {"substeps", "-", "sub-steps of the adaptive step, mean over the seeds"}}};
  const auto seeds = static_cast<double>(sides[kFixed].work.size());
  for (std::size_t step = 0; step < sides[kAdaptive].substeps[0].size(); ++step) {
    const double time = static_cast<double>(step + 1) * kStep;
    std::vector<double> row{time, 0.0, 0.0, 0.0};
    for (std::size_t side = 0; side < sides.size(); ++side)
      for (const RestingMeasures& resting : sides[side].resting)
        row[1 + side] += share_moving(resting, time) / seeds;
    for (const auto& substeps : sides[kAdaptive].substeps) row[3] += substeps[step] / seeds;
    table.rows.push_back(row);
  }
  return table;
}

// Of all bodies of all seeds that rest: how many shake by more than an amplitude.
Table amplitude_table(const Sides& sides) {
  Table table{"amplitudes",
              {{"amplitude_mm", "mm", "peak to peak"},
               {"fixed", "-", "share of the resting bodies that shake by as much, fixed steps"},
               {"adaptive", "-", "ditto, adaptive steps"}}};
  constexpr int kPerDecade = 20;
  for (int k = -2 * kPerDecade; k <= kPerDecade; ++k) {
    const double amplitude = elementary::pow(10.0, static_cast<double>(k) / kPerDecade);  // [mm]
    table.rows.push_back({amplitude});
    for (const Side& side : sides) {
      double above = 0.0;
      double all = 0.0;
      for (const RestingMeasures& resting : side.resting) {
        all += static_cast<double>(resting.amplitudes.size());
        for (const double a : resting.amplitudes) above += 1e3 * a >= amplitude ? 1.0 : 0.0;
      }
      table.rows.back().push_back(above / std::max(all, 1.0));
    }
  }
  return table;
}

double sayings(double of_chatter, double of_time) {
  return (of_chatter <= kHalfTheChatter ? 1.0 : 0.0) + (of_time <= kSooner ? 1.0 : 0.0);
}

}  // namespace

Result measure_adaptive_claim(const Parameters& settings) {
  Sides sides;
  AdaptiveStepOptions adaptive;
  adaptive.halvings = settings.count("halvings");
  for (int seed = 1; seed <= settings.count("seeds"); ++seed) {
    const auto chance = static_cast<std::uint64_t>(seed);
    const Scene scene =
        scene_with("fig6_7", {"per_edge=" + std::to_string(settings.count("per_edge"))}, chance);
    for (std::size_t k = 0; k < sides.size(); ++k) {
      SteppedRun run = settle_in_steps(scene, make_technique("damped", {}, chance),
                                       k == kFixed ? fixed_steps(0) : adaptive,
                                       settings.number("settling"), settings.number("watched"));
      sides[k].resting.push_back(measure_resting(run.run));
      sides[k].substeps.emplace_back(run.substeps.begin(), run.substeps.end());
      sides[k].work.push_back(run.work);
    }
  }
  const Quantity of_chatter =
      ratio("median amplitude of resting bodies, adaptive over fixed", sides, chatter);
  const Quantity of_time = ratio("time to rest, adaptive over fixed", sides, time_to_rest);
  Result result;
  result.tables = {time_table(sides), amplitude_table(sides)};
  // An interval's lower end is what holds at the unfavourable ends of the two ratios.
  result.quantities = {
      {"of two sayings about a step that adapts those that hold: half of the chatter or less, and "
       "nine tenths of the time to rest or less, against the fixed step",
       "-", sayings(of_chatter.value, of_time.value), sayings(of_chatter.high, of_time.high),
       sayings(of_chatter.low, of_time.low), of_chatter.seeds},
      of_chatter,
      of_time,
      ratio("mean amplitude of resting bodies, adaptive over fixed", sides, mean_chatter),
      ratio("time until half of the bodies rest, adaptive over fixed", sides, median_time),
      ratio("pair tests, adaptive over fixed", sides, pair_tests),
      ratio("integrations, adaptive over fixed", sides, integrations),
      mean("median amplitude of resting bodies, fixed", "m", sides[kFixed], chatter),
      mean("time to rest, fixed", "s", sides[kFixed], time_to_rest),
      mean("time to rest, adaptive", "s", sides[kAdaptive], time_to_rest),
      mean("share of bodies that rest, fixed", "-", sides[kFixed], share_resting),
      mean("share of bodies that rest, adaptive", "-", sides[kAdaptive], share_resting)};
  return result;
}

}  // namespace tumble::chapters
