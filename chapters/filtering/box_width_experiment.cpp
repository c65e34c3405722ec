/// \file
/// \brief Claim 5.5b: what wider box filters remove, blur and make overlap.
#include "tumble/filtering/box_filter.hpp"
#include "tumble/record/overlap.hpp"

#include "filtering/shown_clump.hpp"

namespace tumble::chapters {
namespace {

constexpr std::array<int, 8> kWidths = {1, 3, 5, 7, 9, 11, 13, 15};
constexpr std::size_t kRaw = 0;  // places of widths 1, 5 and 15
constexpr std::size_t kFive = 2;
constexpr std::size_t kWidest = 7;
constexpr double kAtLeastHalf = 0.5;  // what the claim's sayings compare with
constexpr double kFall = 1.0;         // [m] of the cube that lands
constexpr std::array<std::size_t, 3> kDrawn = {kRaw, kFive, kWidest};

// Overlap while a clump flies together and settles.
struct Overlap {
  double deepest = 0.0;  // [m] in any frame
  double added = 0.0;    // [m] most in a frame, shown less computed
};

template <class T>
using ByWidth = std::array<T, kWidths.size()>;

// What all clumps give, by seed.
struct Clumps {
  std::vector<ByWidth<Shake>> medians;
  std::vector<ByWidth<Overlap>> overlaps;
};

ByWidth<Overlap> overlaps_of(const SettledRun& run, const ByWidth<Trajectory>& shown, int frames) {
  ByWidth<Overlap> out;
  OverlapMeter meter;
  for (int n = 0; n < std::min(frames, run.frames.count()); ++n) {
    double computed = 0.0;
    for (std::size_t w = 0; w < kWidths.size(); ++w) {
      const double depth = meter.look(run.world.bodies(), shown[w].frame(n).states);
      if (w == kRaw) computed = depth;
      out[w].deepest = std::max(out[w].deepest, depth);
      out[w].added = std::max(out[w].added, depth - computed);
    }
  }
  return out;
}

ByWidth<Trajectory> shown_by_width(const SettledRun& run) {
  ByWidth<Trajectory> shown;
  for (std::size_t w = 0; w < kWidths.size(); ++w)
    shown[w] = filtered(run.frames, BoxFilter(kWidths[w]));
  return shown;
}

// Some clumps until they rest, and more of them only while they fly together: how deep overlaps are
// differs more from seed to seed.
Clumps watch_clumps(const Parameters& settings) {
  const double flying = settings.number("flying");
  Clumps all;
  const int frames = static_cast<int>(std::lround(flying / kStep));
  const auto look_for_overlap = [&](const SettledRun& run, const ByWidth<Trajectory>& shown) {
    if (static_cast<int>(all.overlaps.size()) < settings.count("piles"))
      all.overlaps.push_back(overlaps_of(run, shown, frames));
  };
  for (int seed = 1; seed <= settings.count("seeds"); ++seed) {
    const ChatteringClump clump = chattering_clump(settings, seed);
    const ByWidth<Trajectory> shown = shown_by_width(clump.run);
    all.medians.emplace_back();
    for (std::size_t w = 0; w < kWidths.size(); ++w)
      all.medians.back()[w] = median_shake(clump.shakes(shown[w]));
    look_for_overlap(clump.run, shown);
  }
  for (int seed = settings.count("seeds") + 1; seed <= settings.count("piles"); ++seed) {
    const auto chance = static_cast<std::uint64_t>(seed);
    const SettledRun run =
        damped_clump(settings.count("per_edge"), chance, flying,
                     0.5);  // longer by half a second, so that no window is cut before
    look_for_overlap(run, shown_by_width(run));
  }
  return all;
}

// A cube that falls flat onto the ground, for twice as long as is looked at.
struct Landing {
  SettledRun run;
  ByWidth<Trajectory> shown;
  std::size_t cube = 0;

