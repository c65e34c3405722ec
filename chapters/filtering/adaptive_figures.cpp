/// \file
/// \brief The figures on adaptive steps.
#include "filtering/adaptive_experiments.hpp"

namespace tumble::chapters {
namespace {

Parameters clump_parameters(int seeds, int per_edge, int halvings) {
  Parameters p;
  p.add_whole("seeds", seeds, 2, 1000, "clumps")
      .add_whole("per_edge", per_edge, 1, 10, "cubes along each edge of the grid at the start")
      .add_number("settling", 4.0, 0.5, 1000.0, "s", "before bodies should rest")
      .add_number("watched", 2.0, 0.5, 1000.0, "s", "after that, a multiple of half a second")
      .add_whole("halvings", halvings, 0, 10, "of a step, at most");
  return p;
}

Figure claim_figure() {
  Figure figure;
  figure.name = "claim_6_3_1b_adaptive";
  figure.section = "6.3.1";
  figure.title = "Do steps that adapt reduce chatter?";
  figure.caption =
      "The clump of figure 6.7 under damped integration: steps of 1/60 s, and the same in "
      "up to four parts where bodies move far, overlap or chatter. Above, who still moves; "
      "middle, parts of a step; below, by how much the bodies at rest shake. Hoped for are "
      "less chatter and earlier rest. Found are more chatter and later rest, for six times "
      "the pair tests. Once the heap shakes the step stays small: what shakes it is a push that "
      "does not shrink with the step.";
  figure.parameters = clump_parameters(20, 5, 2);
  figure.quick = {"seeds=2", "settling=1", "watched=0.5", "halvings=1"};
  figure.experiment = measure_adaptive_claim;
  return figure;
}

Figure cost_figure() {
  Figure figure;
  figure.name = "adaptive_step_cost";
  figure.section = "6.3.1";
  figure.title = "What smaller steps cost, and what they are good for";
  figure.caption =
      "A clump of 64 cubes, damped integration. Above and middle, chatter and time to rest "
      "against work; the adaptive steps differ in how far a corner may shake before the "
      "step is halved. Smaller steps cost more and gain nothing here, and no tolerance does better "
      "than 1/60 s. Time ends at 6 s. Below, what smaller steps are good "
      "for: of cubes thrown at a thin plank some pass through at fixed steps, none at "
      "adaptive ones.";
  figure.parameters = clump_parameters(2, 4, 3);
  figure.parameters.add_whole("throws", 12, 1, 1000, "at a plank, at each speed");
  figure.quick = {"per_edge=3", "settling=1", "watched=0.5", "halvings=2", "throws=3"};
  figure.experiment = measure_adaptive_cost;
  return figure;
}

Figure cause_figure() {
  Figure figure;
  figure.name = "adaptive_step_cause";
  figure.section = "6.3.1";
  figure.title = "Where chatter comes from";
  figure.caption =
      "A clump of 64 cubes under damped integration at three fixed steps, with four sizes of "
      "the push that ends overlap. Above, by how much bodies at rest shake; below, how many "
      "rest. Halving the step alone makes both worse. Chatter follows the push: with a quarter "
      "of it about a third is left, or less. A push that shrinks with the square of the step, "
      "as what gravity does in a step, keeps chatter within twice that at 1/60 s; without a "
      "push least is left at small steps.";
  figure.parameters = clump_parameters(2, 4, 2);
  figure.quick = {"per_edge=3", "settling=1", "watched=0.5", "halvings=1"};
  figure.experiment = measure_chatter_cause;
  return figure;
}

}  // namespace

std::vector<Figure> adaptive_figures() { return {claim_figure(), cost_figure(), cause_figure()}; }

}  // namespace tumble::chapters
