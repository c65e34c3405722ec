/// \file
/// \brief Dice that come to rest with and without sticky collisions (thesis 4.3).
#include "tumble/base/random.hpp"
#include "tumble/dynamics/flight.hpp"
#include "tumble/scenes/scene.hpp"

#include "analytic_lcp/joined_experiments.hpp"
#include "driver/common_numbers.hpp"
#include "driver/settings.hpp"
#include "driver/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tumble::chapters {
namespace {

constexpr int kDie = 1;            // its index: the ground comes first
constexpr double kLongest = 20.0;  // [s] by when every die rests
constexpr double kQuiet = 0.5;     // [s] a die that is slow for so long rests
constexpr double kSlow = 1e-3;     // [m/s]
constexpr double kEdge = 1.0;      // [m] of the die

// A die of 1 m that falls with a random orientation and a random spin, or flat.
World die(double height, double restitution, int seed, bool flat) {
  Random random(static_cast<std::uint64_t>(seed));
  Scene scene;
  scene.ground = SceneGround{0.5, 0.0};
  SceneBox box;
  box.name = "die";
  box.restitution = restitution;
  if (!flat) {
    box.orientation_wb = random.orientation();
    box.angular_velocity_w = random.in_cube(3.0);
    box.velocity_w = Vec3(random.uniform(-1.0, 1.0), 0.0, 0.0);
  }
  const double down = reach(make_box(Vec3::Zero(), box.orientation_wb, box.size), Vec3::UnitY());
  box.position_w = Vec3(0.0, height + down, 0.0);
  scene.boxes.push_back(box);
  return build_world(scene);
}

double height_of(const World& world) {
  return gap_between(world.bodies()[0], world.states()[0], world.bodies()[kDie],
                     world.states()[kDie])
      .distance;
}

double speed_of(const World& world) {
  const BodyProperties& body = world.bodies()[kDie];
  const BodyState& state = world.states()[kDie];
  return velocity(body, state).norm() + kEdge * angular_velocity(body, state).norm();
}

// One die, from the drop to rest.
struct Fall {
  double collisions = 0.0;  // until rest
  double work = 0.0;        // separations and integrations until rest
  double bounces = 0.0;     // times that it has left the ground
  double travel = 0.0;      // [m] of its centre, as the sum over steps from the first contact on
  double duration = 0.0;    // [s] until rest
  Vec3 end_w = Vec3::Zero();
  std::vector<std::vector<double>> path = {};  // time, height of the lowest corner
};

Fall drop(World world, double threshold) {
  const auto technique = make_technique("analytic", {"sticky=" + setting_text(threshold)});
  // It counts as off the ground above a thousandth of its edge for at least one frame.
  constexpr double off = 1e-3 * kEdge;
  Fall fall;
  double collisions = 0.0;
  double work = 0.0;
  double quiet = 0.0;
  bool landed = false;
  bool aloft = false;
  while (world.time() < kLongest && quiet < kQuiet) {
    const Vec3 before_w = world.states()[kDie].position_w;
    const StepReport report = technique->step(world, kStep);
    collisions += static_cast<double>(report.events);
    work += static_cast<double>(report.pair_tests + report.integrations);
    const double height = height_of(world);
    fall.path.push_back({world.time(), height});
    landed = landed || report.events > 0;
    if (landed && height > off && !aloft) fall.bounces += 1.0;
    aloft = landed && height > off;
    if (landed) fall.travel += (world.states()[kDie].position_w - before_w).norm();
    const bool slow = landed && speed_of(world) < kSlow;
    const bool resting = slow && quiet > 0.0;  // it came to rest in an earlier step
    quiet = slow ? quiet + kStep : 0.0;
    if (resting) continue;
    fall.collisions = collisions;
    fall.work = work;
    fall.duration = world.time();
  }
  fall.end_w = world.states()[kDie].position_w;
  return fall;
}

}  // namespace

