/// \file
/// \brief The figure on stable boxes that slide.
#include "geometric_stability/sliding_experiments.hpp"

namespace tumble::chapters {

std::vector<Figure> sliding_figures() {
  Figure figure;
  figure.name = "claim_5_4d_sliding";
  figure.section = "5.4";
  figure.title = "Do stable boxes slide, and are they damped then?";
  figure.caption =
      "The layout of figure 5.4 is reconstructed from its caption; dark boxes are stable. The "
      "upper one slides at 11 m/s. Damped integration takes 8 % of its speed in each step, stable "
      "or not; its mark goes in the step in which a corner passes the edge. Analytic forces "
      "with stable boxes left out: without friction it keeps its speed, with damping it does not. "
      "Below, other speeds: all steps count but the first one, before which nobody has been "
      "classified.";
  figure.parameters
      .add_number("offset", -0.4, -0.5, 0.5, "m", "of the upper box from the middle at the start")
      .add_number("speed", 11.0, 1.0, 50.0, "m/s", "of the upper box in the run that is drawn")
      .add_number("slowest", 5.0, 0.1, 50.0, "m/s", "of the runs that are counted")
      .add_whole("speeds", 10, 1, 50, "of them, 1 m/s apart");
  figure.quick = {"slowest=11", "speeds=3"};
  figure.experiment = measure_sliding;
  return {figure};
}

}  // namespace tumble::chapters
