/// \file
/// \brief A clump that falls asleep although it chatters, and is woken by a cube (thesis 4.5, 6.3.1).
#include "tumble/filtering/chatter_detector.hpp"
#include "tumble/record/chatter.hpp"

#include "driver/statistics.hpp"
#include "filtering/detector_experiments.hpp"
#include "filtering/settled_run.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace tumble::chapters {
namespace {

constexpr double kMoved = 0.01;    // [-] of an edge: who got as far was hit
constexpr int kFrameRate = 60;     // [1/s]
constexpr std::size_t kTenth = 6;  // [frame] a tenth of a second

// What a step was like.
struct Look {
  double awake = 0.0;     // bodies
  double chatters = 0.0;  // bodies that chatter, over the last half second
  double pair_tests = 0.0;
  double impulses = 0.0;
};

struct Story {
  std::vector<Look> looks;    // by step
  double largest_step = 0.0;  // [m] way of a corner in a frame in which its body falls asleep
  double first_asleep = 0.0;  // [s] when half of the bodies sleep
  double moved = 0.0;         // bodies that the hit moved by kMoved
  double woken = 0.0;         // bodies awake, at most, within a second after the hit
};

// The clump, and a cube that comes in from the side at the end.
Scene with_late_cube(const Parameters& settings, std::uint64_t seed) {
  Scene scene =
      scene_with("fig6_7", {"per_edge=" + std::to_string(settings.count("per_edge"))}, seed);
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

Corners corners_now(const World& world, std::size_t k) {
  return corners_of(box_of(world.bodies()[k], world.states()[k]));
}

Story tell(const Parameters& settings, std::uint64_t seed, const PlayedTechnique& technique) {
  PlayedScene played(with_late_cube(settings, seed), technique, seed);
  const double settling = settings.number("settling");
  ChatterMeter meter;
  std::vector<char> touches;
  std::vector<Corners> before;
  std::vector<char> slept;
  Story story;
  World at_hit = played.world();
  const auto note = [&] {
    before.clear();
    slept.clear();
    for (std::size_t k = 0; k < played.world().states().size(); ++k) {
      before.push_back(played.world().bodies()[k].movable() ? corners_now(played.world(), k)
                                                            : Corners());
      slept.push_back(played.world().sleep_states()[k].asleep ? 1 : 0);
    }
  };
  note();
  played.advance(settling + settings.number("watched"), [&](const StepReport& report) {
    const World& world = played.world();
    mark_contacts(world, played.technique().contacts(), touches);
    Look look;
    double asleep = 0.0;
    double movable = 0.0;
    for (std::size_t k = 0; k < world.states().size(); ++k) {
      if (!world.bodies()[k].movable()) continue;
      movable += 1.0;
      look.awake += world.sleep_states()[k].asleep ? 0.0 : 1.0;
      if (!world.sleep_states()[k].asleep) continue;
      asleep += 1.0;
      touches[k] = 1;
      if (k < slept.size() && slept[k] == 0)
        story.largest_step =
            std::max(story.largest_step, largest_way(before[k], corners_now(world, k)));
    }
    if (story.first_asleep == 0.0 && asleep >= 0.5 * movable) story.first_asleep = world.time();
    meter.add(world, touches);
    look.chatters = (story.looks.size() + 1) % kTenth == 0 || story.looks.empty()
                        ? chattering(meter, world)
                        : story.looks.back().chatters;
    look.pair_tests = static_cast<double>(report.pair_tests);
    look.impulses = static_cast<double>(report.impulses);
    story.looks.push_back(look);
    if (world.time() < settling - 0.5 * kStep) at_hit = world;
    if (world.time() > settling && world.time() < settling + 1.5)
      story.woken = std::max(story.woken, look.awake);
    note();
  });
  for (std::size_t k = 0; k < at_hit.states().size(); ++k)
    if (at_hit.bodies()[k].movable() && largest_way(corners_now(at_hit, k), before[k]) >=
                                            kMoved * at_hit.bodies()[k].size.minCoeff())
      story.moved += 1.0;
  return story;
}

// The mean of a part of the looks over the last seconds before the cube comes in.
double before_hit(const Story& story, const Parameters& settings, double Look::*part) {
  const auto end =
      static_cast<std::size_t>(std::lround(settings.number("settling") * kFrameRate)) - 1;
  const std::size_t begin = end - 2 * static_cast<std::size_t>(kFrameRate);
  double sum = 0.0;
  for (std::size_t k = begin; k < end; ++k) sum += story.looks[k].*part;
  return sum / static_cast<double>(end - begin);
}

}  // namespace

Result measure_freezing(const Parameters& settings) {
  const std::array<PlayedTechnique, 3> ways = {
      {{"damped", {}}, {"damped", {"sleeping=on"}}, {"damped", {"sleeping=on", "freeze=on"}}}};
  const int seeds = settings.count("seeds");
  std::array<std::vector<Story>, ways.size()> stories;
  for (std::size_t way = 0; way < ways.size(); ++way)
    for (int seed = 1; seed <= seeds; ++seed)
      stories[way].push_back(tell(settings, static_cast<std::uint64_t>(seed), ways[way]));

  Result result;
  Table table{"", {{"time_s", "s", "since the start"}, {"cube_s", "s", "when the cube comes in"}}};
  for (const std::string way : {"off", "sleeping", "freezing"}) {
    table.columns.push_back({way + "_awake", "-", "bodies awake"});
    table.columns.push_back(
        {way + "_chatters", "-", "bodies that chatter over the last half second"});
    table.columns.push_back(
        {way + "_pair_tests", "-", "pair tests in a step, mean of a tenth second"});
    table.columns.push_back({way + "_impulses", "-", "impulses in a step, mean of a tenth second"});
  }
  for (std::size_t k = kTenth; k <= stories[0][0].looks.size(); k += kTenth) {
    table.rows.push_back({static_cast<double>(k) / kFrameRate, settings.number("settling")});
    for (const auto& way : stories) {
      Look mean;
      for (std::size_t j = k - kTenth; j < k; ++j) {
        mean.pair_tests += way[0].looks[j].pair_tests / kTenth;
        mean.impulses += way[0].looks[j].impulses / kTenth;
      }
      const Look& now = way[0].looks[k - 1];
      for (const double value : {now.awake, now.chatters, mean.pair_tests, mean.impulses})
        table.rows.back().push_back(value);
    }
  }
  result.tables = {table};

  const auto ratio = [&](const std::string& name, std::size_t over, std::size_t under,
                         double Look::*part) {
    return over_seeds(name, "-", seeds, [&](int left_out) {
      std::array<double, 2> sums{};
      for (int s = 0; s < seeds; ++s) {
        if (s == left_out) continue;
        sums[0] += before_hit(stories[over][static_cast<std::size_t>(s)], settings, part);
        sums[1] += before_hit(stories[under][static_cast<std::size_t>(s)], settings, part);
      }
      return sums[1] > 0.0 ? sums[0] / sums[1] : 0.0;
    });
  };
  const auto mean = [&](const std::string& name, const std::string& unit, std::size_t way,
                        const std::function<double(const Story&)>& part) {
    std::vector<double> values;
    for (const Story& story : stories[way]) values.push_back(part(story));
    return mean_over_seeds(name, unit, values);
  };
  const auto before = [&](double Look::*part) {
    return [&settings, part](const Story& story) { return before_hit(story, settings, part); };
  };
  std::vector<Quantity>& out = result.quantities;
  out.push_back(mean("bodies awake before the hit, sleeping", "-", 1, before(&Look::awake)));
  out.push_back(mean("bodies awake before the hit, freezing", "-", 2, before(&Look::awake)));
  out.push_back(
      mean("bodies that chatter before the hit, nobody sleeps", "-", 0, before(&Look::chatters)));
  out.push_back(
      mean("bodies that chatter before the hit, freezing", "-", 2, before(&Look::chatters)));
  out.push_back(ratio("pair tests before the hit, freezing over none", 2, 0, &Look::pair_tests));
  out.push_back(ratio("impulses before the hit, freezing over none", 2, 0, &Look::impulses));
  out.push_back(mean("time until half of the bodies are frozen", "s", 2,
                     [](const Story& story) { return story.first_asleep; }));
  double step = 0.0;
  for (const Story& story : stories[2]) step = std::max(step, story.largest_step);
  out.push_back({"largest way of a corner in the frame in which its body is frozen", "m", step});
  out.push_back(mean("bodies awake after the hit at most, freezing", "-", 2,
                     [](const Story& story) { return story.woken; }));
  out.push_back(mean("bodies that the hit moves, freezing", "-", 2,
                     [](const Story& story) { return story.moved; }));
  out.push_back(mean("bodies that the hit moves, nobody sleeps", "-", 0,
                     [](const Story& story) { return story.moved; }));
  return result;
}

}  // namespace tumble::chapters
