/// \file
/// \brief The clump of figure 6.7 with adaptive steps, against fixed ones (claim 6.3.1b).
#include "filtering/adaptive_runs.hpp"

namespace tumble::chapters {
namespace {

// Set down before the first run: 0.5 and 0.9 are the claim's; chatter is the median amplitude of the
// bodies that rest while they are watched; the time to rest is when nine tenths of the bodies have
// come to rest (see RestingMeasures). The quantities show what the mean, and the median body, give.
// The number of halvings was not: two, to 1/240 s, is what a figure can afford. The page shows what four
// halvings do to the verdict.
constexpr double kHalfTheChatter = 0.5;
constexpr double kSooner = 0.9;

// What one seed gives with one kind of step.
struct SteppedSeed {
  RestingMeasures resting;
  std::vector<int> substeps;  // by frame, of adaptive steps
  StepReport work;
};
using Seeds = std::vector<SteppedSeed>;

// Both kinds of step.
struct Sides {
  Seeds fixed, adaptive;
};

// Adds what a seed gives with fixed steps and with adaptive ones.
void settle_seed(const Parameters& settings, int seed, Sides& sides) {
  const auto chance = static_cast<std::uint64_t>(seed);
  const int per_edge = settings.count("per_edge");
  const double settling = settings.number("settling"), watched = settings.number("watched");
  const SettledRun fixed = damped_clump(per_edge, chance, settling, watched);
  sides.fixed.push_back({measure_resting(fixed), {}, fixed.work()});
  AdaptiveStepOptions options{.halvings = settings.count("halvings")};
  const SteppedRun run =
      settle_in_steps(clump_scene(per_edge, chance), make_technique("damped", {}, chance), options,
                      settling, watched);
  sides.adaptive.push_back({measure_resting(run.run), run.substeps, run.run.work()});
}

template <class Number>
Quantity adaptive_over_fixed(const std::string& name, const Sides& sides, const Number& number) {
  return ratio_of_sums(name + ", adaptive over fixed", "-", numbers_of(sides.adaptive, number),
                       numbers_of(sides.fixed, number));
}

double time_to_rest(const SteppedSeed& seed) { return seed.resting.time_to_rest(); }

double mean_share_moving(const Seeds& seeds, double time) {
  double share = 0.0;
  for (const SteppedSeed& seed : seeds)
    share += share_moving(seed.resting, time) / static_cast<double>(seeds.size());
  return share;
}

// By time: bodies that still move, and sub-steps; means over the seeds.
Table time_table(const Sides& sides) {
  Table table{"",
              {{"time_s", "s", "end of the step"},
               {"fixed", "-", "share of the bodies that still move, fixed steps"},
               {"adaptive", "-", "ditto, adaptive steps"},
               {"substeps", "-", "sub-steps of the adaptive step, mean over the seeds"}}};
  for (std::size_t frame = 1; frame < sides.adaptive[0].substeps.size(); ++frame) {
    const double time = static_cast<double>(frame) * kStep;
    double substeps = 0.0;
    for (const SteppedSeed& seed : sides.adaptive)
      substeps += seed.substeps[frame] / static_cast<double>(sides.adaptive.size());
    table.add(time, mean_share_moving(sides.fixed, time), mean_share_moving(sides.adaptive, time),
              substeps);
  }
  return table;
}

// Of the bodies of all seeds that rest, those that shake by an amplitude or more.
double share_shaking(const Seeds& seeds, double amplitude_mm) {
  double above = 0.0;
  double all = 0.0;
  for (const SteppedSeed& seed : seeds) {
    all += static_cast<double>(seed.resting.amplitudes.size());
    for (const double a : seed.resting.amplitudes) above += 1e3 * a >= amplitude_mm ? 1.0 : 0.0;
  }
  return above / std::max(all, 1.0);
}

Table amplitude_table(const Sides& sides) {
  Table table{"amplitudes",
              {{"amplitude_mm", "mm", "peak to peak"},
               {"fixed", "-", "share of the resting bodies that shake by as much, fixed steps"},
               {"adaptive", "-", "ditto, adaptive steps"}}};
  constexpr int kPerDecade = 20;
  for (int k = -2 * kPerDecade; k <= kPerDecade; ++k) {
    const double amplitude = elementary::pow(10.0, static_cast<double>(k) / kPerDecade);  // [mm]
    table.add(amplitude, share_shaking(sides.fixed, amplitude),
              share_shaking(sides.adaptive, amplitude));
  }
  return table;
}

double sayings(double of_chatter, double of_time) {
  return (of_chatter <= kHalfTheChatter ? 1.0 : 0.0) + (of_time <= kSooner ? 1.0 : 0.0);
}

Result measure_adaptive_claim(const Parameters& settings) {
  Sides sides;
  for (int seed = 1; seed <= settings.count("seeds"); ++seed) settle_seed(settings, seed, sides);
  const Quantity of_chatter =
      adaptive_over_fixed("median amplitude of resting bodies", sides,
                          [](const SteppedSeed& seed) { return seed.resting.chatter(); });
  const Quantity of_time = adaptive_over_fixed("time to rest", sides, time_to_rest);
  return {
      {time_table(sides), amplitude_table(sides)},
      // An interval's lower end is what holds at the unfavourable ends of the two ratios.
      {{"of two sayings about a step that adapts those that hold: half of the chatter or less, "
        "and nine tenths of the time to rest or less, against the fixed step",
        "-", sayings(of_chatter.value, of_time.value), sayings(of_chatter.high, of_time.high),
        sayings(of_chatter.low, of_time.low), of_chatter.seeds},
       of_chatter,
       of_time,
       adaptive_over_fixed("mean amplitude of resting bodies", sides,
                           [](const SteppedSeed& seed) { return seed.resting.mean_chatter(); }),
       adaptive_over_fixed("time until half of the bodies rest", sides,
                           [](const SteppedSeed& seed) { return seed.resting.time_to_rest(0.5); }),
       adaptive_over_fixed("pair tests", sides,
                           [](const SteppedSeed& seed) { return seed.work.pair_tests; }),
       adaptive_over_fixed("integrations", sides,
                           [](const SteppedSeed& seed) { return seed.work.integrations; }),
       mean_of("time to rest, fixed", "s", sides.fixed, time_to_rest)}};
}

const Registered claim_6_3_1b_adaptive_figure{
    {.name = "claim_6_3_1b_adaptive",
     .parameters = adaptive_parameters(20, 5, 2),
     .quick = {"seeds=2", "settling=1", "watched=0.5", "halvings=1"},
     .experiment = measure_adaptive_claim}};

}  // namespace
}  // namespace tumble::chapters
