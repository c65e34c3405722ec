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
    if (steps % 6 == 0) out.drifts.push_back(1e3 * farthest_moved(start, played.world().states()));
  });
  out.drift = 1e3 * farthest_moved(start, played.world().states());
  return out;
}

Scene pyramid_of(int rows) { return make_scene("pyramid", {"rows=" + std::to_string(rows)}); }

std::vector<std::string> rule_of(const char* rule) {
  return {std::string("level_restitution=") + rule};
}

// The highest pyramid over time, and what its first step does, by rule.
void add_pyramid(const std::array<Moved, 3>& by_rule, Result& result) {
  const Moved& constant = by_rule[0];
  const Moved& rising = by_rule[2];
  result.add("drift of the highest pyramid, constant", "mm", constant.drift);
  result.add("energy added to it, constant", "J", constant.added);
  result.add("drift of the highest pyramid, shock", "mm", by_rule[1].drift);
  result.add("drift of the highest pyramid, rising", "mm", rising.drift);
  Table table{"piles",
              {{"time_s", "s", "since the start"},
               {"pyramid_mm", "mm", "farthest drift in the highest pyramid, constant"},
               {"pyramid_rising_mm", "mm", "the same, rising"}}};
  for (std::size_t k = 0; k < constant.drifts.size(); ++k)
    table.add(0.1 * static_cast<double>(k + 1), constant.drifts[k], rising.drifts[k]);
  Table spins{"spins",
              {{"row", "-", "of the pyramid, from the ground up"},
               {"constant", "rad/s", "largest spin that the first step leaves, constant"},
               {"rising", "rad/s", "the same, rising"}}};
  for (std::size_t row = 0; row < constant.spins.size(); ++row)
    spins.add(row + 1, constant.spins[row], rising.spins[row]);
  const auto most = [](const Moved& moved) { return *std::ranges::max_element(moved.spins); };
  result.add("largest spin that the first step leaves in the pyramid, constant", "rad/s",
             most(constant));
  result.add("largest spin that the first step leaves in the pyramid, rising", "rad/s",
             most(rising));
  result.tables.push_back(table);
  result.tables.push_back(spins);
}

Result measure_levels(const Parameters& settings) {
  const int most = settings.count("rows");
  const double duration = settings.number("duration");
  Table table{"",
              {{"rows", "-", "of the pyramid"},
               {"constant_mm", "mm", "drift, restitution of the sweeps constant, as printed"},
               {"shock_mm", "mm", "drift, rising in shock propagation"},
               {"rising_mm", "mm", "drift, rising in all sweeps"}}};
  Result result;
  for (int rows = 4; rows <= most; rows += 3) {
    std::array<Moved, 3> by_rule;
    std::size_t k = 0;
    for (const char* rule : {"constant", "shock", "rising"})
      by_rule[k++] = moved_of(pyramid_of(rows), rule_of(rule), duration);
    table.add(rows, by_rule[0].drift, by_rule[1].drift, by_rule[2].drift);
    if (rows + 3 > most) add_pyramid(by_rule, result);
  }
  result.tables.push_back(table);
  for (const char* rule : {"constant", "rising"})
    result.add(std::string("drift of the stack of ten, ") + rule, "mm",
               moved_of(make_scene("stack", {"count=10"}), rule_of(rule), duration).drift);
  return result;
}

const Registered impulse_levels_figure{
    {.name = "impulse_levels",
     .parameters = {whole("rows", 10, 4, 30, "of the highest pyramid; 4, 7, 10 and so on are run"),
                    number("duration", 1.0, 0.1, 100.0, "s", "of each run")},
     .quick = {"rows=7", "duration=0.3"},
     .experiment = measure_levels}};

}  // namespace
}  // namespace tumble::chapters
