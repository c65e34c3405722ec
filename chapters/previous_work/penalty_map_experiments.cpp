/// \file
/// \brief Stiffness and step that penalty forces want, scene by scene (thesis 2.5.1).
///
/// A cube, ten of them in a stack, and a cube that carries a hundred times its mass run on springs of a given
/// stiffness, critically damped, each step of the technique being one substep.
#include "tumble/previous_work/penalty.hpp"

#include "driver/experiment.hpp"

namespace tumble::chapters {
namespace {

constexpr double kAway = 0.05;  // [m] a box of 1 m that is further from its place does not stand
constexpr double kRestless = 0.01;  // [m/s] and one that is faster does not rest
constexpr double kGain =
    0.05;  // [-] energy above the start over the sum of m g L, as in a run's check

constexpr std::size_t kScenes = 3;
constexpr std::array<const char*, kScenes> kWords = {"one", "ten", "loaded"};

// What became of a run. The picture has a mark for each.
enum class Outcome : std::uint8_t { right, sinks, restless, gains };

World world_of(std::size_t scene) {
  const std::array<std::vector<std::string>, kScenes> settings = {
      {{"count=1"}, {"count=10"}, {"count=2", "top_mass=100"}}};
  return build_world(make_scene("stack", settings[scene]));
}

// Energy that a run may gain [J].
double allowed(const World& world) { return kGain * lifting_energy(world); }

Outcome outcome(std::size_t scene, double stiffness, double rate, double duration) {
  World world = world_of(scene);
  const World start = world;
  const double most = energy_of(world).total() + allowed(world);
  Penalty technique({.stiffness = stiffness, .damping = 1.0, .substeps = 1, .unstable = true});
  const auto steps = static_cast<int>(std::lround(duration * rate));
  for (int k = 0; k < steps; ++k) {
    finished(technique.step(world, 1.0 / rate));
    if (!(energy_of(world).total() <= most)) return Outcome::gains;  // true for NaN
  }
  if (!(farthest_moved(start.states(), world.states()) <= kAway)) return Outcome::sinks;
  const double fastest =
      largest_of(world.bodies(), world.states(),
                 [](const BodyProperties& b, const BodyState& s) { return velocity(b, s).norm(); });
  return fastest <= kRestless ? Outcome::right : Outcome::restless;
}

Result measure_map(const Parameters& settings) {
  Result result;
  Table table{"",
              {{"stiffness_N_m", "N/m", "of the springs under a box"},
               {"rate_1_s", "1/s", "steps a second"},
               {"limit_1_s", "1/s", "steps a second above which one box is stable"}}};
  for (const char* words : kWords)
    table.columns.push_back(
        {words, "-", "0: right, 1: sinks in, 2: does not rest, 3: gains energy"});
  int somewhere = 0, not_everywhere = 0;
  std::array<int, kScenes> right{};
  const double top = settings.number("finest");
  for (int decade = 4; decade <= 12; ++decade) {  // halves of one
    const double stiffness = elementary::pow(10.0, 0.5 * decade);
    const double limit =
        1.0 / stable_step(PenaltyScheme::semi_implicit, {std::sqrt(stiffness), 1.0});
    for (double rate = 60.0; rate <= top; rate *= 2.0) {
      std::array<double, kScenes> row{};
      int here = 0;
      for (std::size_t scene = 0; scene < kScenes; ++scene) {
        const Outcome came = outcome(scene, stiffness, rate, settings.number("duration"));
        row[scene] = static_cast<double>(came);
        if (came != Outcome::right) continue;
        ++here;
        ++right[scene];
      }
      somewhere += here > 0 ? 1 : 0;
      not_everywhere += here > 0 && here < static_cast<int>(kScenes) ? 1 : 0;
      table.add(stiffness, rate, limit, row);
    }
  }
  result.tables.push_back(table);
  result.add("share of the settings right for one of the scenes that are wrong for another", "-",
             static_cast<double>(not_everywhere) / somewhere);
  result.add("settings right for one box", "-", right[0]);
  result.add("settings right for ten boxes", "-", right[1]);
  result.add("settings right under a hundred times the mass", "-", right[2]);
  return result;
}

const Registered penalty_map_figure{
    {.name = "claim_2_5_1a_penalty_map",
     .parameters = {number("duration", 2.0, 0.1, 100.0, "s", "simulated time"),
                    number("finest", 3840.0, 60.0, 1e6, "1/s",
                           "most steps a second; from 60 on, doubled each time")},
     .quick = {"finest=480"},
     .experiment = measure_map}};

}  // namespace
}  // namespace tumble::chapters