  [[nodiscard]] double height(std::size_t width, int frame) const {
    return shown[width].frame(frame).states[cube].position_w.y();
  }
  [[nodiscard]] int frames() const { return run.frames.count() / 2 + 1; }
  // [m/s] sharpness: the largest change of the shown velocity from one frame to the next
  [[nodiscard]] double sharpness(std::size_t width) const {
    double largest = 0.0;
    for (int n = 2; n < frames(); ++n)
      largest = std::max(largest, std::abs((height(width, n) - height(width, n - 1)) -
                                           (height(width, n - 1) - height(width, n - 2))));
    return largest / kStep;
  }
};

Landing landing_under(const char* technique, const char* restitution) {
  Landing landing;
  landing.run = settle_scene(
      make_scene("bouncing_box",
                 {setting("height", kFall), std::string("restitution=") + restitution}),
      {technique, {}}, 0.0, 2.0);
  landing.cube = first_movable(landing.run.world);
  landing.shown = shown_by_width(landing.run);
  return landing;
}

Table impact_table(const Landing& landing) {
  Table table{"impact", {{"time_s", "s", "since the release of the cube"}}};
  for (const std::size_t w : kDrawn)
    table.columns.push_back({"height_" + std::to_string(kWidths[w]) + "_m", "m",
                             "of the lower face over the ground, this many frames averaged"});
  for (int n = 0; n < landing.frames(); ++n) {
    std::vector<double> heights;
    for (const std::size_t w : kDrawn) heights.push_back(landing.height(w, n) - 0.5);
    table.add(landing.run.frames.frame(n).time, heights);
  }
  return table;
}

// The ratio of the medians of two widths.
Quantity shake_ratio(const std::string& name, const Clumps& clumps, std::size_t width,
                     std::size_t before, double Shake::*number) {
  return mean_of(name, "-", clumps.medians, [&](const ByWidth<Shake>& seed) {
    return seed[width].*number / seed[before].*number;
  });
}

// Deepest overlap in the whole run, shown less computed. It decides, as was chosen before the first run:
// the overlap added in the worst frame cannot be below 0. Four clumps left its sign open, so there are 24.
Quantity made_overlap(const std::string& name, const Clumps& clumps, std::size_t width) {
  return mean_of(name, "m", clumps.overlaps, [&](const ByWidth<Overlap>& seed) {
    return seed[width].deepest - seed[kRaw].deepest;
  });
}

// Most that a frame has above what is computed in that frame.
Quantity added_overlap(const std::string& name, const Clumps& clumps, std::size_t width) {
  return mean_of(name, "m", clumps.overlaps,
                 [&](const ByWidth<Overlap>& seed) { return seed[width].added; });
}

Table width_table(const Clumps& clumps, const Landing& landing) {
  Table table{"",
              {{"frames", "-", "width of the box filter"},
               {"sharpness", "-", "of an impact, over that computed"},
               {"white", "-", "squirm over that computed, of white noise"}}};
  add_interval_columns("amplitude", "-", "over that computed", table);
  add_interval_columns("squirm", "-", "over that computed", table);
  add_interval_columns("overlap_m", "m",
                       "deepest overlap while a clump settles, shown less computed", table);
  add_interval_columns("added_m", "m", "most that is added to the overlap of a frame", table);
  for (std::size_t w = 0; w < kWidths.size(); ++w)
    table.add(kWidths[w], landing.sharpness(w) / landing.sharpness(kRaw),
              squirm_of_white_noise("", kWidths[w], 1).value,
              with_interval(shake_ratio("", clumps, w, kRaw, &Shake::amplitude)),
              with_interval(shake_ratio("", clumps, w, kRaw, &Shake::squirm)),
              with_interval(made_overlap("", clumps, w)),
              with_interval(added_overlap("", clumps, w)));
  return table;
}

Result measure_box_widths(const Parameters& settings) {
  const Clumps clumps = watch_clumps(settings);
  const Landing landing = landing_under("contact_damped", "0");
  const Landing bounce = landing_under("impulse", "0.5");

  const Quantity squirm =
      shake_ratio("squirm at 15 frames over that at 5", clumps, kWidest, kFive, &Shake::squirm);
  const double blunt = landing.sharpness(kWidest) / landing.sharpness(kFive);
  const Quantity overlap = made_overlap(
      "deepest overlap while a clump settles, shown at 15 frames less computed", clumps, kWidest);
  const auto deeper = std::ranges::count_if(
      clumps.overlaps, [](const auto& seed) { return seed[kWidest].deepest > seed[kRaw].deepest; });
  OverlapMeter meter;
  const auto depth = [&](const Trajectory& frames, int n) {
    return meter.look(landing.run.world.bodies(), frames.frame(n).states);
  };
  double landed = 0.0;
  for (int n = 0; n < landing.frames(); ++n)
    landed = std::max(landed, depth(landing.shown[kWidest], n) - depth(landing.run.frames, n));
  constexpr int in_flight = kWidths[kFive] / 2;  // the first frame with a whole window of 5
  const double held = (squirm.value <= kAtLeastHalf ? 1.0 : 0.0) +
                      (blunt <= kAtLeastHalf ? 1.0 : 0.0) + (overlap.value > 0.0 ? 1.0 : 0.0);

  return {
      {width_table(clumps, landing), impact_table(landing)},
      {{"of three sayings about wider kernels those that hold: at 15 frames half of the squirm at "
        "5 "
        "or less, half of the sharpness of an impact at 5 or less, and overlap of filtered bodies "
        "above that of unfiltered ones",
        "-", held},
       squirm,
       {"sharpness of an impact at 15 frames over that at 5", "-", blunt},
       overlap,
       made_overlap("the same at 5 frames", clumps, kFive),
       added_overlap("most that filtering over 15 frames adds to the overlap of a frame", clumps,
                     kWidest),
       share_of_trials("share of the clumps in which the deepest overlap is deeper as shown",
                       deeper, static_cast<std::int64_t>(clumps.overlaps.size())),
       squirm_of_white_noise("squirm at 15 frames over that at 5 if chatter were white noise",
                             kWidths[kWidest], kWidths[kFive]),
       {"sharpness of a bounce at 15 frames over that at 5", "-",
        bounce.sharpness(kWidest) / bounce.sharpness(kFive)},
       {"overlap with the ground of a landing cube that filtering over 15 frames adds", "m",
        landed},
       {"height by which a falling cube is shown too low at 5 frames", "m",
        landing.height(kRaw, in_flight) - landing.height(kFive, in_flight)}}};
}

const Registered claim_5_5b_width_figure{
    {.name = "claim_5_5b_width",
     .parameters =
         chattering_clump_parameters()
             .add(number("flying", 3.0, 0.1, 1000.0, "s", "in which overlap is looked for"))
             .add(whole("piles", 24, 2, 1000, "clumps in which overlap is looked for")),
     .quick = {"seeds=2", "per_edge=4", "settling=6", "watched=2", "piles=2"},
     .experiment = measure_box_widths}};

}  // namespace
}  // namespace tumble::chapters
