/// \file
/// \brief Crowded frames in which the forms of the timewarp go wrong (thesis 5.1).
#include "timewarp/crowd_scenes.hpp"
#include "timewarp/event_story.hpp"

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

// How stories of frames depart from the true ones, in all.
struct StoryTally {
  std::int64_t frames = 0;
  std::int64_t wrong_frames = 0;  // those with a collision missed or out of order
  double reference = 0.0;         // collisions of the true stories
  double missed = 0.0;            // see StoryDifference
  double misordered = 0.0;        // ditto

  void add(const StoryDifference& difference) {
    ++frames;
    if (difference.missed + difference.misordered > 0) ++wrong_frames;
    reference += difference.reference;
    missed += difference.missed;
    misordered += difference.misordered;
  }
  void add(const StoryTally& other) {
    frames += other.frames;
    wrong_frames += other.wrong_frames;
    reference += other.reference;
    missed += other.missed;
    misordered += other.misordered;
  }
  [[nodiscard]] double wrong() const { return missed + misordered; }
  [[nodiscard]] Quantity share_of_frames(const std::string& name) const {
    return share_of_trials(name, wrong_frames, frames);
  }
};

// One for each form of the timewarp: simple, safer, swept.
using StoryForms = std::array<StoryTally, 3>;
constexpr std::array<const char*, 3> kForms = {"simple", "safer", "swept"};

// The forms and their references, all with one tolerance.
struct CrowdTechniques {
  explicit CrowdTechniques(double resolution)
      : reference(search_over_all(resolution)),
        finer(search_over_all(0.1 * resolution)),
        discrete(make_technique("basic", {setting("resolution", resolution)})) {
    for (const std::string form : kForms)
      forms.push_back(make_technique("timewarp_" + form, {setting("resolution", resolution)}));
  }
  void compare(const World& world, const std::vector<Collision>& truth, StoryForms& tallies) {
    for (std::size_t k = 0; k < forms.size(); ++k)
      tallies[k].add(compare_stories(truth, story_of(*forms[k], world, kStep)));
  }
  std::unique_ptr<Technique> reference;
  std::unique_ptr<Technique> finer;
  std::unique_ptr<Technique>
      discrete;  // tests all bodies at the end of a step, in many small steps
  std::vector<std::unique_ptr<Technique>> forms;
};

// Frames by seed and by speed.
using Frames = std::vector<std::array<StoryForms, kWays.size()>>;

// How other references differ from the one that is used.
struct Checks {
  std::map<int, StoryTally> in_steps;  // by the number of steps in a frame
  StoryTally finer;  // against itself with a tenth of its tolerance, in the fastest frames
};

void check(CrowdTechniques& techniques, const World& world, std::size_t way,
           const std::vector<Collision>& truth, Checks& checks) {
  if (way == kFastest)
    checks.finer.add(compare_stories(truth, story_of(*techniques.finer, world, kStep)));
  if (way < kFirstWay || way > kLastWay) return;
  for (auto& [steps, tally] : checks.in_steps)
    tally.add(compare_stories(truth, story_of(*techniques.discrete, world, kStep / steps, steps)));
}

