/// \file
/// \brief Reasons why the gaps of figure 6.1 differ from technique to technique.
#include "driver/experiment.hpp"
#include "exterior_rotation/falling_column.hpp"
#include "exterior_rotation/technique_experiments.hpp"

namespace tumble::chapters {
namespace {

constexpr double kRate = 60.0;  // [1/s]

struct Line {
  const char* name;       // of the column
  std::size_t technique;  // of techniques_with_pose()
};
constexpr std::array kLines = {Line{"glued", 5}, Line{"impulse", 4}, Line{"stepping", 2},
                               Line{"damped", 0}, Line{"analytic", 1}};

// [m] ½ g sin(tilt) h² of each frame, added up.
double creep(double time) {
  double sum = 0.0;
  const auto frames = static_cast<int>(std::lround(time * kRate));
  for (int k = 0; k < frames; ++k)
    sum += std::sin(column_angle(k / kRate, kSceneAngle) + column_tilt());
  return 0.5 * kGravity * sum / (kRate * kRate);
}

Result measure_gap_reasons(const Parameters& settings) {
  const ComparedScene scene{"fig6_1", settings.number("time")};
  const ComparedScene& one_box = compared_scenes()[1];
  Result result;
  Table table{"", {{"step_s", "s", "step"}, {"one_step_m", "m", "what one step makes at the end"}}};
  for (const Line& line : kLines)
    table.columns.push_back({std::string(line.name) + "_m", "m",
                             "gap, " + techniques_with_pose()[line.technique].words});
  const double turning = column_rate(scene.time, kSceneAngle);
  for (int k = 0; k <= settings.count("halvings"); ++k) {
    const double rate = 0.5 * kRate * (1 << k);
    std::vector<double> gaps;
    for (const Line& line : kLines)
      gaps.push_back(
          run_technique(scene, techniques_with_pose()[line.technique].played, rate).gap());
    table.add(1.0 / rate, 0.5 * turning * turning / (rate * rate), gaps);
  }
  // Orders are fitted to the last two steps: the coarsest one would spoil them.
  const std::vector<double>& coarse = table.rows[table.rows.size() - 2];
  const std::vector<double>& fine = table.rows.back();
  for (std::size_t k = 0; k < kLines.size(); ++k)
    result.add("order of the gap, " + techniques_with_pose()[kLines[k].technique].words, "-",
               std::log(coarse[k + 2] / fine[k + 2]) / std::log(coarse[0] / fine[0]));
  const auto add = [&](const char* words, const char* unit, double value) {
    result.add(words, unit, value);
  };
  const std::vector<double>& usual = table.rows[1];
  add("gap over what one step makes at the end, time_stepping", "-", usual[4] / usual[1]);
  const PlayedTechnique look{"time_stepping", {"form=anitescu_potra", "directions=4"}};
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

const Registered technique_gap_orders_figure{
    {.name = "technique_gap_orders",
     .parameters = Parameters{}
                       .add_number("time", 0.8, 0.1, 0.8, "s", "from the start")
                       .add_whole("halvings", 2, 1, 4, "of the step of 1/30 s"),
     .quick = {"time=0.4", "halvings=1"},
     .experiment = measure_gap_reasons}};

}  // namespace
}  // namespace tumble::chapters
