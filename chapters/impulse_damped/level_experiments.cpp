/// \file
/// \brief Pyramids under shock propagation, with restitution that rises in the sweeps or not (2.5.2).
#include "driver/experiment.hpp"

namespace tumble::chapters {
namespace {

// How a pile moves: after each tenth of a second, and the spins that its first step leaves.
struct Moved {
  double drift = 0.0;               // [mm] of the box that has gone farthest, at the end
  double added = 0.0;               // [J] sum of all gains of total energy in a step
  std::vector<double> drifts = {};  // [mm] after each tenth of a second
  std::vector<double> spins =
      {};  // [rad/s] largest of each row after the first step, from the ground up
};

double farthest(const World& world, const std::vector<BodyState>& start) {
  double most = 0.0;
  for (std::size_t k = 0; k < start.size(); ++k)
    most = std::max(most, (world.states()[k].position_w - start[k].position_w).norm());
  return 1e3 * most;
}

void take_spins(const World& world, const std::vector<BodyState>& start,
                std::vector<double>& spins) {
  for (std::size_t k = 0; k < start.size(); ++k) {
    if (!world.bodies()[k].movable()) continue;
    const auto row = static_cast<std::size_t>(std::max(0.0, std::floor(start[k].position_w.y())));
    if (row >= spins.size()) spins.resize(row + 1, 0.0);
    const double spin = angular_velocity(world.bodies()[k], world.states()[k]).norm();
    spins[row] = std::max(spins[row], spin);
  }
}

Moved moved_of(const Scene& scene, const std::vector<std::string>& options, double duration) {
  PlayedScene played(scene, {"impulse", options});
  const std::vector<BodyState> start(played.world().states().begin(),
                                     played.world().states().end());
  double before = energy_of(played.world()).total();
  Moved out;
  int steps = 0;
  played.advance(duration, [&](const StepReport&) {
    const double now = energy_of(played.world()).total();
    out.added += std::max(0.0, now - before);
    before = now;
    if (++steps == 1) take_spins(played.world(), start, out.spins);
    if (steps % 6 == 0) out.drifts.push_back(farthest(played.world(), start));
  });
  out.drift = farthest(played.world(), start);
  return out;
}

Scene pyramid_of(int rows) { return scene_with("pyramid", {"rows=" + std::to_string(rows)}); }

std::vector<std::string> rule_of(const char* rule) {
  return {std::string("level_restitution=") + rule};
}

// A stack and a pyramid: what the default does with each, and what the rising restitution does.
void add_piles(const Parameters& settings, Result& result) {
  struct Pile {
    const char* name;
    Scene scene;
  };
  const std::vector<Pile> piles = {
      {"stack of ten", scene_with("stack", {"count=10"})},
      {"pyramid of fifteen rows", pyramid_of(settings.count("piles"))}};
  Table table{"piles",
              {{"time_s", "s", "since the start"},
               {"pyramid_mm", "mm", "farthest drift in a pyramid of fifteen rows, constant"},
               {"pyramid_rising_mm", "mm", "the same, rising"}}};
  std::vector<Moved> runs;
  for (const Pile& pile : piles) {
    for (const char* rule : {"constant", "rising"}) {
      runs.push_back(moved_of(pile.scene, rule_of(rule), settings.number("piles_duration")));
      result.add("drift of the " + std::string(pile.name) + ", " + rule, "mm", runs.back().drift);
    }
  }
  for (std::size_t k = 0; k < runs[2].drifts.size(); ++k)
    table.add(0.1 * static_cast<double>(k + 1), runs[2].drifts[k], runs[3].drifts[k]);
  Table spins{"spins",
              {{"row", "-", "of the pyramid, from the ground up"},
               {"constant", "rad/s", "largest spin that the first step leaves, constant"},
               {"rising", "rad/s", "the same, rising"}}};
  for (std::size_t row = 0; row < runs[2].spins.size(); ++row)
    spins.add(row + 1, runs[2].spins[row], runs[3].spins[row]);
  const auto most = [](const std::vector<double>& values) {
    return *std::max_element(values.begin(), values.end());
  };
  result.add("largest spin that the first step leaves in the pyramid, constant", "rad/s",
             most(runs[2].spins));
  result.add("largest spin that the first step leaves in the pyramid, rising", "rad/s",
             most(runs[3].spins));
  result.tables.push_back(table);
  result.tables.push_back(spins);
}

Result measure_levels(const Parameters& settings) {
  const int most = settings.count("rows");
  Table table{"",
              {{"rows", "-", "of the pyramid"},
               {"constant_mm", "mm", "drift, restitution of the sweeps constant, as printed"},
               {"shock_mm", "mm", "drift, rising in shock propagation"},
               {"rising_mm", "mm", "drift, rising in all sweeps"}}};
  Result result;
  for (int rows = 4; rows <= most; rows += 3) {
    std::array<double, 3> drift{};
    std::size_t k = 0;
    for (const char* rule : {"constant", "shock", "rising"}) {
      const Moved moved = moved_of(pyramid_of(rows), rule_of(rule), settings.number("duration"));
      drift[k++] = moved.drift;
      if (rows + 3 <= most) continue;
      result.add(std::string("drift of the highest pyramid, ") + rule, "mm", moved.drift);
      if (rule == std::string_view("constant"))
        result.add("energy added to it, constant", "J", moved.added);
    }
    table.add(rows, drift[0], drift[1], drift[2]);
  }
  result.tables = {table};
  add_piles(settings, result);
  return result;
}

const Registered impulse_levels_figure{
    {.name = "impulse_levels",
     .parameters =
         Parameters{}
             .add_whole("rows", 10, 4, 30, "of the highest pyramid; 4, 7, 10 and so on are run")
             .add_number("duration", 1.0, 0.1, 100.0, "s", "of each run")
             .add_whole("piles", 15, 2, 30, "rows of the pyramid that is drawn over time")
             .add_number("piles_duration", 1.0, 0.1, 100.0, "s", "of its run"),
     .quick = {"rows=7", "duration=0.3", "piles=5", "piles_duration=0.1"},
     .experiment = measure_levels}};

}  // namespace
}  // namespace tumble::chapters
