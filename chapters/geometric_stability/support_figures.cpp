/// \file
/// \brief The figures on which lower corners of a box are carried.
#include "geometric_stability/support_experiments.hpp"

namespace tumble::chapters {
namespace {

void add_load(Parameters& parameters) {
  parameters.add_number("load", 10.0, 0.0, 1e6, "-",
                        "on a corner of the top, over the weight of the top box");
}

Figure one_corner_figure() {
  Figure figure;
  figure.name = "fig5_3_one_corner";
  figure.section = "5.4";
  figure.title = "Figure 5.3: one corner of the top box is carried";
  figure.caption =
      "The layout is reconstructed from the caption: boxes on the left, their plane of contact on "
      "the "
      "right, one corner carried. Both rules say not stable, as the thesis does, and without "
      "friction "
      "the cube's own weight tips it. Below, other shifts: acceleration of its worst corner, over "
      "load "
      "per mass. Up to half an edge the cube would stand by itself, and the rules still say no. "
      "Rightly: ten times its weight on a corner of its top tips it at every shift.";
  figure.parameters.add_number("shift", 0.6, 0.0, 0.8, "m", "of the top cube, along x and along -z")
      .add_number("yaw", 20.0, -45.0, 45.0, "deg", "of the top cube about the vertical");
  add_load(figure.parameters);
  figure.parameters.add_whole("shifts", 81, 2, 1000, "points of the curves");
  figure.quick = {"shifts=9"};
  figure.experiment = measure_one_corner;
  return figure;
}

Figure all_corners_figure() {
  Figure figure;
  figure.name = "fig5_4_all_corners";
  figure.section = "5.4";
  figure.title = "Figure 5.4: the bottom box carries all four corners of the top box";
  figure.caption =
      "The layout is reconstructed from the caption, which makes the verdict on the top box that "
      "on "
      "the bottom one. Here the bottom box stands on the ground and is stable, all four corners "
      "are "
      "carried, and both rules agree with the thesis. So do the contact forces: "
      "wherever ten times its weight presses on a corner of its top, it keeps still. With the "
      "ground "
      "taken away under the bottom box the verdict turns, and both fall.";
  figure.parameters.add_number("offset", 0.2, -0.5, 0.5, "m",
                               "of the top cube from the middle, along x");
  add_load(figure.parameters);
  figure.experiment = measure_all_corners;
  return figure;
}

Figure two_supports_figure() {
  Figure figure;
  figure.name = "fig5_5_two_supports";
  figure.section = "5.4";
  figure.title = "Figure 5.5: two boxes carry two corners each";
  figure.caption =
      "The layout is reconstructed from the caption, by which the top box is stable if both "
      "boxes below are. No single one carries it, but the hull of all contact points "
      "covers its outline: nothing that presses on its top can tip it into the gap. Both rules and "
      "the contact forces agree. If nothing were under the left box, the top one "
      "would be called not stable, and would tip.";
  figure.parameters.add_number("gap", 0.4, 0.0, 0.8, "m", "between the two boxes below")
      .add_number("yaw", 15.0, -30.0, 30.0, "deg", "of the top box about the vertical");
  add_load(figure.parameters);
  figure.experiment = measure_two_supports;
  return figure;
}

}  // namespace

std::vector<Figure> support_figures() {
  return {one_corner_figure(), all_corners_figure(), two_supports_figure()};
}

}  // namespace tumble::chapters
