/// \file
/// \brief How often the forms of the timewarp tell a crowded frame wrong (thesis 5.1).
#include "timewarp/crowd_experiments.hpp"

#include "driver/common_numbers.hpp"
#include "driver/statistics.hpp"
#include "timewarp/crowd_scenes.hpp"
#include "timewarp/story_tellers.hpp"

#include <array>
#include <functional>
#include <string>

namespace tumble::chapters {
namespace {

constexpr int kChain = 5;  // cubes, as in figure 5.1

// How far the fastest two can come towards each other in a frame, in edges.
constexpr std::array<double, 6> kWays = {0.25, 0.5, 1.0, 2.0, 4.0, 8.0};
// Those that decide, each as often as the others: from a quarter of the two edges up to which
// bodies on a line cannot change places to twice as many. And the fastest.
constexpr std::size_t kFirstWay = 1;
constexpr std::size_t kLastWay = 4;
constexpr std::size_t kFastest = 5;
// [m] room of a cube in the scenes, by turns. The first is as dense as the scene can be.
constexpr std::array<double, 2> kRooms = {1.8, 2.0};

// Frames by seed and by speed.
using Frames = std::vector<std::array<StoryForms, kWays.size()>>;

// How the two references differ, by the number of steps.
constexpr std::array<int, 3> kSteps = {64, 256, 1024};
struct Checks {
  std::array<StoryTally, kSteps.size()> in_steps;
  StoryTally finer;  // against itself with a tenth of its tolerance, in the fastest frames
};

void check(const Parameters& settings, StoryTellers& tellers, const World& world, std::size_t way,
           const std::vector<Collision>& truth, Checks& checks) {
  if (way == kFastest) checks.finer.add(compare_stories(truth, tellers.finer(world, kStep)));
  if (way < kFirstWay || way > kLastWay) return;
  for (std::size_t k = 0; k < kSteps.size(); ++k)
    if (kSteps[k] <= settings.count("finest"))
      checks.in_steps[k].add(compare_stories(truth, tellers.in_steps(world, kStep, kSteps[k])));
}

Frames crowded_frames(const Parameters& settings, StoryTellers& tellers, Checks& checks) {
  Frames frames(static_cast<std::size_t>(settings.count("seeds")));
  for (std::size_t seed = 0; seed < frames.size(); ++seed) {
    StirredCage cage(settings.count("cubes"), kRooms[seed % kRooms.size()], seed + 1);
    const Random chance(seed + 1);
    for (int frame = 0; frame < settings.count("frames"); ++frame) {
      const Random here = chance.fork(static_cast<std::uint64_t>(frame));
      for (std::size_t way = 0; way < kWays.size(); ++way) {
        if (way == kFastest && frame > 0) continue;  // it takes as long as all others together
        const World world = cage.with_speeds(0.5 * kWays[way] / kStep, here.fork(way));
        const std::vector<Collision> truth = tellers.truth(world, kStep);
        tellers.hear(world, kStep, truth, frames[seed][way]);
        if (frame == 0 && static_cast<int>(seed) < settings.count("checked"))
          check(settings, tellers, world, way, truth, checks);
      }
      cage.stir();
    }
  }
  return frames;
}

StoryForms of_way(const Frames& frames, std::size_t way) {
  StoryForms all;
  for (const auto& seed : frames)
    for (std::size_t form = 0; form < all.size(); ++form) all[form].add(seed[way][form]);
  return all;
}

// Those that decide, of one seed.
StoryTally deciding(const Frames& frames, std::size_t seed, std::size_t form) {
  StoryTally all;
  for (std::size_t way = kFirstWay; way <= kLastWay; ++way) all.add(frames[seed][way][form]);
  return all;
}

// A count of the safer form over that of the simple one.
Quantity safer_over_simple(const std::string& name, int seeds,
                           const std::function<double(std::size_t seed, std::size_t form)>& count) {
  std::array<std::vector<double>, 2> counts;
  for (std::size_t form = 0; form < counts.size(); ++form)
    for (int seed = 0; seed < seeds; ++seed)
      counts[form].push_back(count(static_cast<std::size_t>(seed), form));
  return over_seeds(name, "-", seeds, [&](int left_out) {
    return sum_without(counts[1], left_out) / sum_without(counts[0], left_out);
  });
}

// Of the true events those that a form missed or told out of order, at one speed.
Quantity share_of_events(const Frames& frames, std::size_t way, std::size_t form) {
  std::vector<double> wrong;
  std::vector<double> reference;
  for (const auto& seed : frames) {
    wrong.push_back(seed[way][form].wrong());
    reference.push_back(seed[way][form].reference);
  }
  return over_seeds("", "-", static_cast<int>(frames.size()), [&](int left_out) {
    return sum_without(wrong, left_out) / sum_without(reference, left_out);
  });
}

Table table_of(const std::string& suffix, const std::string& what) {
  Table table{suffix, {{"way", "-", "largest relative way in a frame, in edges"}}};
  for (const std::string form : {"simple", "safer", "swept"}) {
    table.columns.push_back({form, "-", "share of " + what + " told wrong, " + form});
    table.columns.push_back({form + "_low", "-", "95 % interval of it"});
    table.columns.push_back({form + "_high", "-", "95 % interval of it"});
  }
  return table;
}

void add_shares(Table& table, double way, const StoryForms& forms) {
  table.rows.push_back({way});
  for (const StoryTally& form : forms) {
    const Quantity share = share_of_trials("", form.told_wrong, form.frames);
    for (const double value : {share.value, share.low, share.high})
      table.rows.back().push_back(value);
  }
}

StoryForms chains_of(double way, int trials, StoryTellers& tellers) {
  StoryForms forms;
  const Random chance(static_cast<std::uint64_t>(1000.0 * way));
  for (int k = 0; k < trials; ++k) {
    const Chain chain =
        random_chain(kChain, way / kStep, chance.fork(static_cast<std::uint64_t>(k)));
    tellers.hear(world_of(chain), kStep, exact_story(chain, kStep), forms);
  }
  return forms;
}

}  // namespace

Result measure_crowd_order(const Parameters& settings) {
  const int seeds = settings.count("seeds");
  StoryTellers tellers(settings.number("resolution"));
  Checks checks;
  const Frames frames = crowded_frames(settings, tellers, checks);

  Result result;
  std::vector<Quantity>& out = result.quantities;
  const auto wrong = [&](std::size_t seed, std::size_t form) {
    return deciding(frames, seed, form).wrong();
  };
  out.push_back(safer_over_simple(
      "events missed or out of order, safer over simple, random crowded scenes", seeds, wrong));
  out.push_back(safer_over_simple("the same, missed only", seeds, [&](auto seed, auto form) {
    return deciding(frames, seed, form).missed;
  }));
  out.push_back(safer_over_simple("the same, out of order only", seeds, [&](auto seed, auto form) {
    return deciding(frames, seed, form).misordered;
  }));
  out.push_back(safer_over_simple("the same, denser and faster", seeds, [&](auto seed, auto form) {
    return seed % kRooms.size() == 0 ? frames[seed][kFastest][form].wrong() : 0.0;
  }));

  Table crowd = table_of("", "frames");
  for (const std::string form : {"simple", "safer", "swept"}) {
    crowd.columns.push_back(
        {form + "_events", "-", "share of the events missed or out of order, " + form});
    crowd.columns.push_back({form + "_events_low", "-", "95 % interval of it"});
    crowd.columns.push_back({form + "_events_high", "-", "95 % interval of it"});
  }
  crowd.columns.push_back({"events", "-", "true events of a frame, mean"});
  crowd.columns.push_back({"decides", "-", "1: counts for the claim"});
  double swept_wrong = 0.0;
  for (std::size_t way = 0; way < kWays.size(); ++way) {
    const StoryForms forms = of_way(frames, way);
    const bool decides = way >= kFirstWay && way <= kLastWay;
    add_shares(crowd, kWays[way], forms);
    for (std::size_t form = 0; form < forms.size(); ++form) {
      const Quantity events = share_of_events(frames, way, form);
      for (const double value : {events.value, events.low, events.high})
        crowd.rows.back().push_back(value);
    }
    crowd.rows.back().push_back(forms[0].reference / static_cast<double>(forms[0].frames));
    crowd.rows.back().push_back(decides ? 1.0 : 0.0);
    if (decides) swept_wrong += forms[2].wrong();
  }
  const auto share = [&](const std::string& name, std::size_t way, std::size_t form) {
    const StoryTally all = of_way(frames, way)[form];
    out.push_back(share_of_trials(name, all.told_wrong, all.frames));
  };
  share("share of frames told wrong, simple, at half an edge", 1, 0);
  share("share of frames told wrong, safer, at half an edge", 1, 1);
  out.push_back({"events missed or out of order at half an edge to four, swept", "-", swept_wrong});

  Table chains = table_of("chains", "chains");
  StoryTally below;  // up to the bound
  for (const double way : {0.5, 1.0, 1.5, 2.0, 2.5, 3.0, 4.0, 6.0, 8.0}) {
    const StoryForms forms = chains_of(way, settings.count("chains"), tellers);
    add_shares(chains, way, forms);
    if (way <= 2.0) below.add(forms[0]);
    if (way == 4.0)
      out.push_back(share_of_trials("share of chains told wrong, simple, at twice the bound",
                                    forms[0].told_wrong, forms[0].frames));
  }
  out.push_back(share_of_trials("share of chains told wrong, simple, up to the bound of two edges",
                                below.told_wrong, below.frames));

  Table references{"references",
                   {{"steps", "-", "steps in a frame"},
                    {"differ", "-", "share of frames in which the references differ"},
                    {"low", "-", "95 % interval of it"},
                    {"high", "-", "95 % interval of it"},
                    {"events", "-", "share of the events that differ"}}};
  for (std::size_t k = 0; k < kSteps.size(); ++k) {
    const StoryTally& check = checks.in_steps[k];
    if (check.frames == 0) continue;
    const Quantity differ = share_of_trials(
        "share of frames in which a reference by " + std::to_string(kSteps[k]) + " steps differs",
        check.told_wrong, check.frames);
    references.rows.push_back({static_cast<double>(kSteps[k]), differ.value, differ.low,
                               differ.high, check.wrong() / check.reference});
    if (kSteps[k] == 64 || kSteps[k] == settings.count("finest")) out.push_back(differ);
  }
  out.push_back(share_of_trials(
      "share of frames in which a tenth of the tolerance changes the reference, at eight edges",
      checks.finer.told_wrong, checks.finer.frames));
  result.tables = {crowd, chains, references};
  return result;
}

}  // namespace tumble::chapters
