/// \file
/// \brief What smaller steps cost, what they are good for, and where chatter comes from instead.
#include "tumble/impulse_damped/damped.hpp"

#include "filtering/adaptive_experiments.hpp"
#include "filtering/adaptive_runs.hpp"
#include "filtering/thin_plank.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace tumble::chapters {
namespace {

// What a way to step comes to, means over the seeds.
struct Outcome {
  double chatter = 0.0;       // [m] mean amplitude of the bodies that rest
  double time_to_rest = 0.0;  // [s]
  double resting = 0.0;       // [-] share of the bodies
  double substeps = 0.0;      // [-] in a step
  double integrations = 0.0;
  double impulses = 0.0;
  double pair_tests = 0.0;
};

using Make = std::function<std::unique_ptr<Technique>(const Scene&, std::uint64_t seed)>;

Make technique_called(const std::string& name, const std::vector<std::string>& set = {}) {
  return [=](const Scene&, std::uint64_t seed) { return make_technique(name, set, seed); };
}

// `damped` with pushes of another size.
Make damped_with_push(double share) {
  return [=](const Scene&, std::uint64_t seed) {
    DampedOptions options;
    options.seed = seed;
    options.numbers.eps1 *= share;
    return std::make_unique<Damped>(options);
  };
}

Outcome outcome_of(const Parameters& settings, const Make& make,
                   const AdaptiveStepOptions& options) {
  Outcome sum;
  const int seeds = settings.count("seeds");
  for (int seed = 1; seed <= seeds; ++seed) {
    const auto chance = static_cast<std::uint64_t>(seed);
    const Scene scene =
        scene_with("fig6_7", {"per_edge=" + std::to_string(settings.count("per_edge"))}, chance);
    const SteppedRun run = settle_in_steps(scene, make(scene, chance), options,
                                           settings.number("settling"), settings.number("watched"));
    const RestingMeasures resting = measure_resting(run.run);
    sum.chatter += resting.mean_chatter() / seeds;
    sum.time_to_rest += resting.time_to_rest() / seeds;
    sum.resting += static_cast<double>(resting.amplitudes.size()) /
                   static_cast<double>(resting.times.size()) / seeds;
    double substeps = 0.0;
    for (const int n : run.substeps) substeps += n;
    sum.substeps += substeps / static_cast<double>(run.substeps.size()) / seeds;
    sum.integrations += static_cast<double>(run.work.integrations) / seeds;
    sum.impulses += static_cast<double>(run.work.impulses) / seeds;
    sum.pair_tests += static_cast<double>(run.work.pair_tests) / seeds;
  }
  return sum;
}

std::vector<Column> cost_columns(const Column& first) {
  return {first,
          {"work", "-", "pair tests, over those of steps of 1/60 s"},
          {"chatter_mm", "mm", "mean amplitude of the bodies that rest"},
          {"rest_s", "s", "time until nine tenths of the bodies rest"},
          {"resting", "-", "share of the bodies that rest while watched"},
          {"substeps", "-", "mean number of sub-steps in a step"},
          {"integrations", "-", "over those of steps of 1/60 s"},
          {"impulses", "-", "over those of steps of 1/60 s"}};
}

std::vector<double> cost_row(double first, const Outcome& outcome, const Outcome& base) {
  return {first,
          outcome.pair_tests / base.pair_tests,
          1e3 * outcome.chatter,
          outcome.time_to_rest,
          outcome.resting,
          outcome.substeps,
          outcome.integrations / base.integrations,
          outcome.impulses / base.impulses};
}

Table plank_table(const Parameters& settings, const AdaptiveStepOptions& adaptive,
                  double& adaptive_passes) {
  Table table{"plank",
              {{"speed_m_s", "m/s", "of the cube"},
               {"fixed", "-", "share of the throws that pass through, fixed steps"},
               {"adaptive", "-", "ditto, adaptive steps"}}};
  adaptive_passes = 0.0;
  for (const double speed : {4.0, 8.0, 12.0, 16.0, 20.0, 24.0, 32.0, 40.0, 48.0, 64.0}) {
    const int throws = settings.count("throws");
    const double fixed = share_through(speed, throws, fixed_steps(0));
    const double halved = share_through(speed, throws, adaptive);
    table.rows.push_back({speed, fixed, halved});
    adaptive_passes += halved * throws;
  }
  return table;
}

}  // namespace

