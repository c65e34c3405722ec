/// \file
/// \brief The time until dice rest, with randomness in some collisions (thesis 4.2).
#include "impulse_damped/damped_variants.hpp"
#include "impulse_damped/settled_boxes.hpp"

namespace tumble::chapters {
namespace {

// Which collisions are left to chance, in the order of the figure.
constexpr std::array<Randomness, 4> kRules{Randomness::off, Randomness::fast, Randomness::slow,
                                           Randomness::all};

// What is thrown and how it is damped.
struct Setting {
  std::string scene = "dice";
  std::string parts = "all";
  DampedScales scales = {};
  double chance = 1.0;  // how much is left to it, over the usual
};

DampedOptions options_of(const Setting& setting, Randomness rule, int seed) {
  DampedOptions options = damped_options(setting.parts, setting.scales, seed);
  options.noise.where = rule;
  options.noise.normal *= setting.chance;
  options.noise.restitution *= setting.chance;
  return options;
}

World thrown(const std::string& scene, int seed) {
  if (scene == "clump") return clump(3, seed);
  return build_world(make_scene(scene, {}, static_cast<std::uint64_t>(seed)));
}

// By seed: the time to rest, mean over the dice of a throw. A die that does not rest counts with the whole run.
using Times = std::vector<double>;

// after: the seeds are those that follow this one
Times rest_times(const Setting& setting, Randomness rule, int seeds, double duration,
                 int after = 0) {
  Times times;
  for (int seed = after + 1; seed <= after + seeds; ++seed) {
    const std::vector<BoxEnd> ends =
        settle(thrown(setting.scene, seed), options_of(setting, rule, seed), duration);
    double sum = 0.0;
    for (const BoxEnd& end : ends) sum += end.rest_time;
    times.push_back(sum / static_cast<double>(ends.size()));
  }
  return times;
}

// [m] height of the lowest corner of the first die after each step.
std::vector<double> lowest_corner(const Setting& setting, Randomness rule, double duration) {
  World world = thrown(setting.scene, 1);
  Damped technique(options_of(setting, rule, 1));
  std::vector<double> heights;
  while (world.time() < duration - 0.5 * kStep) {
    finished(technique.step(world, kStep));
    const Box die = box_of(world.bodies()[1], world.states()[1]);
    heights.push_back(die.center_w.y() - reach(die, Vec3::UnitY()));
  }
  return heights;
}

Result measure_chance(const Parameters& settings) {
  const int seeds = settings.count("seeds");
  const double duration = settings.number("duration");
  const auto times = [&](const Setting& setting, Randomness rule) {
    return rest_times(setting, rule, seeds, duration);
  };
  Result result;
  const Setting usual;
  const Setting scaling{"dice", "scale"};
  Table table{"",
              {{"rule", "-", "chance 1 nowhere, 2 in fast collisions, 3 in slow ones, 4 in all"},
               {"rest_s", "s", "mean time to rest of dice, with the damping"},
               {"rest_scaled_s", "s", "the same with the scaling of velocities only"}}};
  std::array<Times, 4> damped;
  const auto mean = [&](const Times& all) { return sum_without(all, -1) / seeds; };
  for (std::size_t r = 0; r < kRules.size(); ++r) {
    damped[r] = times(usual, kRules[r]);
    table.add(r + 1, mean(damped[r]), mean(times(scaling, kRules[r])));
  }

  std::vector<Quantity>& out = result.quantities;
  out.push_back(
      ratio_of_sums("time to rest with randomness in slow collisions too, over the time with "
                    "randomness in fast ones only",
                    "-", damped[3], damped[1]));
  out.push_back(
      ratio_of_sums("time to rest with randomness in slow collisions too, over the time with "
                    "randomness in fast ones only, fresh seeds",
                    "-", rest_times(usual, kRules[3], seeds, duration, seeds),
                    rest_times(usual, kRules[1], seeds, duration, seeds)));
  const auto variant = [&](const std::string& name, const Setting& setting) {
    out.push_back(ratio_of_sums("the same, " + name, "-", times(setting, kRules[3]),
                                times(setting, kRules[1])));
  };
  for (const DampedScales& scales : other_scales) variant(scales.words, {"dice", "all", scales});
  variant("tossed cubes", {"toss"});
  variant("27 cubes that fly together", {"clump"});
  variant("three times as much chance", {"dice", "all", {}, 3.0});
  out.push_back(
      ratio_of_sums("time to rest with randomness in fast collisions, over the time without any",
                    "-", damped[1], damped[0]));

  Table path{"path",
             {{"time_s", "s", "time"},
              {"fast_mm", "mm", "height of a die's lowest corner, chance in fast collisions"},
              {"all_mm", "mm", "the same, chance in all collisions"}}};
  const std::vector<double> fast = lowest_corner(usual, kRules[1], duration);
  const std::vector<double> all = lowest_corner(usual, kRules[3], duration);
  for (std::size_t n = 0; n < fast.size(); ++n)
    path.add(static_cast<double>(n + 1) * kStep, 1e3 * fast[n], 1e3 * all[n]);
  result.tables = {table, path};
  return result;
}

const Registered claim_4_2a_chance_figure{
    {.name = "claim_4_2a_chance",
     .parameters = {number("duration", 6.0, 1.0, 60.0, "s", "of each run"),
                    whole("seeds", 40, 2, 1000, "throws")},
     .quick = {"duration=2.5", "seeds=2"},
     .experiment = measure_chance}};

}  // namespace
}  // namespace tumble::chapters