Result measure_sticky(const Parameters& settings) {
  const double height = settings.number("height");
  const double restitution = settings.number("restitution");
  const int seeds = settings.count("seeds");
  const double usual = tolerance::sticky_speed;
  // From collisions that are hard to those that the technique takes for rest in any case.
  // The usual one is a choice: half and twice of it are written down beside it.
  std::vector<double> thresholds = {usual, 0.5 * usual, 2.0 * usual, tolerance::resting_speed};
  for (double t = 0.7; t > tolerance::resting_speed; t *= 0.5) thresholds.push_back(t);
  std::sort(thresholds.begin(), thresholds.end());

  Table table{
      "",
      {{"threshold", "-", "collisions slower than this share of sqrt(g L) stick"},
       {"collisions", "-", "until rest, mean over the dice"},
       {"work", "-", "separations and integrations until rest, mean over the dice"},
       {"moved_m", "m", "how far a die rests from where it rests at the lowest threshold"}}};
  std::vector<std::vector<Fall>> falls;
  for (const double threshold : thresholds) {
    falls.emplace_back();
    for (int seed = 1; seed <= seeds; ++seed)
      falls.back().push_back(drop(die(height, restitution, seed, false), threshold));
    double collisions = 0.0;
    double work = 0.0;
    double moved = 0.0;
    for (std::size_t k = 0; k < falls.back().size(); ++k) {
      const Fall& fall = falls.back()[k];
      collisions += fall.collisions;
      work += fall.work;
      moved += (fall.end_w - falls.front()[k].end_w).norm();
    }
    table.rows.push_back({threshold, collisions / seeds, work / seeds, moved / seeds});
  }

  const auto ratio = [&](double Fall::*what, double threshold) {
    const auto place = std::find(thresholds.begin(), thresholds.end(), threshold);
    std::vector<double> with;
    std::vector<double> without;
    for (const Fall& fall : falls[static_cast<std::size_t>(place - thresholds.begin())])
      with.push_back(fall.*what);
    for (const Fall& fall : falls.front()) without.push_back(fall.*what);
    return [with, without](int left_out) {
      return sum_without(with, left_out) / sum_without(without, left_out);
    };
  };

  // A flat drop has a closed form: the speed before impact k is v e^(k-1), and the first one below
  // the threshold is the last, if it is a collision at all.
  Table flat{"flat",
             {{"threshold", "-", "collisions slower than this share of sqrt(g L) stick"},
              {"collisions", "-", "until rest"},
              {"exact", "-", "in closed form"}}};
  double wrong = 0.0;
  for (const double threshold : thresholds) {
    const Fall fall = drop(die(height, restitution, 1, true), threshold);
    double exact = 0.0;
    double speed = std::sqrt(2.0 * height / kEdge);  // over sqrt(g L)
    for (; speed >= threshold && exact < 1000.0; speed *= restitution) exact += 1.0;
    if (speed > tolerance::resting_speed) exact += 1.0;  // it sticks; else it rests already
    wrong += fall.collisions == exact ? 0.0 : 1.0;
    flat.rows.push_back({threshold, fall.collisions, exact});
  }
  return {{table, flat},
          {over_seeds("collisions until rest with sticky collisions over those without", "-", seeds,
                      ratio(&Fall::collisions, usual)),
           over_seeds("separations and integrations until rest, over those without", "-", seeds,
                      ratio(&Fall::work, usual)),
           {"thresholds at which a flat drop misses its closed form", "-", wrong},
           over_seeds("the same collisions, half the threshold", "-", seeds,
                      ratio(&Fall::collisions, 0.5 * usual)),
           over_seeds("the same collisions, twice the threshold", "-", seeds,
                      ratio(&Fall::collisions, 2.0 * usual))}};
}

Result measure_all_sticky(const Parameters& settings) {
  const double height = settings.number("height");
  const double restitution = settings.number("restitution");
  const int seeds = settings.count("seeds");
  constexpr double everything = 1e6;  // no collision is as fast as that
  Table table{"",
              {{"seed", "-", "of the die"},
               {"bounces", "-", "times that it leaves the ground, slow collisions being sticky"},
               {"bounces_all", "-", "the same if every collision is"},
               {"travel_m", "m", "way of its centre from the first contact on"},
               {"travel_all_m", "m", "the same if every collision is sticky"}}};
  Table path{"path",
             {{"time_s", "s", "time"},
              {"height_m", "m", "of the lowest corner of the first die"},
              {"height_all_m", "m", "the same if every collision is sticky"}}};
  std::vector<double> some, all, way, way_all;
  for (int seed = 1; seed <= seeds; ++seed) {
    const Fall usual = drop(die(height, restitution, seed, false), tolerance::sticky_speed);
    const Fall dull = drop(die(height, restitution, seed, false), everything);
    some.push_back(usual.bounces);
    all.push_back(dull.bounces);
    way.push_back(usual.travel);
    way_all.push_back(dull.travel);
    table.rows.push_back(
        {static_cast<double>(seed), usual.bounces, dull.bounces, usual.travel, dull.travel});
    if (seed > 1) continue;
    const double none = std::numeric_limits<double>::quiet_NaN();
    for (std::size_t k = 0; k < std::max(usual.path.size(), dull.path.size()); ++k) {
      const auto lowest = [k, none](const Fall& fall) {
        return k < fall.path.size() ? fall.path[k][1] : none;
      };
      path.rows.push_back({static_cast<double>(k + 1) * kStep, lowest(usual), lowest(dull)});
    }
  }
  const auto ratio = [](const std::vector<double>& top, const std::vector<double>& bottom) {
    return [&top, &bottom](int left_out) {
      return sum_without(top, left_out) / sum_without(bottom, left_out);
    };
  };
  return {{table, path},
          {over_seeds("bounces seen with every collision sticky over those seen without", "-",
                      seeds, ratio(all, some)),
           over_seeds("way from the first contact on, every collision sticky, over that without",
                      "-", seeds, ratio(way_all, way))}};
}

}  // namespace tumble::chapters
