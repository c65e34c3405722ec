/// \file
/// \brief The cost of exact impact times against time stepping at equal error (thesis 3.3.1).
#include "driver/csv.hpp"
#include "driver/experiment.hpp"

namespace tumble::chapters {
namespace {

constexpr double kLook = 1.0 / 15;         // [s] between two looks at the error
constexpr double kSpacing = 3.0;           // [m] between the cubes: they never meet
constexpr int kMany = 10;                  // cubes of the verdict
constexpr double kGoldenRatio = 0.618034;  // heights that repeat nothing

// Different heights, so that no two cubes land at once.
double drop_of(int cube) {
  const double turn = kGoldenRatio * (cube + 1);
  return 0.5 + 1.5 * (turn - std::floor(turn));
}

World cubes_in_a_row(int cubes, double restitution) {
  Scene scene{.ground = SceneGround{0.0, 0.0}};
  for (int k = 0; k < cubes; ++k) {
    scene.boxes.push_back({.name = "cube" + std::to_string(k + 1),
                           .position_w = Vec3(kSpacing * k, drop_of(k) + 0.5, 0.0),
                           .friction = 0.0,
                           .restitution = restitution});
  }
  return build_world(scene);
}

// Height of a bouncing cube's lower face at a time: flights of t1, 2 e t1, 2 e² t1, and so on.
double exact_height(double drop, double restitution, double time) {
  double since = time;
  double flight = std::sqrt(2.0 * drop / kGravity);
  if (since < flight) return drop - 0.5 * kGravity * since * since;
  since -= flight;
  double speed = restitution * kGravity * flight;
  constexpr double shortest = 1e-12;  // [s] what bounces shorter than this rests
  while (2.0 * speed / kGravity > shortest) {
    flight = 2.0 * speed / kGravity;
    if (since < flight) return since * (speed - 0.5 * kGravity * since);
    since -= flight;
    speed *= restitution;
  }
  return 0.0;
}

struct Cost {
  double work = 0.0;   // separations and integrations
  double error = 0.0;  // [m] largest over cubes and looks
};

Cost run(const std::string& name, int cubes, double step, const Parameters& settings) {
  const double restitution = settings.number("restitution");
  World world = cubes_in_a_row(cubes, restitution);
  const auto technique = make_technique(name, {});
  const auto looks = static_cast<int>(std::lround(settings.number("duration") / kLook));
  const auto steps_a_look = static_cast<int>(std::lround(kLook / step));
  Cost cost;
  for (int look = 0; look < looks; ++look) {
    for (int k = 0; k < steps_a_look; ++k) {
      const StepReport report = finished(technique->step(world, step));
      cost.work += static_cast<double>(report.pair_tests + report.integrations);
    }
    for (int k = 0; k < cubes; ++k) {
      const double height = world.states()[static_cast<std::size_t>(k + 1)].position_w.y() - 0.5;
      const double exact = exact_height(drop_of(k), restitution, world.time());
      cost.error = std::max(cost.error, std::abs(height - exact));
    }
  }
  return cost;
}

// The least work among the runs that are close enough, from long steps to short ones.
Cost cheapest(const std::string& name, int cubes, double longest, const Parameters& settings,
              std::vector<Cost>& all) {
  Cost best;
  for (double step = longest; step > 0.99 * settings.number("finest"); step *= 0.5) {
    const Cost cost = run(name, cubes, step, settings);
    all.push_back(cost);
    if (cost.error > settings.number("accepted")) continue;
    if (!(best.work > 0.0) || cost.work < best.work) best = cost;
    if (cost.work > best.work) break;  // shorter steps only cost more
  }
  if (!(best.work > 0.0))
    throw std::runtime_error(name + " never comes as close as " +
                             full_text(settings.number("accepted")) + " m; take a smaller finest");
  return best;
}

// --- piles: second measurements of claims 3.3.1d and 3.3.1e ---------------------------------------

constexpr int kPileCubes = 5;
constexpr int kCountedSteps = 120;  // whose work is counted, 2 s, of 3 by default

// Cubes that fall on one another from a column of random places and orientations.
World random_pile(int seed) {
  Random random(static_cast<std::uint64_t>(seed));
  Scene scene{.ground = SceneGround{0.5, 0.0}};
  for (int k = 0; k < kPileCubes; ++k) {
    SceneBox box{.name = "cube" + std::to_string(k + 1)};
    const double aside = random.uniform(-0.4, 0.4);
    box.position_w = Vec3(aside, 1.2 + 1.8 * k, 0.0);
    box.orientation_wb = random.orientation();
    box.friction = 0.5;
    scene.boxes.push_back(box);
  }
  return build_world(scene);
}

struct Pile {
  double work = 0.0;  // separations, integrations, pivots and sweeps
  bool done = true;   // every step ended as done
};

Pile fall_in_pile(const std::string& name, int seed, int steps) {
  World world = random_pile(seed);
  const auto technique = make_technique(name, {});
  Pile pile;
  for (int k = 0; k < steps; ++k) {
    const StepReport report = technique->step(world, kStep);
    pile.done = pile.done && report.status == StepStatus::done;
    if (k < kCountedSteps)
      pile.work += static_cast<double>(report.pair_tests + report.integrations + report.pivots +
                                       report.iterations);
  }
  return pile;
}

void add_piles(int seeds, int steps, Result& result) {
  std::vector<double> exact;
  std::vector<double> stepping;
  std::int64_t through = 0;
  for (int seed = 1; seed <= seeds; ++seed) {
    const Pile joined = fall_in_pile("analytic", seed, steps);
    exact.push_back(joined.work);
    through += joined.done ? 1 : 0;
    stepping.push_back(fall_in_pile("time_stepping", seed, std::min(steps, kCountedSteps)).work);
  }
  result.add(
      ratio_of_sums("separations, integrations, pivots and sweeps with exact impact times "
                    "over those of time stepping, random piles of five cubes",
                    "-", exact, stepping));
  result.add(
      share_of_trials("share of random piles of five cubes that the joined simulator runs "
                      "through for three seconds",
                      through, seeds));
}

Result measure_exact_times(const Parameters& settings) {
  Table table{"",
              {{"exact", "-", "1: exact impact times, 0: time stepping"},
               {"work", "-", "separations and integrations"},
               {"error_m", "m", "largest error of a height"}}};
  Table growth{"cubes",
               {{"cubes", "-", "that bounce side by side"},
                {"ratio", "-", "of exact impact times' work to time stepping's, at equal error"}}};
  double verdict = 0.0;
  std::vector<int> numbers;
  for (int cubes = 1; cubes <= settings.count("cubes"); cubes *= 2) numbers.push_back(cubes);
  numbers.push_back(kMany);
  std::ranges::sort(numbers);
  for (const int cubes : numbers) {
    std::vector<Cost> exact, stepping;
    const double ratio = cheapest("analytic", cubes, kLook, settings, exact).work /
                         cheapest("time_stepping", cubes, kStep, settings, stepping).work;
    growth.add(cubes, ratio);
    if (cubes != kMany) continue;
    verdict = ratio;
    for (const Cost& c : exact) table.add(1.0, c.work, c.error);
    for (const Cost& c : stepping) table.add(0.0, c.work, c.error);
  }
  Result result{
      {table, growth},
      {{"separations and integrations with exact impact times over those of time stepping, at "
        "equal error",
        "-", verdict},
       {"the same ratio for one cube", "-", growth.rows.front().back()},
       {"the same ratio for the most cubes", "-", growth.rows.back().back()}}};
  add_piles(settings.count("piles"), settings.count("pile_steps"), result);
  return result;
}

const Registered claim_3_3_1e_exact_times_figure{
    {.name = "claim_3_3_1e_exact_times",
     .parameters = {whole("cubes", 64, 1, 1000,
                          "the largest number of cubes, doubled from one up to there"),
                    number("duration", 2.0, 0.2, 60.0, "s", "length of each run"),
                    number("restitution", 0.5, 0.0, 0.9, "-", "rebound speed over impact speed"),
                    number("accepted", 0.01, 1e-6, 1.0, "m",
                           "largest error of a height; the edge is 1 m"),
                    number("finest", 1e-5, 1e-7, 0.01, "s", "shortest step that is tried"),
                    whole("piles", 20, 2, 1000, "random piles of five cubes"),
                    whole("pile_steps", 180, 1, 100000, "of 1/60 s, that they fall")},
     .quick = {"cubes=2", "piles=2", "pile_steps=30"},
     .experiment = measure_exact_times}};

}  // namespace
}  // namespace tumble::chapters
