/// \file
/// \brief Pyramids under shock propagation, with restitution that rises in the sweeps or not (2.5.2).
#include "driver/experiment.hpp"

namespace tumble::chapters {
namespace {

// How a pyramid has moved.
struct Moved {
  double drift = 0.0;  // [mm] of the box that has gone farthest
  double added = 0.0;  // [J] sum of all gains of total energy in a step
};

Moved moved_of(int rows, const char* rule, double duration) {
  PlayedScene played(scene_with("pyramid", {"rows=" + std::to_string(rows)}),
                     {"impulse", {std::string("level_restitution=") + rule}});
  const std::vector<BodyState> start(played.world().states().begin(),
                                     played.world().states().end());
  double before = energy_of(played.world()).total();
  Moved out;
  played.advance(duration, [&](const StepReport&) {
    const double now = energy_of(played.world()).total();
    out.added += std::max(0.0, now - before);
    before = now;
  });
  for (std::size_t k = 0; k < start.size(); ++k)
    out.drift = std::max(
        out.drift, 1e3 * (played.world().states()[k].position_w - start[k].position_w).norm());
  return out;
}

Result measure_levels(const Parameters& settings) {
  const int most = settings.count("rows");
  Table table{"",
              {{"rows", "-", "of the pyramid"},
               {"constant_mm", "mm", "drift, restitution of the sweeps constant, as printed"},
               {"shock_mm", "mm", "drift, rising in shock propagation"},
               {"rising_mm", "mm", "drift, rising in all sweeps"}}};
  std::vector<Quantity> numbers;
  for (int rows = 4; rows <= most; rows += 3) {
    std::array<double, 3> drift{};
    std::size_t k = 0;
    for (const char* rule : {"constant", "shock", "rising"}) {
      const Moved moved = moved_of(rows, rule, settings.number("duration"));
      drift[k++] = moved.drift;
      if (rows + 3 <= most) continue;
      numbers.push_back({std::string("drift of the highest pyramid, ") + rule, "mm", moved.drift});
      if (rule == std::string_view("constant"))
        numbers.push_back({"energy added to it, constant", "J", moved.added});
    }
    table.add(rows, drift[0], drift[1], drift[2]);
  }
  return {{table}, numbers};
}

const Registered impulse_levels_figure{
    {.name = "impulse_levels",
     .parameters =
         Parameters{}
             .add_whole("rows", 10, 4, 30, "of the highest pyramid; 4, 7, 10 and so on are run")
             .add_number("duration", 2.0, 0.5, 100.0, "s", "of each run"),
     .quick = {"rows=7", "duration=1"},
     .experiment = measure_levels}};

}  // namespace
}  // namespace tumble::chapters
