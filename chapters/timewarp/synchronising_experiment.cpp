/// \file
/// \brief Claim 2.4.3b: full timewarp, all bodies waiting for one another on every so many frames.
#include "timewarp/cage_runs.hpp"

namespace tumble::chapters {
namespace {

// Frames from one synchronisation to the next; none of them is longer than a flight without.
constexpr std::array<int, 4> kPeriods = {1, 2, 4, kLongFlight};

// The work of the cages of one number of bodies and one speed.
struct Costs {
  CageStretch stretch;
  Works all;                   // all bodies taken back for each collision
  Works never;                 // full timewarp, never synchronised
  std::array<Works, 4> every;  // the same, synchronised; the first one always, the others if asked
};

double per_frame(const Works& works, double CageWork::*count, int left_out) {
  return total(works, count, left_out) / total(works, &CageWork::frames, left_out);
}

double flights(const Works& works, int left_out = -1) {
  return per_frame(works, &CageWork::integrations, left_out);
}

double collisions(const Costs& costs, int left_out = -1) {
  return per_frame(costs.never, &CageWork::events, left_out);
}

// The claim's share. To look at a body that is ahead is no integration, but may be counted as one.
double lost(const Costs& costs, int left_out, double looks = 0.0) {
  const double never = flights(costs.never, left_out) + looks;
  return (flights(costs.every[0], left_out) - never) / (flights(costs.all, left_out) - never);
}

CageStretch counted_flights(const Parameters& settings, int count, double factor) {
  CageStretch stretch = stretch_of(settings, count);
  stretch.factor = factor;
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
  // All bodies for each collision take the longest, and few frames are exact enough.
  stretch.frames = std::max(2, stretch.frames / 4);
  costs.all.push_back(work_of(cage, stretch, all_taken_back()));
}

// The first of the factors is 1.
std::vector<Costs> measure(const Parameters& settings, int count,
                           const std::vector<double>& factors) {
  std::vector<Costs> costs;
  for (const double factor : factors)
    costs.emplace_back().stretch = counted_flights(settings, count, factor);
  for (int seed = 1; seed <= settings.count("seeds"); ++seed) {
    const World& led = led_cage(costs.front().stretch, seed);
    for (Costs& each : costs) add_costs(led, &each == &costs.front(), each);
  }
  return costs;
}

// Integrations per simulated second for each period, of both numbers of bodies.
Table table_by_period(const Costs& many, const Costs& few) {
  Table table{"",
              {{"frames", "-", "from one synchronisation to the next; 16 stands for never"},
               {"full_larger", "1/s", "integrations in a simulated second, the larger cage"},
               {"full_smaller", "1/s", "the same, the smaller cage"},
               {"all_larger", "1/s", "the same, all taken back"},
               {"all_smaller", "1/s", "the same, all taken back"}}};
  const auto rate = [](const Costs& costs, const Works& works) {
    return flights(works) / costs.stretch.dt;
  };
  const auto add = [&](double frames, const Works& larger, const Works& smaller) {
    table.add(frames, rate(many, larger), rate(few, smaller), rate(many, many.all),
              rate(few, few.all));
  };
  for (std::size_t i = 0; i < kPeriods.size(); ++i) add(kPeriods[i], many.every[i], few.every[i]);
  add(2.0 * kLongFlight, many.never, few.never);
  return table;
}

// The share against collisions in a frame. Without gravity, bodies twice as fast are frames twice as
// long.
Table table_by_rate(const std::vector<Costs>& list, int seeds) {
  Table table{"rates",
              {{"bodies", "-", "cubes in the cage"},
               {"factor", "-", "of all speeds"},
               {"in_frame", "-", "collisions in a frame"}}};
  add_interval_columns("lost", "-", "share that is lost by synchronising on every frame", table);
  for (const Costs& costs : list)
    table.add(costs.stretch.count, costs.stretch.factor, collisions(costs),
              with_interval(
                  over_seeds("", "-", seeds, [&](int left_out) { return lost(costs, left_out); })));
  return table;
}

// Flights of full timewarp that waits on every frame over those without waiting, where collisions are many: a second
// measurement.
Quantity waited_over_free(const Parameters& settings) {
  constexpr int kCubes = 128;
  constexpr int kFresh = 100;  // seeds after this one
  constexpr double kFaster = 4.0;
  const int seeds = settings.count("seeds");
  Costs costs{.stretch = counted_flights(settings, kCubes, kFaster)};
  costs.stretch.frames = kLongFlight;
  for (int seed = kFresh + 1; seed <= kFresh + seeds; ++seed) {
    CageStretch lead = costs.stretch;
    lead.factor = 1.0;
    const SettledCage cage = settled_cage(led_cage(lead, seed), costs.stretch);
    costs.never.push_back(work_of(cage, costs.stretch, full_timewarp()));
    costs.every[0].push_back(work_of(cage, costs.stretch, synchronised_timewarp(kPeriods[0])));
  }
  return over_seeds(
      "integrations of full timewarp synchronised on every frame over those never synchronised, "
      "128 cubes at four times the speeds, fresh seeds",
      "-", seeds, [&](int k) { return flights(costs.every[0], k) / flights(costs.never, k); });
}

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
      "if it is synchronised on every frame",
      "-", [&](int k) { return lost(costs, k); });
  quantities.push_back(waited_over_free(settings));
  add("the same, the smaller cage", "-", [&](int k) { return lost(few[0], k); });
  add("the same, the smaller cage at a sixteenth of the speeds", "-",
      [&](int k) { return lost(few[1], k); });
  add("collisions in a frame, the smaller cage", "-", [&](int k) { return collisions(few[0], k); });
  add("collisions in a frame, the smaller cage at a sixteenth of the speeds", "-",
      [&](int k) { return collisions(few[1], k); });
  add("integrations in a simulated second, the larger cage, all taken back", "1/s",
      [&](int k) { return flights(costs.all, k) / costs.stretch.dt; });
  add("integrations in a simulated second, the larger cage, synchronised on every frame", "1/s",
      [&](int k) { return flights(costs.every[0], k) / costs.stretch.dt; });
  add("integrations in a simulated second, the larger cage, never synchronised", "1/s",
      [&](int k) { return flights(costs.never, k) / costs.stretch.dt; });
  add("the first number if every body is looked at in every frame and that is counted", "-",
      [&](int k) { return lost(costs, k, costs.stretch.count); });

  std::vector<Costs> rates = few;
  rates.insert(rates.end(), many.begin(), many.end());
  return {{table_by_period(costs, few.front()), table_by_rate(rates, seeds)}, quantities};
}

const Registered claim_2_4_3b_synchronising_figure{
    {.name = "claim_2_4_3b_synchronising",
     .parameters =
         cage_settings()
             .add(whole("larger", 512, 8, 1000, "cubes in the larger cage"))
             .add(whole("smaller", 64, 8, 1000, "cubes in the smaller cage"))
             .add(
                 whole("flights", 4, 1, 100,
                       "of 8 frames each, in which the work of the smaller cage is counted; of the "
                       "larger one it is counted in one")),
     .quick = {"seeds=4", "lead=20", "larger=64", "smaller=27"},
     .experiment = measure_synchronising}};

}  // namespace

}  // namespace tumble::chapters
