/// \file
/// \brief The figures on random piles.
#include "geometric_stability/hull_experiments.hpp"
#include "geometric_stability/load_experiments.hpp"
#include "geometric_stability/pile_experiments.hpp"

namespace tumble::chapters {
namespace {

Figure confusion_figure() {
  Figure figure;
  figure.name = "stable_confusion";
  figure.section = "5.4";
  figure.title = "Who is called stable in random piles, and who rests";
  figure.caption =
      "Above, one of the random piles, each box with what is known of it. Below, six ways to "
      "tell who stands firm, on all piles, against the complementarity problem of the "
      "weights. None calls a box stable that moves, and of boxes corners and hull say the "
      "same. They miss more than a third of those that rest: boxes that hang over a little, "
      "or stand side by side. One box that moves spoils the balance of its whole island. "
      "Hull, then towers, then balance misses least.";
  figure.parameters.add_whole("piles", 400, 2, 100000, "random piles")
      .add_whole("shown", 28, 1, 100000, "the pile that is drawn");
  figure.quick = {"piles=40"};
  figure.experiment = measure_confusion;
  return figure;
}

Figure load_figure() {
  Figure figure;
  figure.name = "claim_5_4a_any_load";
  figure.section = "5.4";
  figure.title = "Does a stable box stay where it is, whatever is put on it?";
  figure.caption =
      "Loads act straight down at random points of all tops, from a tenth of a box's weight "
      "to a hundred times it. For each box, the largest acceleration by the whole "
      "complementarity problem over what its load alone would give it. Boxes that the rule as "
      "meant calls stable do not move but for rounding, nor do further ones that are "
      "load-proof. Of those called stable as printed, one in twenty does move; of those that "
      "the rule does not call stable, three in four.";
  figure.parameters.add_whole("piles", 300, 2, 100000, "random piles")
      .add_whole("loads", 20, 1, 10000, "loads on all tops of each pile");
  figure.quick = {"piles=30", "loads=5"};
  figure.experiment = measure_any_load;
  return figure;
}

Figure hull_figure() {
  Figure figure;
  figure.name = "claim_5_4c_hull";
  figure.section = "5.4";
  figure.title = "Four corners, or the hull of the supports?";
  figure.caption =
      "Four bodies from above, and below who is right where the rules differ, under loads on "
      "every corner of every top. For boxes hull and corners ask for the same points. What "
      "differs is that the footnote wants all supports stable: rightly where one can tip, "
      "often needlessly where some touch side by side. In piles it errs on the safe side: "
      "what it calls stable stays. Prisms it judges without a mistake. With a tolerance it "
      "forgives a corner off its support, which tips.";
  figure.parameters.add_whole("piles", 800, 2, 100000, "random piles")
      .add_whole("trials", 200, 1, 100000, "bodies of each other kind");
  figure.quick = {"piles=40", "trials=15"};
  figure.experiment = measure_hull;
  return figure;
}

}  // namespace

std::vector<Figure> pile_figures() { return {confusion_figure(), load_figure(), hull_figure()}; }

}  // namespace tumble::chapters
