/// \file
/// \brief The figures on the cure.
#include "exterior_rotation/cure_figures.hpp"

namespace tumble::chapters {
namespace {

Figure one_twist_figure() {
  Figure figure;
  figure.name = "claim_6_2d_one_twist";
  figure.section = "6.2";
  figure.title = "Can one force and one torque carry a body round a circle?";
  figure.caption =
      "Figure 6.1's column, glued, with forces held over each step. Above: with centre and "
      "orientation moved apart it opens by millimetres. Moved by the exponential of its twist, "
      "each "
      "body keeps to its circle, and what is left is of the size of rounding, drawn grey. Below: "
      "the "
      "angle of the column after a second. Here the exponential gains nothing: how far the column "
      "has fallen depends on the scheme that changes the velocities.";
  figure.parameters
      .add_number("angle", 0.3, 0.01, 1.0, "rad", "of the column's centre at the start")
      .add_number("rate", 60.0, 5.0, 1e4, "1/s", "steps a second")
      .add_number("duration", 1.0, 0.1, 1.5, "s", "of the fall");
  figure.experiment = measure_one_twist;
  return figure;
}

Figure any_step_figure() {
  Figure figure;
  figure.name = "twist_any_step";
  figure.section = "6.2";
  figure.title = "Does it hold at any step, in space and in flight?";
  figure.caption =
      "Top: the largest gap in a second, over the step. Moved apart, the column opens in "
      "proportion "
      "to the step. With one twist for each body rounding is left at any step: for the column on "
      "its "
      "edge, on a ball joint with a spin of its own, and thrown into the air. Bottom: where the "
      "column is after a second. Steps that find forces at their start have errors of order 1, the "
      "leapfrog has order 2, in space as well. Grey lines have slopes 1 and 2.";
  figure.parameters
      .add_number("angle", 0.3, 0.01, 1.0, "rad", "of the column's centre at the start")
      .add_number("spin", 2.0, -20.0, 20.0, "rad/s", "about its long axis, on the ball joint")
      .add_number("duration", 1.0, 0.1, 1.5, "s", "of each run")
      .add_whole("coarsest", 5, 2, 50, "steps a second")
      .add_whole("finest", 1000, 60, 10000, "steps a second")
      .add_whole("steps", 16, 4, 100, "lengths of a step between them");
  figure.quick = {"finest=240", "steps=8"};
  figure.experiment = measure_any_step;
  return figure;
}

Figure one_pivot_figure() {
  Figure figure;
  figure.name = "claim_6_2c_one_pivot";
  figure.section = "6.2";
  figure.title = "Is one pivot enough for a group?";
  figure.caption =
      "Figure 6.3: a box turns on a box that turns. Top: with one twist for each body the joint "
      "between them opens in a step by half h² times the difference of spins times the joint's "
      "speed (lines). Bottom, against the upper box's spin: a single rotation for the group leaves "
      "less than that, if it has the best centre and the best rate. Equal and opposite spins, as "
      "in "
      "figure 6.3, suit it. Only a tree, in which each body turns about a point that the one below "
      "carries along, leaves nothing.";
  figure.parameters.add_number("rate", 60.0, 1.0, 1e4, "1/s", "steps a second, of the comparison")
      .add_whole("steps", 12, 2, 100, "lengths of a step")
      .add_whole("spins", 100, 2, 1000, "of the upper box, from -10 to 10 rad/s");
  figure.quick = {"spins=10", "steps=6"};
  figure.experiment = measure_one_pivot;
  return figure;
}

Figure which_centre_figure() {
  Figure figure;
  figure.name = "which_centre";
  figure.section = "6.2";
  figure.title = "About which point should a body be turned?";
  figure.caption =
      "A cube that turns, and what is wrong after one step: marks are measured, lines are half h² "
      "ω² times a lever. If it sticks, it has to go round the point that it touches. If it slides "
      "without friction, no point of it serves: its centre goes straight along the ground, and the "
      "cube is put back on it. In flight its centre goes straight; about what is at rest its way "
      "would bend. What is right leaves rounding, as written in each panel.";
  figure.parameters.add_number("spin", 2.0, 0.1, 20.0, "rad/s", "of the cube")
      .add_number("speed", 1.0, 0.1, 10.0, "m/s", "of sliding, and of flight along each axis")
      .add_number("tilt", 0.3, 0.01, 0.7, "rad", "of the cube that touches")
      .add_whole("steps", 12, 2, 100, "lengths of a step");
  figure.experiment = measure_which_centre;
  return figure;
}

}  // namespace

std::vector<Figure> cure_figures() {
  return {one_twist_figure(), any_step_figure(), one_pivot_figure(), which_centre_figure()};
}

}  // namespace tumble::chapters
