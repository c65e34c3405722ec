/// \file
/// \brief The figure on impacts at nearly the same time.
#include "timewarp/tie_experiments.hpp"

namespace tumble::chapters {

std::vector<Figure> tie_figures() {
  Figure figure;
  figure.name = "claim_5_1c_ties";
  figure.section = "5.1";
  figure.title = "Two impacts nearer in time than the tolerance: in which order?";
  figure.caption =
      "Two cubes hit a third from both sides, one a little later. Above, how often this one "
      "comes first. Bisection (simple) finds cells of time: two impacts in one cell have the "
      "order of their numbers, as if a coin were tossed. Swept volumes find impacts exactly if "
      "cubes do not turn, else up to a tolerance early: so order is lost, as the thesis says. "
      "Below, ties resolved at one stroke: no order is made up then, and none was wrong.";
  figure.parameters
      .add_whole("trials", 400, 1, 100000, "pairs of impacts in each bin, turning and not")
      .add_whole("varied", 400, 1, 100000, "the same with other tolerances")
      .add_number("resolution", 1e-6, 1e-9, 1e-3, "s", "tolerance of the search for collisions");
  figure.quick = {"trials=40", "varied=40"};
  figure.experiment = measure_ties;
  return {figure};
}

}  // namespace tumble::chapters
