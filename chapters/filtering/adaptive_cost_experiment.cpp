/// \file
/// \brief The cost of smaller steps, their use, and the cause of chatter (thesis 6.3.1).
#include "tumble/impulse_damped/damped.hpp"

#include "driver/experiment.hpp"
#include "filtering/adaptive_runs.hpp"

namespace tumble::chapters {
namespace {

// Means over the seeds of some clumps.
struct Outcome {
  double chatter = 0.0;       // [m] mean amplitude of the bodies that rest
  double time_to_rest = 0.0;  // [s]
  double resting = 0.0;       // [-] share of the bodies
  double pair_tests = 0.0;
};

using Make = std::function<std::unique_ptr<Technique>(std::uint64_t seed)>;

Make damped_set_to(const std::vector<std::string>& settings) {
  return [=](std::uint64_t seed) { return make_technique("damped", settings, seed); };
}

// With pushes of another size.
Make damped_with_push(double share) {
  return [=](std::uint64_t seed) {
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
    const SteppedRun run =
        settle_in_steps(clump_scene(settings.count("per_edge"), chance), make(chance), options,
                        settings.number("settling"), settings.number("watched"));
    const RestingMeasures resting = measure_resting(run.run);
    sum.chatter += resting.mean_chatter() / seeds;
    sum.time_to_rest += resting.time_to_rest() / seeds;
    sum.resting += static_cast<double>(resting.amplitudes.size()) /
                   static_cast<double>(resting.times.size()) / seeds;
    sum.pair_tests += static_cast<double>(run.work.pair_tests) / seeds;
  }
  return sum;
}

Table cost_table(const std::string& suffix, const Column& first) {
  return {suffix,
          {first,
           {"work", "-", "pair tests, over those of steps of 1/60 s"},
           {"chatter_mm", "mm", "mean amplitude of the bodies that rest"},
           {"rest_s", "s", "time until nine tenths of the bodies rest"}}};
}

void add_cost(double first, const Outcome& outcome, const Outcome& base, Table& table) {
  table.add(first, outcome.pair_tests / base.pair_tests, 1e3 * outcome.chatter,
            outcome.time_to_rest);
}

Result measure_adaptive_cost(const Parameters& settings) {
  const Make damped = damped_set_to({});
  const int halvings = settings.count("halvings");
  Table fixed = cost_table("", {"step_s", "s", "length of the fixed steps"});
  Outcome base;
  Outcome finest;
  for (int k = 0; k <= halvings; ++k) {
    finest = outcome_of(settings, damped, fixed_steps(k));
    if (k == 0) base = finest;
    add_cost(kStep / (1 << k), finest, base, fixed);
  }
  Table adaptive = cost_table("adaptive", {"tolerance_mm", "mm", "shake that asks to halve"});
  for (const double share : {1.0, 2.0, 4.0, 8.0, 16.0}) {  // of the default
    AdaptiveStepOptions options;
    options.halvings = halvings;
    options.shake *= share;
    add_cost(1e3 * options.shake, outcome_of(settings, damped, options), base, adaptive);
  }
  Table plank{"plank",
              {{"speed_m_s", "m/s", "of the cube"},
               {"fixed", "-", "share of the throws that pass through, fixed steps"},
               {"adaptive", "-", "ditto, adaptive steps"}}};
  double passes = 0.0;
  const int throws = settings.count("throws");
  for (const double speed : {4.0, 8.0, 12.0, 16.0, 20.0, 24.0, 32.0, 40.0, 48.0, 64.0}) {
    const double halved = share_through(speed, throws, {});
    plank.add(speed, share_through(speed, throws, fixed_steps(0)), halved);
    passes += halved * throws;
  }
  return {{fixed, adaptive, plank},
          {{"mean amplitude of resting bodies at the finest fixed step over that at 1/60 s", "-",
            finest.chatter / base.chatter},
           {"pair tests at the finest fixed step over those at 1/60 s", "-",
            finest.pair_tests / base.pair_tests},
           {"throws that pass the plank at adaptive steps", "-", passes}}};
}

const Registered adaptive_step_cost_figure{
    {.name = "adaptive_step_cost",
     .parameters =
         adaptive_parameters(2, 4, 3).add_whole("throws", 12, 1, 1000, "at a plank, at each speed"),
     .quick = {"per_edge=3", "settling=1", "watched=0.5", "halvings=2", "throws=3"},
     .experiment = measure_adaptive_cost}};

Result measure_chatter_cause(const Parameters& settings) {
  struct Cause {
    std::string name;
    std::string meaning;
    std::function<Make(double share)> make;  // of 1/60 s that a step has
  };
  const std::array<Cause, 4> causes{{
      {"push", "pushes of a thousandth of an edge", [](double) { return damped_set_to({}); }},
      {"quarter", "pushes of a quarter of that", [](double) { return damped_with_push(0.25); }},
      {"shrinking", "pushes that shrink with the square of the step",
       [](double share) { return damped_with_push(share * share); }},
      {"velocity", "velocities stopped and no pushes",
       [](double) { return damped_set_to({"shock=velocity"}); }},
  }};
  Table table{"", {{"step_s", "s", "length of the steps"}}};
  for (const Cause& cause : causes) {
    table.columns.push_back(
        {cause.name + "_mm", "mm", "mean amplitude of resting bodies, " + cause.meaning});
    table.columns.push_back(
        {cause.name + "_resting", "-", "share of bodies that rest, " + cause.meaning});
  }
  std::vector<std::array<Outcome, 4>> found;  // by number of halvings
  for (int k = 0; k <= settings.count("halvings"); ++k) {
    std::vector<double> cells;
    found.emplace_back();
    for (std::size_t c = 0; c < causes.size(); ++c) {
      const Outcome outcome = outcome_of(settings, causes[c].make(1.0 / (1 << k)), fixed_steps(k));
      found.back()[c] = outcome;
      cells.insert(cells.end(), {1e3 * outcome.chatter, outcome.resting});
    }
    table.add(kStep / (1 << k), cells);
  }
  Result result;
  result.tables = {table};
  for (std::size_t c = 0; c < causes.size(); ++c) {
    if (c < 2)  // how much a quarter of the push leaves is compared at both ends
      result.add("mean amplitude at 1/60 s, " + causes[c].meaning, "m", found.front()[c].chatter);
    result.add("mean amplitude at the finest step, " + causes[c].meaning, "m",
               found.back()[c].chatter);
  }
  return result;
}

const Registered adaptive_step_cause_figure{
    {.name = "adaptive_step_cause",
     .parameters = adaptive_parameters(2, 4, 2),
     .quick = {"per_edge=3", "settling=1", "watched=0.5", "halvings=1"},
     .experiment = measure_chatter_cause}};

}  // namespace
}  // namespace tumble::chapters
