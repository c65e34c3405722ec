/// \file
/// \brief The list of this chapter's figures: parameters, captions.
#include "basic_colliding/experiments.hpp"

namespace tumble::chapters {
namespace {

Figure rotation_rules_figure() {
  Figure figure;
  figure.name = "rotation_rules";
  figure.section = "3.1";
  figure.title = "A box spun about its middle axis turns over, if its rotation is integrated well";
  figure.caption =
      "A box of 3 × 2 × 1 m spins about its middle axis, which is unstable: it turns over "
      "every 5.52 s. Above, the angular velocity about that axis in the box's own frame. "
      "Splitting and the rule of Runge and Kutta lie on the exact solution (grey; Jacobi's "
      "elliptic functions, by GSL). Midpoint is almost a second early at the second turn. "
      "Holding the angular velocity over each step, the simplest rule, soon has nothing to do "
      "with the motion. Below, the energy error, although nothing acts on the box: under "
      "splitting it comes back to nearly zero after every turn; midpoint and Runge and Kutta "
      "keep a part of it; the simple rule ends with almost twice the energy. The line is what "
      "is accepted of Runge and Kutta's rule. The table has the errors of the moment at which the "
      "box first turns over: halving the step divides them by about 2, 4, 4 and 16.";
  figure.parameters.add_number("step", 0.02, 1e-4, 0.2, "s", "time step of the curves")
      .add_number("duration", 12.0, 1.0, 60.0, "s", "length of the run");
  figure.quick = {"duration=4"};
  figure.experiment = measure_rotation_rules;
  return figure;
}

Figure rotation_order_figure() {
  Figure figure;
  figure.name = "rotation_order";
  figure.section = "3.1";
  figure.title = "What halving the step buys under each rotation rule";
  figure.caption =
      "Angle between the computed and the true orientation of a freely tumbling box after 2 "
      "s. Each rule falls along a straight line, and its slope is the order of the rule: 1 "
      "when the angular velocity is held over the step, 2 for midpoint and splitting, 4 for "
      "Runge and Kutta, until rounding takes over at the left. The truth comes from GSL's "
      "eighth-order integrator.";
  figure.parameters.add_number("time", 2.0, 0.1, 20.0, "s", "when the orientations are compared")
      .add_whole("halvings", 10, 5, 14, "how often the longest step, time/16, is halved");
  figure.quick = {"halvings=6"};
  figure.experiment = measure_rotation_order;
  return figure;
}

Figure free_fall_figure() {
  Figure figure;
  figure.name = "free_fall";
  figure.section = "3.1";
  figure.title = "A falling box: two Euler rules are off by half a step, ballistic flight is exact";
  figure.caption =
      "Error of the height after 1 s of free fall. Forward Euler ends too high and semi- "
      "implicit Euler too low by the same g t h/2, so that halving the step halves the error. "
      "Flight along the parabola, which techniques use between events, is exact at any step: "
      "its marks show nothing but rounding, which grows with the number of steps.";
  figure.parameters.add_number("height", 10.0, 0.0, 1000.0, "m", "height at the start")
      .add_number("duration", 1.0, 0.1, 10.0, "s", "length of the fall")
      .add_whole("halvings", 9, 3, 14, "how often the longest step, duration/4, is halved");
  figure.quick = {"halvings=4"};
  figure.experiment = measure_free_fall;
  return figure;
}

Figure zeno_figure() {
  Figure figure;
  figure.name = "zeno";
  figure.section = "2.1, 4.3";
  figure.title = "A bouncing box needs infinitely many impacts in a finite time";
  figure.caption =
      "Above, the height of a box that is dropped flat. It comes to rest at the dashed time, "
      "after infinitely many bounces. In the middle the speed after each impact: equal steps "
      "down on a log axis while the impacts crowd together in time. A technique that makes an "
      "event of every impact never gets past the dashed line; one that lets bodies stick when "
      "they rebound slower than the threshold is done after 9. Below, how far the times found "
      "by the event search are from the closed form.";
  figure.parameters.add_number("height", 1.0, 0.01, 100.0, "m", "free height at the start")
      .add_number("restitution", 0.5, 0.05, 0.95, "-", "rebound speed over impact speed")
      .add_number("threshold", 0.01, 1e-4, 1.0, "m/s", "rebound speed at which bodies stick")
      .add_number("resolution", 1e-9, 1e-12, 1e-3, "s", "how closely impact times are found");
  figure.quick = {"threshold=0.1"};
  figure.experiment = measure_zeno;
  return figure;
}

Figure cradle_figure() {
  Figure figure;
  figure.name = "cradle";
  figure.section = "3.3";
  figure.title = "Newton's cradle: all impulses at once, or one after the other";
  figure.caption =
      "One box hits a row of four that touch, without loss (restitution 1). Resolved one "
      "contact after the other, the speed passes through the row and only the last box "
      "leaves, as in the toy. Resolved all at once, with Newton's law at every contact, the "
      "whole row leaves at 2/5 of the speed and the first box is thrown back. Both readings "
      "keep momentum and energy, as the sums show: they do not agree, and the law of restitution "
      "does not say which one is right.";
  figure.parameters.add_whole("boxes", 5, 2, 12, "how many boxes in the row")
      .add_whole("moving", 1, 1, 11, "how many of them move at first")
      .add_number("restitution", 1.0, 0.0, 1.0, "-", "rebound speed over impact speed");
  figure.quick = {"boxes=3"};
  figure.experiment = measure_cradle;
  return figure;
}

Figure stack_convergence_figure() {
  Figure figure;
  figure.name = "stack_convergence";
  figure.section = "2.5.2, 3.3.2";
  figure.title =
      "One contact at a time: the passes that a stack needs grow with its height squared";
  figure.caption =
      "A stack of n boxes meets what carries it, without rebound. Contacts are resolved one "
      "after the other, from the bottom up, again and again, as impulse techniques do. Each "
      "pass leaves cos²(π/2n) of the speed, so that the passes to one millionth grow like n²: "
      "the counted ones lie on the line of the closed form. The usual ten passes are too few "
      "even for two boxes at this accuracy and leave 39 % of the speed of five. Below, the "
      "measured share of the last pass against the closed form; marks at the bottom agree to "
      "the last bit.";
  figure.parameters.add_whole("most", 20, 2, 40, "boxes in the highest stack")
      .add_number("accuracy", 1e-6, 1e-12, 0.1, "-", "error to reach, over the error at first");
  figure.quick = {"most=6"};
  figure.experiment = measure_stack_convergence;
  return figure;
}

Figure box_overlap_figure() {
  Figure figure;
  figure.name = "box_overlap";
  figure.section = "3.2";
  figure.title = "The area in which a turned cube touches the one below";
  figure.caption =
      "A cube stands on another one, turned about the vertical. Above, their faces (blue: "
      "lower, orange: upper) and the contact area (filled): a square when they are aligned, "
      "an octagon otherwise. In the middle its area, from the contact points that the library "
      "finds, on the closed form 2/(1 + sin θ + cos θ). Below, the difference: one part in "
      "10¹², by which faces are widened before they are clipped so that edges that lie on "
      "each other do not miss each other. Marks at the bottom agree to the last bit.";
  figure.parameters.add_number("size", 1.0, 0.001, 1000.0, "m", "edge length of both cubes")
      .add_whole("steps", 90, 6, 900, "angles from 0 to 90 degrees, a multiple of 6");
  figure.quick = {"steps=12"};
  figure.experiment = measure_box_overlap;
  return figure;
}

}  // namespace

std::vector<Figure> basic_colliding_figures() {
  std::vector<Figure> list = {
      rotation_rules_figure(), rotation_order_figure(),    free_fall_figure(),  zeno_figure(),
      cradle_figure(),         stack_convergence_figure(), box_overlap_figure()};
  add_response_figures(list);
  add_detection_figures(list);
  add_picture_figures(list);
  return list;
}

}  // namespace tumble::chapters
