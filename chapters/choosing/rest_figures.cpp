/// \file
/// \brief The figures on rest and tipping, and on cost.
#include "choosing/cost_experiments.hpp"
#include "choosing/rest_experiments.hpp"

namespace tumble::chapters {
namespace {

Figure rest_and_tip() {
  Figure figure;
  figure.name = "choose_rest";
  figure.section = "6.3.2";
  figure.title = "What rests, under which load, and when a box tips";
  figure.caption =
      "Above, a stack of ten cubes that begins up to a centimetre off its places, the worst of "
      "three starts. Contact areas, exact forces, time stepping and impulses bring it to rest; the "
      "last let it sink by centimetres on the way. Damping goes on shaking it, boxes at more than "
      "1 m/s, and what knows no rest lets it fall. Below, the overlap of two cubes whose upper one "
      "is heavier: stiff areas "
      "and forces that are solved for do not feel it.";
  figure.parameters.add_whole("boxes", 10, 1, 20, "of the stack")
      .add_whole("seeds", 3, 1, 100, "starts of each pile, of which the worst counts")
      .add_number("scatter", 0.01, 0.0, 0.1, "m", "how far boxes of piles are off their places")
      .add_number("duration", 2.0, 0.5, 60.0, "s", "simulated time of each pile")
      .add_whole("halves", 9, 1, 30, "of the interval of slopes from 2 to 60 degrees");
  figure.quick = {"boxes=2", "seeds=1", "duration=0.6", "halves=2"};
  figure.experiment = measure_rest_and_tip;
  return figure;
}

Figure cost() {
  Figure figure;
  figure.name = "choose_cost";
  figure.section = "6.3.2";
  figure.title = "Work of a step at 10, 100 and 1000 boxes";
  figure.caption =
      "What the step reports count, on average over four steps. In stacks that stand apart the "
      "work of most grows as the number of boxes. In a pyramid all hang together: sweeps still "
      "grow nearly so, forces that are searched for by pivoting grow faster. Curves that end early "
      "would take a second or more for a step; glued takes a hundred joints at most. Counts are no "
      "times.";
  figure.parameters.add_whole("steps", 4, 1, 1000, "of 1/60 s, over which the work is averaged")
      .add_flag("patient", false, "run what takes a second or more for a step too");
  figure.quick = {"steps=1"};
  figure.experiment = measure_cost;
  return figure;
}

}  // namespace

std::vector<Figure> rest_and_tip_figures() { return {rest_and_tip()}; }

std::vector<Figure> cost_figures() { return {cost()}; }

}  // namespace tumble::chapters
