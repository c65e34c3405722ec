/// \file
/// \brief The figures on the chatter that techniques leave.
#include "filtering/technique_chatter_experiments.hpp"

namespace tumble::chapters {
namespace {

Figure chatter_table() {
  Figure figure;
  figure.name = "chatter_table";
  figure.section = "5.5";
  figure.title = "Chatter of every technique";
  figure.caption =
      "Largest amplitude in a scene, median over eight random starts, shaded; below it the "
      "smallest and largest, the acceleration, and cubes that go on moving. Who overlaps may "
      "share a rank. Contact areas that are solved stiff hold everything within three "
      "micrometres, time stepping within rounding. Impulses shake a pyramid by millimetres from "
      "every start. Damped integration stops dead from some starts and chatters by millimetres "
      "from others, so it shares first ranks. What is left of analytic in the clump is sliding. "
      "Grey: fell, or too slow.";
  figure.parameters.add_whole("seeds", 8, 1, 100, "random starts")
      .add_whole("others", 4, 1, 100, "of these, for techniques without resting contact")
      .add_whole("boxes", 5, 1, 20, "of the stack")
      .add_whole("rows", 5, 1, 10, "of the pyramid")
      .add_whole("small", 2, 2, 3, "cubes along each edge of the small clump's grid")
      .add_whole("large", 3, 2, 6, "cubes along each edge of the large clump's grid")
      .add_number("scatter", 0.01, 0.0, 0.1, "m", "how far boxes of piles are off their places")
      .add_number("scatter_angle", 0.0, 0.0, 10.0, "deg", "and by how much they are turned")
      .add_number("settling", 2.0, 0.0, 60.0, "s", "before boxes of piles should rest")
      .add_number("flying", 5.0, 0.0, 60.0, "s", "before cubes of clumps should rest")
      .add_number("watched", 1.0, 0.5, 60.0, "s", "after that")
      .add_flag("patient", false, "run what takes minutes too");
  figure.quick = {"seeds=1",    "boxes=3",    "rows=2",     "large=2",
                  "settling=1", "flying=1.5", "watched=0.5"};
  figure.experiment = tabulate_chatter;
  return figure;
}

Figure left_chatter() {
  Figure figure;
  figure.name = "claim_6_1b_chatter";
  figure.section = "6.1";
  figure.title = "How many cubes of the settled clump chatter?";
  figure.caption =
      "Above, the cubes of twenty settled clumps by the amplitude of their chatter: four in ten "
      "stand "
      "perfectly still, as many shake by a thousandth of an edge or more, and many lie just below "
      "that line. So some chatter is left, as the thesis says. Below, the same with half and twice "
      "the thresholds, the damping and the passes over contacts, for which the thesis gives no "
      "numbers: twice as much of the first two leaves none, twice the passes leave less, and half "
      "the thresholds or half the passes leave more.";
  figure.parameters.add_whole("seeds", 20, 1, 100, "clumps")
      .add_whole("varied", 3, 1, 100, "of these, with other constants")
      .add_whole("per_edge", 5, 2, 8, "cubes along each edge of the grid at the start")
      .add_number("settling", 10.0, 0.5, 60.0, "s", "before cubes should rest")
      .add_number("watched", 4.0, 0.5, 60.0, "s", "after that");
  figure.quick = {"seeds=2", "varied=2", "per_edge=3", "settling=5", "watched=1"};
  figure.experiment = measure_left_chatter;
  return figure;
}

}  // namespace

std::vector<Figure> technique_chatter_figures() { return {chatter_table(), left_chatter()}; }

}  // namespace tumble::chapters
