/// \file
/// \brief Claim 2.4.3b: full timewarp, all bodies waiting for one another on every so many frames.
#include "driver/statistics.hpp"
#include "timewarp/cage_runs.hpp"
#include "timewarp/rewind_experiments.hpp"

#include <algorithm>
#include <array>
#include <string>

namespace tumble::chapters {
namespace {

using Works = std::vector<CageWork>;  // by seed

// Frames from one synchronisation to the next; none of them is longer than a flight without.
constexpr std::array<int, 4> kPeriods = {1, 2, 4, kLongFlight};

// What the cages of one number of bodies and one speed cost.
struct Costs {
  CageStretch stretch;
  Works all;                   // all bodies taken back for each collision
  Works never;                 // full timewarp, never synchronised
  std::array<Works, 4> every;  // the same, synchronised; the first one always, the others if asked
};

double per_frame(const Works& works, double CageWork::*count, int left_out) {
  return total(works, count, left_out) / total(works, &CageWork::frames, left_out);
}

double flights(const Works& works, int left_out) {
  return per_frame(works, &CageWork::integrations, left_out);
}

double collisions(const Costs& costs, int left_out) {
  return per_frame(costs.never, &CageWork::events, left_out);
}

// The claim's share. To look at a body that is ahead is no integration, but may be counted as one.
double lost(const Costs& costs, int left_out, double looks = 0.0) {
  const double never = flights(costs.never, left_out) + looks;
  return (flights(costs.every[0], left_out) - never) / (flights(costs.all, left_out) - never);
}

CageStretch stretch_of(const Parameters& settings, int count, double factor) {
  CageStretch stretch;
  stretch.count = count;
  stretch.speed = settings.number("speed");
  stretch.spin = settings.number("spin");
  stretch.factor = factor;
  stretch.lead = settings.count("lead");
  stretch.settle = kLongFlight;
  // As many whole flights as there are collisions to be seen.
  stretch.frames = kLongFlight * (count < settings.count("larger") ? settings.count("flights") : 1);
  return stretch;
}

void add_costs(const World& led, bool all_periods, Costs& costs) {
  CageStretch stretch = costs.stretch;
  const SettledCage cage = settled_cage(led, stretch);
  costs.never.push_back(work_of(cage, stretch, full_timewarp()));
  for (std::size_t i = 0; i < (all_periods ? kPeriods.size() : 1); ++i)
    costs.every[i].push_back(work_of(cage, stretch, synchronised_timewarp(kPeriods[i])));
  // Takes the longest, and few frames tell it well enough: all bodies for each collision.
  stretch.frames = std::max(2, stretch.frames / 4);
  costs.all.push_back(work_of(cage, stretch, all_taken_back()));
}

// The first of the factors is 1.
std::vector<Costs> measure(const Parameters& settings, int count,
                           const std::vector<double>& factors) {
  std::vector<Costs> costs;
  for (const double factor : factors)
    costs.emplace_back().stretch = stretch_of(settings, count, factor);
  for (int seed = 1; seed <= settings.count("seeds"); ++seed) {
    const World led = led_cage(costs.front().stretch, seed);
    for (Costs& each : costs) add_costs(led, &each == &costs.front(), each);
  }
  return costs;
}

// Integrations per simulated second for each period, of both numbers of bodies.
Table table_by_period(const Costs& many, const Costs& few, int seeds) {
  Table table{"", {{"frames", "-", "from one synchronisation to the next; 16 stands for never"}}};
  for (const char* bodies : {"larger", "smaller"})
    for (const char* end : {"", "_low", "_high"})
      table.columns.push_back({std::string("full_") + bodies + end, "1/s",
                               "integrations in a simulated second; ends of its interval"});
  table.columns.push_back({"all_larger", "1/s", "the same, all taken back"});
  table.columns.push_back({"all_smaller", "1/s", "the same, all taken back"});
  for (std::size_t i = 0; i <= kPeriods.size(); ++i) {
    const bool never = i == kPeriods.size();
    table.rows.push_back({never ? 2.0 * kLongFlight : kPeriods[i]});
    for (const Costs* costs : {&many, &few}) {
      const Quantity rate = over_seeds("", "1/s", seeds, [&](int left_out) {
        return flights(never ? costs->never : costs->every[i], left_out) / costs->stretch.dt;
      });
      table.rows.back().insert(table.rows.back().end(), {rate.value, rate.low, rate.high});
    }
    for (const Costs* costs : {&many, &few})
      table.rows.back().push_back(flights(costs->all, -1) / costs->stretch.dt);
  }
  return table;
}

// The share against collisions in a frame. Without gravity, bodies twice as fast are frames twice as
// long.
Table table_by_rate(const std::vector<Costs>& list, int seeds) {
  Table table{"rates",
              {{"bodies", "-", "cubes in the cage"},
               {"factor", "-", "of all speeds"},
               {"in_frame", "-", "collisions in a frame"},
               {"lost", "-", "share that is lost by synchronising on every frame"},
               {"low", "-", "lower end of its interval of 95 %"},
               {"high", "-", "upper end of it"},
               {"closed", "-", "1 over 1 and the collisions in a frame"}}};
  for (const Costs& costs : list) {
    const Quantity share =
        over_seeds("", "-", seeds, [&](int left_out) { return lost(costs, left_out); });
    const double in_frame = collisions(costs, -1);
    table.rows.push_back({static_cast<double>(costs.stretch.count), costs.stretch.factor, in_frame,
                          share.value, share.low, share.high, 1.0 / (1.0 + in_frame)});
  }
  return table;
}

}  // namespace

Result measure_synchronising(const Parameters& settings) {
  const int seeds = settings.count("seeds");
  const std::vector<Costs> many = measure(settings, settings.count("larger"), {1.0, 1.0 / 8});
  const std::vector<Costs> few =
      measure(settings, settings.count("smaller"), {1.0, 1.0 / 16, 1.0 / 4, 4.0});
  const Costs& costs = many.front();

  std::vector<Quantity> quantities;
  const auto add = [&](const char* name, const char* unit, const auto& estimate) {
    quantities.push_back(over_seeds(name, unit, seeds, estimate));
  };
  add("share of the integrations that full timewarp saves against taking all back which it loses "
      "if "
      "it is synchronised on every frame",
      "-", [&](int k) { return lost(costs, k); });
  add("the same, the smaller cage", "-", [&](int k) { return lost(few[0], k); });
  add("the same, the smaller cage at a sixteenth of the speeds", "-",
      [&](int k) { return lost(few[1], k); });
  add("collisions in a frame, the larger cage", "-", [&](int k) { return collisions(costs, k); });
  add("collisions in a frame, the smaller cage", "-", [&](int k) { return collisions(few[0], k); });
  add("collisions in a frame, the smaller cage at a sixteenth of the speeds", "-",
      [&](int k) { return collisions(few[1], k); });
  add("integrations in a simulated second, the larger cage, all taken back", "1/s",
      [&](int k) { return flights(costs.all, k) / costs.stretch.dt; });
  add("integrations in a simulated second, the larger cage, synchronised on every frame", "1/s",
      [&](int k) { return flights(costs.every[0], k) / costs.stretch.dt; });
  add("integrations in a simulated second, the larger cage, never synchronised", "1/s",
      [&](int k) { return flights(costs.never, k) / costs.stretch.dt; });
  add("integrations synchronised on every frame over never", "-",
      [&](int k) { return flights(costs.every[0], k) / flights(costs.never, k); });
  add("the first number if full timewarp without synchronisation cost nothing at all", "-",
      [&](int k) { return flights(costs.every[0], k) / flights(costs.all, k); });
  add("the first number if every body is looked at in every frame and that is counted", "-",
      [&](int k) { return lost(costs, k, costs.stretch.count); });

  std::vector<Costs> rates = few;
  rates.insert(rates.end(), many.begin(), many.end());
  return {{table_by_period(costs, few.front(), seeds), table_by_rate(rates, seeds)}, quantities};
}

}  // namespace tumble::chapters
