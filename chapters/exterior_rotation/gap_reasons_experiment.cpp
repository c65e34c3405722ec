/// \file
/// \brief Why the gaps of figure 6.1 differ from technique to technique.
#include "driver/common_numbers.hpp"
#include "exterior_rotation/falling_column.hpp"
#include "exterior_rotation/technique_experiments.hpp"

#include <array>
#include <cmath>

namespace tumble::chapters {
namespace {

constexpr double kRate = 60.0;  // [1/s]
constexpr double kPhi0 = 0.3;   // [rad] of the scenes

struct Line {
  const char* name;   // of the column
  const char* words;  // for readers
  PlayedTechnique played;
};

const std::array<Line, 5>& lines() {
  static const std::array<Line, 5> list{{
      {"glued", "glued with impulses", {"glued", {"scheme=impulse"}}},
      {"impulse", "impulse with 100 passes", {"impulse", {"contact_passes=100"}}},
      {"stepping", "time_stepping", {"time_stepping"}},
      {"damped", "contact_damped", {"contact_damped"}},
      {"analytic", "analytic", {"analytic"}},
  }};
  return list;
}

// [m] ½ g sin(tilt) h² of each frame, added up.
double creep(double time) {
  double sum = 0.0;
  const auto frames = static_cast<int>(std::lround(time * kRate));
  for (int k = 0; k < frames; ++k) sum += std::sin(column_angle(k / kRate, kPhi0) + column_tilt());
  return 0.5 * kGravity * sum / (kRate * kRate);
}

}  // namespace

Result measure_gap_reasons(const Parameters& settings) {
  const ComparedScene scene{"fig6_1", settings.number("time")};
  const ComparedScene& one_box = compared_scenes()[1];
  Result result;
  Table table{"", {{"step_s", "s", "step"}, {"one_step_m", "m", "what one step makes at the end"}}};
  for (const Line& line : lines())
    table.columns.push_back(
        {std::string(line.name) + "_m", "m", std::string("gap, ") + line.words});
  const double turning = column_rate(scene.time, kPhi0);
  for (int k = 0; k <= settings.count("halvings"); ++k) {
    const double rate = 0.5 * kRate * (1 << k);
    table.rows.push_back({1.0 / rate, 0.5 * turning * turning / (rate * rate)});
    for (const Line& line : lines())
      table.rows.back().push_back(run_technique(scene, line.played, rate).gap());
  }
  // Orders are told from the last two steps, so that the coarsest one does not spoil them.
  const std::vector<double>& coarse = table.rows[table.rows.size() - 2];
  const std::vector<double>& fine = table.rows.back();
  for (std::size_t k = 0; k < lines().size(); ++k)
    result.quantities.push_back(
        {std::string("order of the gap, ") + lines()[k].words, "-",
         std::log(coarse[k + 2] / fine[k + 2]) / std::log(coarse[0] / fine[0])});
  const auto add = [&](const char* words, const char* unit, double value) {
    result.quantities.push_back({words, unit, value});
  };
  const std::vector<double>& usual = table.rows[1];
  add("gap over what one step makes at the end, time_stepping", "-", usual[4] / usual[1]);
  const PlayedTechnique look{"time_stepping", {"form=anitescu_potra"}};
  add("gap, time_stepping that closes no gaps", "mm", 1e3 * run_technique(scene, look).gap());
  add("angle at the end behind that of the closed form, impulse", "rad",
      -run_technique(scene, {"impulse"}).angle_error);
  add("way of the lowest two cubes on each other over what they fall along the slope, "
      "timewarp_simple",
      "-", run_technique(scene, {"timewarp_simple"}).slide / creep(scene.time));
  add("angle at the end behind that of the closed form, damped", "rad",
      -run_technique(scene, {"damped"}).angle_error);
  const PlayedTechnique carried{"contact_damped", {"pose=exponential"}};
  add("way of figure 6.2's pivot edge, contact_damped, exponential", "mm",
      1e3 * run_technique(one_box, carried).pivot);
  add("the same, pivot half a metre from the larger box's edge", "mm",
      1e3 * run_technique(one_box, carried, kRate, {"inset=0.5"}).pivot);
  result.tables.push_back(table);
  return result;
}

}  // namespace tumble::chapters
