/// \file
/// \brief Boxes that should rest, and one that should tip, under each technique.
#include "choosing/experiments.hpp"

namespace tumble::chapters {
namespace {

constexpr double kWatched = 0.5;    // [s] at the end of a run
constexpr double kFell = 0.5;       // [m] half an edge
constexpr double kFalls = 1.0;      // [m/s] what rests is slower
constexpr double kTrembles = 1e-3;  // [m/s] a box that lies is faster
constexpr double kTipped = 15.0;    // [deg] off the slope's normal

constexpr std::array<const char*, 3> kMassNames = {"10", "100", "1000"};

bool tips(const PlayedTechnique& played, double angle) {
  const Scene scene =
      make_scene("slope", {setting("angle", angle), "width=0.5", "height=1", "friction=2"});
  double most = 0.0;
  const auto look = [&](const World& world, const Metrics&) {
    const Vec3 up = world.states()[1].orientation_wb * Vec3::UnitY();
    const Vec3 normal = world.states()[0].orientation_wb * Vec3::UnitY();
    most = std::max(most, std::acos(std::clamp(up.dot(normal), -1.0, 1.0)));
  };
  run_compared(scene, played, kStep, 2.0, look);
  return most * 180.0 / std::numbers::pi > kTipped;
}

// The worst of several starts.
PileRun worst_of(const std::vector<PileRun>& runs) {
  PileRun worst;
  bool still = worst.stands = true;
  worst.speed = worst.chatter = 0.0;
  for (const PileRun& run : runs) {
    worst.stands = worst.stands && run.stands;
    worst.overlap = std::max(worst.overlap, run.overlap);
    worst.speed = std::max(worst.speed, run.speed);
    still = still && !std::isnan(run.chatter);
    if (still) worst.chatter = std::max(worst.chatter, run.chatter);
  }
  if (!still) worst.chatter = kNoNumber;
  if (!worst.stands) worst.speed = worst.chatter = worst.overlap = kNoNumber;
  return worst;
}

PileRun stack_of(const Parameters& p, int count, const std::string& top,
                 const PlayedTechnique& played) {
  std::vector<PileRun> runs;
  for (int seed = 1; seed <= p.count("seeds"); ++seed) {
    const Scene scene = make_scene("stack",
                                   {"count=" + std::to_string(count), "top_mass=" + top,
                                    setting("scatter", p.number("scatter"))},
                                   static_cast<std::uint64_t>(seed));
    runs.push_back(pile_run(scene, played, p.number("duration")));
    if (!runs.back().stands) break;  // the worst there is
  }
  return worst_of(runs);
}

}  // namespace

PileRun pile_run(const Scene& scene, const PlayedTechnique& played, double duration) {
  PileRun run;
  double speed = 0.0, moved = 0.0;
  const auto look = [&](const World& world, const Metrics& metrics) {
    if (world.time() > duration - kWatched) speed = std::max(speed, metrics.fastest);
    const std::size_t ground = world.states().size() - scene.boxes.size();
    for (std::size_t k = 0; k < scene.boxes.size(); ++k)
      moved = std::max(moved,
                       (world.states()[ground + k].position_w - scene.boxes[k].position_w).norm());
  };
  const RunResult result =
      run_compared(scene, played, kStep, duration, look, [&] { return moved >= kFell; });
  run.overlap = result.worst_metrics.deepest_overlap;
  run.stands = result.end == RunEnd::complete && moved < kFell && speed < kFalls;
  if (!run.stands) return run;
  run.speed = speed;
  if (result.last.chatter.bodies > 0) run.chatter = result.last.chatter.amplitude;
  return run;
}

bool tips_at_limit(const PlayedTechnique& played, double within) {
  return tips(played, kTippingSlope + within) && !tips(played, kTippingSlope - within);
}

namespace {

// Residual speed, overlap, chatter, mass ratios and the angle of tipping of each technique; a pile that
// fell has none.
Result measure_rest_and_tip(const Parameters& settings) {
  Table table{"",
              {{"technique", "-", "its row, from 0"},
               {"stack_m_s", "m/s", "fastest of a stack in the last half second; empty: it falls"},
               {"overlap_m", "m", "deepest in the stack"},
               {"chatter_m", "m", "amplitude in the stack at the end; empty: not at rest"},
               {"mass10_m", "m", "deepest overlap under a top of ten times the mass"},
               {"mass100_m", "m", "of a hundred times"},
               {"mass1000_m", "m", "of a thousand times"}}};
  Result result;
  int tipping = 0;
  const std::vector<PlayedTechnique> techniques = compared_techniques();
  for (std::size_t t = 0; t < techniques.size(); ++t) {
    const PlayedTechnique& played = techniques[t];
    const auto add = [&](const std::string& what, const std::string& unit, double value) {
      add_number(result.quantities, number_name(played.name, what), unit, 1e3 * value);
    };
    const PileRun box = pile_run(make_scene("bouncing_box", {"height=0.01", "restitution=0"}),
                                 played, settings.number("duration"));
    add("speed of a box at rest", "mm/s", box.speed > kTrembles ? box.speed : kNoNumber);
    const PileRun stack = stack_of(settings, settings.count("boxes"), "1", played);
    add("speed in a stack at rest", "mm/s", stack.speed);
    add("overlap in a stack", "mm", stack.overlap);
    add("chatter in a stack", "mm", stack.chatter);
    std::array<double, kMassNames.size()> loaded{};
    for (std::size_t m = 0; m < kMassNames.size(); ++m)
      loaded[m] = stack_of(settings, 2, kMassNames[m], played).overlap;
    add("overlap under a load of 1000", "mm", loaded.back());
    if (tips_at_limit(played, settings.number("within"))) ++tipping;
    table.add(t, stack.speed, stack.overlap, stack.chatter, loaded);
  }
  result.add("slope from which a box tips, closed form", "deg", kTippingSlope);
  result.add("techniques under which a box tips there", "-", tipping);
  result.tables = {table};
  return result;
}

const Registered choose_rest_figure{
    {.name = "choose_rest",
     .parameters = {whole("boxes", 10, 1, 20, "of the stack"),
                    whole("seeds", 3, 1, 100, "starts of each pile, of which the worst counts"),
                    number("scatter", 0.01, 0.0, 0.1, "m",
                           "how far boxes of piles are off their places"),
                    number("duration", 2.0, 0.5, 60.0, "s", "simulated time of each pile"),
                    number("within", 0.1, 0.001, 20.0, "deg",
                           "of the slope from which a box tips")},
     .quick = {"boxes=2", "seeds=1", "duration=0.6", "within=10"},
     .experiment = measure_rest_and_tip}};

}  // namespace
}  // namespace tumble::chapters
