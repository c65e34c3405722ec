/// \file
/// \brief Figures 6.1 to 6.3 of the thesis, and whether the trouble is turning.
#include "exterior_rotation/problem_figures.hpp"

#include "exterior_rotation/column_film.hpp"
#include "exterior_rotation/problem_experiments.hpp"

#include <array>
#include <string>

namespace tumble::chapters {
namespace {

void add_film(Parameters& parameters, double duration, const std::array<double, 4>& times) {
  parameters.add_number("rate", 60.0, 10.0, 1e4, "1/s", "steps a second")
      .add_number("duration", duration, 0.1, 1.2, "s", "of the motion")
      .add_number("magnification", 50.0, 2.0, 1e3, "-", "of the insets over the frames");
  for (std::size_t k = 0; k < times.size(); ++k)
    parameters.add_number(std::string("t").append(std::to_string(k + 1)), times[k], 0.0, 1.2, "s",
                          "of a frame");
}

Figure column_figure() {
  Figure figure;
  figure.name = "fig6_1_column";
  figure.section = "6.2";
  figure.title = "Figure 6.1: four boxes that stick together fall over an edge";
  figure.caption =
      "Filled: forward Euler at 60 steps a second; dashed: the exact fall. Each centre "
      "should stay on its circle about the pivot. The forces are right at the start of "
      "each step, yet the joints open: every box goes straight on where its way is an arc. "
      "Lowest panel: the gap that one step makes of an exact state. With semi-implicit "
      "Euler that is overlap; over time its gap grows all the same. Midpoint and rk4 find "
      "forces anew within a step and are far better.";
  figure.film =
      "Forward Euler with steps of a tenth of a second, four times slowed down. On the left "
      "centres and "
      "orientations are moved apart, and the joints open; on the right each body is moved by the "
      "exponential of its twist, with the same forces, and they stay shut.";
  figure.parameters.add_whole("boxes", 4, 2, 8, "cubes in the column")
      .add_number("angle", 0.3, 0.05, 0.9, "rad", "of the column's centre at the start");
  add_film(figure.parameters, 1.0, {0.0, 0.4, 0.8, 1.0});
  figure.quick = {"rate=30"};
  figure.experiment = [](const Parameters& settings) {
    Result result = measure_fall(settings);
    result.film = [settings] { return column_film(settings); };
    return result;
  };
  return figure;
}

Figure one_box_figure() {
  Figure figure;
  figure.name = "fig6_2_one_box";
  figure.section = "6.2";
  figure.title = "Figure 6.2: one box falls over an edge";
  figure.caption =
      "One box is enough. The corner on which it turns ought to stay where it is, but it "
      "drifts off as the centre leaves its circle. Filled: forward Euler at 60 steps a "
      "second; dashed: exact. The fall ends before a face would meet the larger box. The "
      "thesis calls this less extreme than the column. It is over sooner, and then its gap "
      "is smaller; but at the same turn the corner has drifted a little farther than "
      "anything in the column of four.";
  figure.parameters.add_whole("boxes", 1, 1, 1, "one")
      .add_number("angle", 0.3, 0.05, 0.9, "rad", "of the box's centre at the start");
  add_film(figure.parameters, 0.45, {0.0, 0.2, 0.35, 0.45});
  figure.quick = {"rate=30"};
  figure.experiment = measure_fall;
  return figure;
}

Figure nested_figure() {
  Figure figure;
  figure.name = "fig6_3_nested";
  figure.section = "6.2";
  figure.title = "Figure 6.3: a box turns on a box that turns";
  figure.caption =
      "The lower box turns about an edge of the larger one, the upper box about an edge "
      "that rides on the lower one, so the second circle moves. Filled: forward Euler at "
      "60 steps a second; dashed: exact. Moving each body by the exponential of its own "
      "twist mends the lower edge to the last digits. It does not mend the upper one: the "
      "two boxes follow different arcs, and with both Euler schemes the upper edge comes "
      "apart more than before. Midpoint, leapfrog and rk4 stay close.";
  add_film(figure.parameters, 0.6, {0.0, 0.2, 0.4, 0.6});
  figure.quick = {"rate=30"};
  figure.experiment = measure_nested;
  return figure;
}

Figure turning_figure() {
  Figure figure;
  figure.name = "claim_6_2a_turning";
  figure.section = "6.2";
  figure.title = "Is it turning that pulls boxes apart?";
  figure.caption =
      "Above: forward Euler with forces that are right at the start of each step. The "
      "column that turns over the edge opens by a hundredth of its edge in a second; "
      "pushed along by a force as large as its weight, it stays together up to rounding. "
      "Below: what one step of the turning column makes of an exact state. For the three "
      "simple schemes it is half the square of the turn times the spacing, with opposite "
      "sign for semi-implicit Euler; midpoint and rk4 gain one and three orders.";
  figure.parameters
      .add_number("angle", 0.3, 0.05, 0.9, "rad", "of the column's centre at the start")
      .add_number("rate", 60.0, 10.0, 1e4, "1/s", "steps a second")
      .add_number("duration", 1.0, 0.1, 1.0, "s", "of both motions")
      .add_number("push", 1.0, 0.0, 100.0, "-", "on the column that does not turn, over its weight")
      .add_whole("sizes", 21, 3, 200, "single steps, from 0.1 s to 0.01 s");
  figure.quick = {"sizes=7"};
  figure.experiment = measure_turning;
  return figure;
}

}  // namespace

std::vector<Figure> problem_figures() {
  return {column_figure(), one_box_figure(), nested_figure(), turning_figure()};
}

}  // namespace tumble::chapters
