/// \file
/// \brief The figures on stable boxes that are left out of the contact forces.
#include "geometric_stability/excluded_experiments.hpp"

namespace tumble::chapters {
namespace {

Figure pyramid_figure() {
  Figure figure;
  figure.name = "fig5_6_pyramid";
  figure.section = "5.4";
  figure.title = "Figure 5.6: a pyramid without its bottom centre box, and who in it is stable";
  figure.caption =
      "The layout is reconstructed from the caption: a pyramid from the side, its bottom centre "
      "box taken out, stable boxes dark, others light. Rows and gaps are ours. Left, neighbours "
      "are 0.05 of an edge apart, and who stands over the hole is not stable. Right, they touch: "
      "contacts from the side rule out everybody, though the lowest row bears every load. Below, "
      "the unknown forces if nobody, the stable boxes, or wider classes of ours are left out. From "
      "five rows on nothing falls: all is in balance.";
  figure.parameters.add_whole("rows", 9, 3, 31, "boxes in the lowest row before; an odd number")
      .add_number("gap", 0.05, 0.0, 0.9, "-", "between neighbours on the left, in edges");
  figure.quick = {"rows=5"};
  figure.experiment = measure_stable_pyramid;
  return figure;
}

Figure excluded_figure() {
  Figure figure;
  figure.name = "claim_5_4b_excluded";
  figure.section = "5.4";
  figure.title = "What does it save to leave stable boxes out of the contact forces?";
  figure.caption =
      "The pyramid of figure 5.6, gap 0.05, of three to thirteen rows, with all boxes and without "
      "the stable ones. Baraff's method, which the thesis uses, does a fifth to a twentieth of its "
      "multiplications; rings mark where its pivoting gave up and another form of it went on. Our "
      "default solver saves little more than its unknowns. Bottom: at rest the gain lasts; if the "
      "light boxes are knocked it shrinks, as contacts tilt; three rows fall, and it is gone after "
      "a step.";
  figure.parameters.add_whole("rows", 11, 3, 21, "of the pyramid that decides; an odd number")
      .add_whole("largest", 13, 3, 21, "rows of the largest pyramid")
      .add_number("gap", 0.05, 0.0, 0.9, "-", "between neighbours, in edges")
      .add_whole("shuffled_rows", 7, 3, 11, "of the one whose contacts are shuffled; odd")
      .add_whole("knocked_rows", 5, 3, 11, "of the pyramid that is knocked; an odd number")
      .add_number("knock", 0.2, 0.0, 2.0, "m/s", "largest component of a velocity at the start")
      .add_whole("seeds", 20, 2, 1000, "knocks, and orders of contacts")
      .add_whole("steps", 60, 1, 6000, "of 1/60 s");
  figure.quick = {"rows=7", "largest=7", "shuffled_rows=5", "seeds=2", "steps=20"};
  figure.experiment = measure_excluded;
  return figure;
}

Figure share_figure() {
  Figure figure;
  figure.name = "stable_share_of_gain";
  figure.section = "5.4, A.2";
  figure.title = "How much of what the listing saves as printed is saved by right?";
  figure.caption =
      "What the listing takes out of the system of contact forces, as printed and mended. By "
      "right: the mended listing takes it out too. By luck: it does not, and no box accelerates. "
      "Wrongly: a box called stable accelerates by more than a thousandth of g, as static "
      "equilibrium finds. At rest a few per cent are wrong, in a pyramid that falls nearly all. "
      "Mended, more is taken out, since equality gets a tolerance; where neighbours touch, "
      "nothing. Below, one erratum at a time is left in.";
  figure.parameters.add_whole("seeds", 40, 2, 1000, "random piles of each kind")
      .add_number("tilted", 0.3, 0.0, 1.0, "-", "share of the boxes that come down tilted")
      .add_whole("knocks", 20, 2, 1000, "knocked pyramids");
  figure.quick = {"seeds=6", "knocks=2"};
  figure.experiment = measure_share_of_gain;
  return figure;
}

}  // namespace

std::vector<Figure> excluded_figures() {
  return {pyramid_figure(), excluded_figure(), share_figure()};
}

}  // namespace tumble::chapters