Frames crowded_frames(const Parameters& settings, CrowdTechniques& techniques, Checks& checks) {
  Frames frames(static_cast<std::size_t>(settings.count("seeds")));
  for (std::size_t seed = 0; seed < frames.size(); ++seed) {
    World cage = stirred_cage(settings.count("cubes"), kRooms[seed % kRooms.size()], seed + 1);
    const Random chance(seed + 1);
    for (int frame = 0; frame < settings.count("frames"); ++frame) {
      const Random here = chance.fork(static_cast<std::uint64_t>(frame));
      for (std::size_t way = 0; way < kWays.size(); ++way) {
        if (way == kFastest && frame > 0) continue;  // it takes as long as all others together
        const World world = with_speeds(cage, 0.5 * kWays[way] / kStep, here.fork(way));
        const std::vector<Collision> truth = story_of(*techniques.reference, world, kStep);
        techniques.compare(world, truth, frames[seed][way]);
        if (frame == 0 && static_cast<int>(seed) < settings.count("checked"))
          check(techniques, world, way, truth, checks);
      }
      stir(cage);
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

// A count over another one, each summed over the seeds.
Quantity ratio_over_seeds(const std::string& name, std::size_t seeds,
                          const std::function<double(std::size_t seed)>& above,
                          const std::function<double(std::size_t seed)>& below) {
  std::vector<double> numerators, denominators;
  for (std::size_t seed = 0; seed < seeds; ++seed) {
    numerators.push_back(above(seed));
    denominators.push_back(below(seed));
  }
  return ratio_of_sums(name, "-", numerators, denominators);
}

// Of the true events those that a form missed or resolved out of order, at one speed.
Quantity share_of_events(const Frames& frames, std::size_t way, std::size_t form) {
  return ratio_over_seeds(
      "", frames.size(), [&](std::size_t seed) { return frames[seed][way][form].wrong(); },
      [&](std::size_t seed) { return frames[seed][way][form].reference; });
}

Table table_of_shares(const std::string& suffix, const std::string& what) {
  Table table{suffix, {{"way", "-", "largest relative way in a frame, in edges"}}};
  for (const std::string form : kForms)
    add_interval_columns(form, "-", "share of wrong " + what + ", " + form, table);
  return table;
}

std::vector<double> shares_of_frames(const StoryForms& forms) {
  std::vector<double> shares;
  for (const StoryTally& form : forms)
    for (const double value : with_interval(form.share_of_frames(""))) shares.push_back(value);
  return shares;
}

Table crowd_table(const Frames& frames) {
  Table table = table_of_shares("", "frames");
  for (const std::string form : kForms)
    add_interval_columns(form + "_events", "-",
                         "share of the events missed or out of order, " + form, table);
  for (std::size_t way = 0; way < kWays.size(); ++way)
    table.add(kWays[way], shares_of_frames(of_way(frames, way)),
              with_interval(share_of_events(frames, way, 0)),
              with_interval(share_of_events(frames, way, 1)),
              with_interval(share_of_events(frames, way, 2)));
  return table;
}

StoryForms chains_of(double way, int trials, CrowdTechniques& techniques) {
  StoryForms forms;
  const Random chance(static_cast<std::uint64_t>(1000.0 * way));
  for (int k = 0; k < trials; ++k) {
    const Chain chain =
        random_chain(kChain, way / kStep, chance.fork(static_cast<std::uint64_t>(k)));
    techniques.compare(world_of(chain), exact_story(chain, kStep), forms);
  }
  return forms;
}

Table measure_chains(int trials, CrowdTechniques& techniques, std::vector<Quantity>& out) {
  Table table = table_of_shares("chains", "chains");
  StoryTally below;  // up to the bound
  for (const double way : {0.5, 1.0, 1.5, 2.0, 2.5, 3.0, 4.0, 6.0, 8.0}) {
    const StoryForms forms = chains_of(way, trials, techniques);
    table.add(way, shares_of_frames(forms));
    if (way <= 2.0) below.add(forms[0]);
    if (way == 4.0)
      out.push_back(forms[0].share_of_frames("share of wrong chains, simple, at twice the bound"));
  }
  out.push_back(
      below.share_of_frames("share of wrong chains, simple, up to the bound of two edges"));
  return table;
}

// Each frame starts from a fresh state of cubes in a cage: places and orientations stirred, velocities
// drawn anew. Its story is held against that of a search over all bodies that misses nothing.
Result measure_crowd_order(const Parameters& settings) {
  CrowdTechniques techniques(settings.number("resolution"));
  Checks checks;
  for (const int steps : {64, settings.count("finest")}) checks.in_steps[steps];
  const Frames frames = crowded_frames(settings, techniques, checks);
  const std::size_t seeds = frames.size();

  Result result;
  std::vector<Quantity>& out = result.quantities;
  const auto safer_over_simple = [&](const std::string& name, const auto& count) {
    out.push_back(ratio_over_seeds(
        name, seeds, [&](std::size_t seed) { return count(seed, 1); },
        [&](std::size_t seed) { return count(seed, 0); }));
  };
  safer_over_simple(
      "events missed or out of order, safer over simple, random crowded scenes",
      [&](std::size_t seed, std::size_t form) { return deciding(frames, seed, form).wrong(); });
  safer_over_simple("the same, missed only", [&](std::size_t seed, std::size_t form) {
    return deciding(frames, seed, form).missed;
  });
  safer_over_simple("the same, out of order only", [&](std::size_t seed, std::size_t form) {
    return deciding(frames, seed, form).misordered;
  });
  safer_over_simple("the same, denser and faster", [&](std::size_t seed, std::size_t form) {
    return seed % kRooms.size() == 0 ? frames[seed][kFastest][form].wrong() : 0.0;
  });
  double swept_wrong = 0.0;
  for (std::size_t seed = 0; seed < seeds; ++seed) swept_wrong += deciding(frames, seed, 2).wrong();
  out.push_back({"events missed or out of order at half an edge to four, swept", "-", swept_wrong});

  result.tables = {crowd_table(frames), measure_chains(settings.count("chains"), techniques, out)};
  for (const auto& [steps, tally] : checks.in_steps)
    out.push_back(tally.share_of_frames("share of frames in which a reference by " +
                                        std::to_string(steps) + " steps differs"));
  out.push_back(checks.finer.share_of_frames(
      "share of frames in which a tenth of the tolerance changes the reference, at eight edges"));
  return result;
}

const Registered claim_5_1a_order_figure{
    {.name = "claim_5_1a_order",
     .parameters = {whole("seeds", 24, 2, 1000, "cages"),
                    whole("frames", 3, 1, 1000, "fresh states of each cage, at each speed"),
                    whole("cubes", 27, 2, 1000, "in a cage"),
                    whole("chains", 400, 1, 100000, "on a line, at each speed"),
                    whole("checked", 12, 1, 1000, "cages in which the two references are compared"),
                    whole("finest", 1024, 64, 1024, "steps in a frame of the other reference"),
                    number("resolution", 1e-9, 1e-12, 1e-3, "s", "of every search for collisions")},
     .quick = {"seeds=4", "frames=2", "chains=60", "finest=64"},
     .experiment = measure_crowd_order}};

}  // namespace
}  // namespace tumble::chapters
