/// \file
/// \brief The figures on orders, work and forces of the glued column.
#include "exterior_rotation/order_figures.hpp"

#include "exterior_rotation/order_experiments.hpp"

namespace tumble::chapters {
namespace {

void add_fall(Figure& figure, double time) {
  figure.parameters
      .add_number("phi0", 0.3, 0.01, 0.5, "rad",
                  "of the column's centre at the start, from the vertical")
      .add_number("time", time, 0.1, 3.0, "s", "that it falls");
}

Figure order_figure() {
  Figure figure;
  figure.name = "claim_6_2b_order";
  figure.section = "6.2";
  figure.title = "Do Runge and Kutta's methods follow a group that turns?";
  figure.caption =
      "The glued column of figure 6.1 in a second of its fall, against the step: error of its "
      "angle, and largest gap or overlap of neighbours. Orders are fitted to the four shortest "
      "steps before rounding takes over. Simple schemes have order 1, midpoint and leapfrog 2, "
      "Runge and Kutta's classical method 4: at 1/60 s its gap is a millionth of theirs. Below, "
      "gap over step of the first three; circles are what leading-order integrals say it tends to.";
  add_fall(figure, 1.0);
  figure.parameters.add_whole("doublings", 9, 4, 12, "of 5 steps in the whole fall")
      .add_number("floor", 2e-13, 1e-14, 1e-6, "m or rad", "errors below it are not fitted");
  figure.quick = {"doublings=6"};
  figure.experiment = measure_glued_order;
  return figure;
}

Figure one_step_figure() {
  Figure figure;
  figure.name = "one_step_gap";
  figure.section = "6.2";
  figure.title = "What gap does one step leave?";
  figure.caption =
      "One step of the glued column, from an exact state in which it turns at 2 rad/s. Above, the "
      "gap over half of the square of the angle turned, times a metre: what a tangent leaves of "
      "its arc. Forward Euler and impulses open the column by that, semi-implicit Euler overlaps "
      "its cubes by as much. Below, magnitudes. Midpoint and leapfrog err in the third power of "
      "the step, Runge and Kutta's method in the fifth, each one above its order.";
  figure.parameters.add_number("angle", 0.6, 0.0, 1.0, "rad", "of the column's centre")
      .add_number("spin", 2.0, 0.1, 10.0, "rad/s", "falling")
      .add_whole("doublings", 5, 1, 10, "of 60 steps a second");
  figure.quick = {"doublings=2"};
  figure.experiment = measure_one_step_gap;
  return figure;
}

Figure work_figure() {
  Figure figure;
  figure.name = "rotation_work";
  figure.section = "6.2";
  figure.title = "What does accuracy cost in force solves?";
  figure.caption =
      "A second of the glued column's fall: errors against the number of systems of joint forces "
      "that were solved. Above, the angle; middle, the gap; below, the angle where bodies are "
      "moved by exponentials. At as many solves Runge and Kutta's method is far nearer than all "
      "simple schemes, and Dormand and Prince's nearer still below a millionth. Exponentials leave "
      "no gap but for rounding, yet the angle is as wrong as without them.";
  add_fall(figure, 1.0);
  figure.parameters.add_whole("doublings", 7, 2, 10, "of 10 steps in the whole fall");
  figure.quick = {"doublings=4"};
  figure.experiment = measure_rotation_work;
  return figure;
}

Figure steps_figure() {
  Figure figure;
  figure.name = "claim_6_2e_steps";
  figure.section = "6.2";
  figure.title = "How small must steps be to hide the gap?";
  figure.caption =
      "Steps, and force solves, a second that keep the gap in figure 6.1's column below a tenth of "
      "a millimetre during a second of its fall. Simple schemes take fifty times the usual 60 "
      "steps or more; midpoint less than twice as many, leapfrog about half, Runge and Kutta's "
      "method a tenth. Bodies that are moved by exponentials keep together at any step, even one "
      "of a second. That says nothing of where they are: see the figure on work.";
  add_fall(figure, 1.0);
  figure.parameters.add_number("gap", 1e-4, 1e-7, 1e-2, "m", "that is allowed");
  figure.quick = {"gap=1e-3"};
  figure.experiment = measure_steps_for_gap;
  return figure;
}

Figure pivot_figure() {
  Figure figure;
  figure.name = "pivot_forces";
  figure.section = "6.2";
  figure.title = "What holds the falling column at its pivot?";
  figure.caption =
      "Force of the larger box on the glued column, over its weight; the coefficient of friction "
      "that holds it; errors at 60 steps a second. Right of the dashed line the glue has to pull "
      "somewhere. Near 71 degrees the column hardly presses, and friction above 30 would have to "
      "hold its edge. Runge and Kutta's forces are right to 1e-7; semi-implicit Euler's are off by "
      "up to 3 %, as its column is ahead of the true one.";
  add_fall(figure, 1.25);
  figure.parameters.add_number("rate", 60.0, 10.0, 1000.0, "1/s", "steps a second");
  figure.quick = {"time=0.5"};
  figure.experiment = measure_pivot_forces;
  return figure;
}

Figure swing_figure() {
  Figure figure;
  figure.name = "swing_periods";
  figure.section = "6.2";
  figure.title = "Does a box on an edge swing in the right time?";
  figure.caption =
      "Two boxes hang on an edge each, held by a joint, and swing about it. Above, the period "
      "against how far they swing to each side, simulated by Dormand and Prince's method with "
      "forces at each stage, on the closed form; below, the error over the period, never above "
      "1e-13. Errors of 0 are drawn at 1e-16.";
  figure.parameters.add_number("accuracy", 1e-14, 1e-14, 1e-3, "-",
                               "error that is allowed in a step");
  figure.quick = {"accuracy=1e-10"};
  figure.experiment = measure_swing_periods;
  return figure;
}

}  // namespace

std::vector<Figure> integration_order_figures() {
  return {order_figure(), one_step_figure(), work_figure(),
          steps_figure(), pivot_figure(),    swing_figure()};
}

}  // namespace tumble::chapters
