/// \file
/// \brief A clump that falls asleep although it chatters, and is woken by a cube (thesis 4.5, 6.3.1).
#include "tumble/filtering/chatter_detector.hpp"
#include "tumble/record/chatter.hpp"

#include "driver/experiment.hpp"
#include "filtering/settled_run.hpp"

namespace tumble::chapters {
namespace {

constexpr int kFrameRate = 60;     // [1/s]
constexpr std::size_t kTenth = 6;  // [frame] a tenth of a second

// The state after a step.
struct Look {
  double awake = 0.0;     // bodies
  double chatters = 0.0;  // bodies that chatter, over the last half second
  double pair_tests = 0.0;
};

// One clump with one kind of sleep.
struct SleepRun {
  std::vector<Look> looks;  // by step
  double woken =
      0.0;  // bodies awake, at most, in the first second and a half after the cube comes in
};

// The clump, and a cube that comes in from the side at the end.
Scene with_late_cube(const Parameters& settings, std::uint64_t seed) {
  Scene scene = clump_scene(settings.count("per_edge"), seed);
  SceneBox cube = scene.boxes.front();
  cube.name = "late";
  cube.appears = settings.number("settling");
  const double speed = settings.number("speed");
  cube.position_w = Vec3(-15.0, 2.0, 0.0);
  cube.orientation_wb = Quat::Identity();
  cube.velocity_w = Vec3(speed, 2.0, 0.0);
  cube.angular_velocity_w = Vec3::Zero();
  scene.boxes.push_back(cube);
  return scene;
}

double chattering(const ChatterMeter& meter, const World& world) {
  double count = 0.0;
  for (const BodyChatter& body : meter.each(world.gravity_w.norm())) {
    const auto k = static_cast<std::size_t>(world.index_of(body.id));
    if (body.amplitude >= kChatters * world.bodies()[k].size.minCoeff()) count += 1.0;
  }
  return count;
}

SleepRun play(const Parameters& settings, std::uint64_t seed, const PlayedTechnique& technique) {
  PlayedScene played(with_late_cube(settings, seed), technique, seed);
  const double settling = settings.number("settling");
  ChatterMeter meter;
  std::vector<char> touches;
  SleepRun run;
  played.advance(settling + settings.number("watched"), [&](const StepReport& report) {
    const World& world = played.world();
    mark_contacts(world, played.technique().contacts(), touches);
    Look look;
    for (std::size_t k = 0; k < world.states().size(); ++k) {
      if (!world.bodies()[k].movable()) continue;
      if (world.sleep_states()[k].asleep)
        touches[k] = 1;
      else
        look.awake += 1.0;
    }
    meter.add(world, touches);
    look.chatters = (run.looks.size() + 1) % kTenth == 0 || run.looks.empty()
                        ? chattering(meter, world)
                        : run.looks.back().chatters;
    look.pair_tests = static_cast<double>(report.pair_tests);
    run.looks.push_back(look);
    if (world.time() > settling && world.time() < settling + 1.5)
      run.woken = std::max(run.woken, look.awake);
  });
  return run;
}

// Numbers of the last two seconds before the cube comes in, means by seed.
std::vector<double> before_hit(const std::vector<SleepRun>& runs, const Parameters& settings,
                               double Look::*part) {
  const auto end =
      static_cast<std::size_t>(std::lround(settings.number("settling") * kFrameRate)) - 1;
  const std::size_t begin = end - 2 * static_cast<std::size_t>(kFrameRate);
  return numbers_of(runs, [&](const SleepRun& run) {
    double sum = 0.0;
    for (std::size_t k = begin; k < end; ++k) sum += run.looks[k].*part;
    return sum / static_cast<double>(end - begin);
  });
}

using Ways = std::array<std::vector<SleepRun>, 3>;  // without sleep, sleep by speed, freezing

// The first seed by time.
Table table_of(const Ways& runs, double cube) {
  Table table{"", {{"time_s", "s", "since the start"}, {"cube_s", "s", "when the cube comes in"}}};
  for (const std::string way : {"off", "sleeping", "freezing"}) {
    table.columns.push_back({way + "_awake", "-", "bodies awake"});
    table.columns.push_back(
        {way + "_chatters", "-", "bodies that chatter over the last half second"});
    table.columns.push_back(
        {way + "_pair_tests", "-", "pair tests in a step, mean of a tenth second"});
  }
  for (std::size_t k = kTenth; k <= runs[0][0].looks.size(); k += kTenth) {
    std::vector<double> cells;
    for (const std::vector<SleepRun>& seeds : runs) {
      const std::vector<Look>& looks = seeds[0].looks;
      double pair_tests = 0.0;
      for (std::size_t j = k - kTenth; j < k; ++j) pair_tests += looks[j].pair_tests / kTenth;
      cells.insert(cells.end(), {looks[k - 1].awake, looks[k - 1].chatters, pair_tests});
    }
    table.add(static_cast<double>(k) / kFrameRate, cube, cells);
  }
  return table;
}

Result measure_freezing(const Parameters& settings) {
  const std::array<PlayedTechnique, 3> ways = {
      {{"damped", {}}, {"damped", {"sleeping=on"}}, {"damped", {"sleeping=on", "freeze=on"}}}};
  Ways runs;
  for (std::size_t way = 0; way < ways.size(); ++way)
    for (int seed = 1; seed <= settings.count("seeds"); ++seed)
      runs[way].push_back(play(settings, static_cast<std::uint64_t>(seed), ways[way]));
  const auto& [off, sleeping, freezing] = runs;
  const auto mean = [&](const std::string& name, const std::vector<SleepRun>& seeds,
                        double Look::*part) {
    return mean_over_seeds(name, "-", before_hit(seeds, settings, part));
  };
  return {
      {table_of(runs, settings.number("settling"))},
      {mean("bodies awake before the hit, sleeping", sleeping, &Look::awake),
       mean("bodies awake before the hit, freezing", freezing, &Look::awake),
       mean("bodies that chatter before the hit, sleeping off", off, &Look::chatters),
       mean("bodies that chatter before the hit, freezing", freezing, &Look::chatters),
       ratio_of_sums("pair tests before the hit, freezing over none", "-",
                     before_hit(freezing, settings, &Look::pair_tests),
                     before_hit(off, settings, &Look::pair_tests)),
       mean_of("bodies awake after the hit at most, freezing", "-", freezing, &SleepRun::woken)}};
}

const Registered freezing_clump_figure{
    {.name = "freezing_clump",
     .parameters =
         Parameters{}
             .add_whole("seeds", 4, 2, 1000, "clumps; the first is drawn")
             .add_whole("per_edge", 5, 2, 8, "cubes along each edge of the grid at the start")
             .add_number("settling", 12.0, 4.0, 1000.0, "s", "before the cube comes in")
             .add_number("watched", 6.0, 2.0, 1000.0, "s", "after that")
             .add_number("speed", 15.0, 0.0, 100.0, "m/s", "of the cube"),
     .quick = {"seeds=2", "per_edge=3", "settling=5", "watched=2"},
     .experiment = measure_freezing}};

}  // namespace
}  // namespace tumble::chapters
