/// \file
/// \brief The figure on error against work.
#include "choosing/work_experiments.hpp"

namespace tumble::chapters {
namespace {

Figure work_against_error() {
  Figure figure;
  figure.name = "claim_6_3_2a_work";
  figure.section = "6.3.2";
  figure.title = "Error against work, for every technique";
  figure.caption =
      "Each mark is a time step, from 1/30 to 1/960 s; down is better, left is cheaper. Techniques "
      "that search for impacts bounce as exactly as they are told to, whatever the step, and slide "
      "no better than others. Most errors halve with the step; exact contact forces have none in "
      "the slide and a quarter in rocking, and what is glued a sixteenth. Damping is no friction. "
      "No technique leads in all three panels, and half of all pairs change places.";
  figure.parameters
      .add_whole("finest", 32, 1, 1024, "steps in 1/30 s at most; from 1 on, doubled each time")
      .add_number("tolerance", 0.01, 1e-9, 1.0, "-", "error for which the least work is asked");
  figure.quick = {"finest=4"};
  figure.experiment = measure_work_against_error;
  return figure;
}

}  // namespace

std::vector<Figure> work_against_error_figures() { return {work_against_error()}; }

}  // namespace tumble::chapters
