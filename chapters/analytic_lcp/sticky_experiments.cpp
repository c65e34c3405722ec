/// \file
/// \brief Dice that come to rest with and without sticky collisions (thesis 4.3).
#include "tumble/contact/tolerances.hpp"
#include "tumble/dynamics/flight.hpp"

#include "driver/csv.hpp"
#include "driver/experiment.hpp"

namespace tumble::chapters {
namespace {

constexpr int kDie = 1;            // its index: the ground comes first
constexpr double kLongest = 20.0;  // [s] by when every die rests
constexpr double kQuiet = 0.5;     // [s] a die that is slow for so long rests
constexpr double kSlow = 1e-3;     // [m/s]
constexpr double kEdge = 1.0;      // [m] of the die
constexpr int kFresh = 100;        // dice of a second measurement have the seeds after this one

// A die of 1 m that falls with a random orientation and a random spin, or flat.
World die(double height, double restitution, int seed, bool flat) {
  Random random(static_cast<std::uint64_t>(seed));
  Scene scene{.ground = SceneGround{0.5, 0.0}};
  SceneBox box{.name = "die", .restitution = restitution};
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
  Vec3 end_w = Vec3::Zero();
  std::vector<double> heights = {};  // [m] of the lowest corner after each step
};

Fall drop(World world, double threshold) {
  const auto technique = make_technique("analytic", {"sticky=" + full_text(threshold)});
  // It counts as off the ground above a thousandth of its edge for at least one frame.
  constexpr double off = 1e-3 * kEdge;
  Fall fall;
  double collisions = 0.0;
  double quiet = 0.0;
  bool landed = false;
  bool aloft = false;
  while (world.time() < kLongest && quiet < kQuiet) {
    const Vec3 before_w = world.states()[kDie].position_w;
    const StepReport report = finished(technique->step(world, kStep));
    collisions += static_cast<double>(report.events);
    const double height = height_of(world);
    fall.heights.push_back(height);
    landed = landed || report.events > 0;
    if (landed && height > off && !aloft) fall.bounces += 1.0;
    aloft = landed && height > off;
    if (landed) fall.travel += (world.states()[kDie].position_w - before_w).norm();
    const bool slow = landed && speed_of(world) < kSlow;
    const bool resting = slow && quiet > 0.0;  // it came to rest in an earlier step
    quiet = slow ? quiet + kStep : 0.0;
    if (resting) continue;
    fall.collisions = collisions;
  }
  fall.end_w = world.states()[kDie].position_w;
  return fall;
}

// Dice of all seeds.
// after: the seeds are those that follow this one
std::vector<Fall> drop_all(const Parameters& settings, double threshold, int after = 0) {
  std::vector<Fall> falls;
  for (int seed = after + 1; seed <= after + settings.count("seeds"); ++seed)
    falls.push_back(drop(
        die(settings.number("height"), settings.number("restitution"), seed, false), threshold));
  return falls;
}

// A number of all dice together over the same number of others.
Quantity ratio(const char* name, double Fall::*what, const std::vector<Fall>& these,
               const std::vector<Fall>& others) {
  return ratio_of_sums(name, "-", numbers_of(these, what), numbers_of(others, what));
}

Parameters of_dice() {
  return {number("height", 2.0, 0.1, 100.0, "m", "free height of the die"),
          number("restitution", 0.5, 0.1, 0.9, "-", "rebound speed over impact speed"),
          whole("seeds", 20, 2, 1000, "dice")};
}

Result measure_sticky(const Parameters& settings) {
  const double height = settings.number("height");
  const double restitution = settings.number("restitution");
  const int seeds = settings.count("seeds");
  const double usual = tolerance::sticky_speed;
  // From collisions that are hard to those that the technique takes for rest in any case.
  // The usual one is a choice: half and twice of it are written down beside it.
  std::vector<double> thresholds = {usual, 0.5 * usual, 2.0 * usual, tolerance::resting_speed};
  for (double t = 0.7; t > tolerance::resting_speed; t *= 0.5) thresholds.push_back(t);
  std::ranges::sort(thresholds);

  Table table{
      "",
      {{"threshold", "-", "collisions slower than this share of sqrt(g L) stick"},
       {"collisions", "-", "until rest, mean over the dice"},
       {"moved_m", "m", "how far a die rests from where it rests at the lowest threshold"}}};
  std::vector<std::vector<Fall>> falls;
  for (const double threshold : thresholds) {
    falls.push_back(drop_all(settings, threshold));
    double collisions = 0.0;
    double moved = 0.0;
    for (std::size_t k = 0; k < falls.back().size(); ++k) {
      const Fall& fall = falls.back()[k];
      collisions += fall.collisions;
      moved += (fall.end_w - falls.front()[k].end_w).norm();
    }
    table.add(threshold, collisions / seeds, moved / seeds);
  }

  // A flat drop has a closed form: the speed before impact k is v e^(k-1), and the first one below
  // the threshold is the last, if it is a collision at all.
  Table flat{"flat",
             {{"threshold", "-", "collisions slower than this share of sqrt(g L) stick"},
              {"collisions", "-", "until rest"},
              {"exact", "-", "in closed form"}}};
  for (const double threshold : thresholds) {
    const Fall fall = drop(die(height, restitution, 1, true), threshold);
    double exact = 0.0;
    double speed = std::sqrt(2.0 * height / kEdge);  // over sqrt(g L)
    for (; speed >= threshold && exact < 1000.0; speed *= restitution) exact += 1.0;
    if (speed > tolerance::resting_speed) exact += 1.0;  // it sticks; else it rests already
    flat.add(threshold, fall.collisions, exact);
  }
  const auto over_lowest = [&](const char* name, double Fall::*what, double threshold) {
    const auto place = std::ranges::find(thresholds, threshold);
    return ratio(name, what, falls[static_cast<std::size_t>(place - thresholds.begin())],
                 falls.front());
  };
  return {
      {table, flat},
      {over_lowest("collisions until rest with sticky collisions over those without",
                   &Fall::collisions, usual),
       ratio("collisions until rest with sticky collisions over those without, fresh dice",
             &Fall::collisions, drop_all(settings, usual, kFresh),
             drop_all(settings, tolerance::resting_speed, kFresh)),
       over_lowest("the same collisions, half the threshold", &Fall::collisions, 0.5 * usual),
       over_lowest("the same collisions, twice the threshold", &Fall::collisions, 2.0 * usual)}};
}

const Registered claim_4_3a_sticky_figure{{.name = "claim_4_3a_sticky",
                                           .parameters = of_dice(),
                                           .quick = {"seeds=3"},
                                           .experiment = measure_sticky}};

Result measure_all_sticky(const Parameters& settings) {
  constexpr double everything = 1e6;  // no collision is as fast as that
  const std::vector<Fall> some = drop_all(settings, tolerance::sticky_speed);
  const std::vector<Fall> all = drop_all(settings, everything);
  Table table{"",
              {{"seed", "-", "of the die"},
               {"bounces", "-", "times that it leaves the ground, slow collisions being sticky"},
               {"bounces_all", "-", "the same if every collision is"}}};
  for (std::size_t k = 0; k < some.size(); ++k) table.add(k + 1, some[k].bounces, all[k].bounces);
  Table path{"path",
             {{"time_s", "s", "time"},
              {"height_m", "m", "of the lowest corner of the first die"},
              {"height_all_m", "m", "the same if every collision is sticky"}}};
  const std::vector<double>& usual = some.front().heights;
  const std::vector<double>& dull = all.front().heights;
  const auto lowest = [](const std::vector<double>& heights, std::size_t k) {
    return k < heights.size() ? heights[k] : std::numeric_limits<double>::quiet_NaN();
  };
  for (std::size_t k = 0; k < std::max(usual.size(), dull.size()); ++k)
    path.add(static_cast<double>(k + 1) * kStep, lowest(usual, k), lowest(dull, k));
  return {{table, path},
          {ratio("bounces seen with every collision sticky over those seen without", &Fall::bounces,
                 all, some),
           ratio("way from the first contact on, every collision sticky, over that without",
                 &Fall::travel, all, some)}};
}

const Registered claim_4_3b_all_sticky_figure{{.name = "claim_4_3b_all_sticky",
                                               .parameters = of_dice(),
                                               .quick = {"seeds=3"},
                                               .experiment = measure_all_sticky}};

}  // namespace
}  // namespace tumble::chapters