Result measure_adaptive_cost(const Parameters& settings) {
  const Make damped = technique_called("damped");
  const int halvings = settings.count("halvings");
  Result result;
  std::vector<Quantity>& out = result.quantities;

  Table fixed{"", cost_columns({"step_s", "s", "length of the fixed steps"})};
  Outcome base;
  Outcome finest;
  for (int k = 0; k <= halvings; ++k) {
    finest = outcome_of(settings, damped, fixed_steps(k));
    if (k == 0) base = finest;
    fixed.rows.push_back(cost_row(kStep / (1 << k), finest, base));
  }
  Table adaptive{"adaptive", cost_columns({"tolerance_mm", "mm", "shake that asks to halve"})};
  double best = std::numeric_limits<double>::infinity();   // [s] time to rest
  for (const double share : {1.0, 2.0, 4.0, 8.0, 16.0}) {  // of the default
    AdaptiveStepOptions options;
    options.halvings = halvings;
    options.shake *= share;
    const Outcome outcome = outcome_of(settings, damped, options);
    adaptive.rows.push_back(cost_row(1e3 * options.shake, outcome, base));
    best = std::min(best, outcome.time_to_rest);
  }
  AdaptiveStepOptions thrown;
  double passes = 0.0;
  const Table plank = plank_table(settings, thrown, passes);
  double first_through = std::numeric_limits<double>::quiet_NaN();
  for (auto row = plank.rows.rbegin(); row != plank.rows.rend(); ++row)
    if ((*row)[1] > 0.0) first_through = (*row)[0];

  out.push_back({"mean amplitude of resting bodies at steps of 1/60 s", "m", base.chatter});
  out.push_back({"mean amplitude of resting bodies at the finest fixed step over that at 1/60 s",
                 "-", finest.chatter / base.chatter});
  out.push_back({"time to rest at steps of 1/60 s", "s", base.time_to_rest});
  out.push_back({"time to rest at the finest fixed step", "s", finest.time_to_rest});
  out.push_back({"shortest time to rest of all adaptive steps", "s", best});
  out.push_back({"pair tests at the finest fixed step over those at 1/60 s", "-",
                 finest.pair_tests / base.pair_tests});
  out.push_back(
      {"slowest throw of these that passes the plank at fixed steps", "m/s", first_through});
  out.push_back({"throws that pass the plank at adaptive steps", "-", passes});
  result.tables = {fixed, adaptive, plank};
  return result;
}

Result measure_chatter_cause(const Parameters& settings) {
  struct Cause {
    std::string name;
    std::string meaning;
    std::function<Make(double share)> make;  // of 1/60 s that a step has
  };
  const std::array<Cause, 4> causes{{
      {"push", "pushes of a thousandth of an edge",
       [](double) { return technique_called("damped"); }},
      {"quarter", "pushes of a quarter of that", [](double) { return damped_with_push(0.25); }},
      {"shrinking", "pushes that shrink with the square of the step",
       [](double share) { return damped_with_push(share * share); }},
      {"velocity", "velocities stopped and nobody pushed",
       [](double) { return technique_called("damped", {"shock=velocity"}); }},
  }};
  Table table{"", {{"step_s", "s", "length of the steps"}}};
  for (const Cause& cause : causes) {
    table.columns.push_back(
        {cause.name + "_mm", "mm", "mean amplitude of resting bodies, " + cause.meaning});
    table.columns.push_back(
        {cause.name + "_resting", "-", "share of bodies that rest, " + cause.meaning});
  }
  Result result;
  std::array<std::vector<Outcome>, 4> found;
  for (int k = 0; k <= settings.count("halvings"); ++k) {
    table.rows.push_back({kStep / (1 << k)});
    for (std::size_t c = 0; c < causes.size(); ++c) {
      const Outcome outcome = outcome_of(settings, causes[c].make(1.0 / (1 << k)), fixed_steps(k));
      found[c].push_back(outcome);
      table.rows.back().push_back(1e3 * outcome.chatter);
      table.rows.back().push_back(outcome.resting);
    }
  }
  result.tables = {table};
  for (std::size_t c = 0; c < causes.size(); ++c) {
    result.quantities.push_back(
        {"mean amplitude at 1/60 s, " + causes[c].meaning, "m", found[c].front().chatter});
    result.quantities.push_back(
        {"mean amplitude at the finest step, " + causes[c].meaning, "m", found[c].back().chatter});
  }
  return result;
}

}  // namespace tumble::chapters
