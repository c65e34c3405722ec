/// \file
/// \brief The figures of the claims on solvers.
#include "analytic_lcp/experiments.hpp"
#include "analytic_lcp/solver_experiments.hpp"

namespace tumble::chapters {
namespace {

Figure least_constraint_figure() {
  Figure figure;
  figure.name = "claim_2_6_2a_least_constraint";
  figure.section = "2.6.2";
  figure.title =
      "Least constraint takes less work from twelve contacts a box on, in a chain of ten";
  figure.caption =
      "Boxes in a chain, each touching the one before in points anywhere and in any direction; "
      "counted are multiplications, the mean of twenty chains. Contact forces (full lines) "
      "have an unknown for each contact, least constraint (dashed) six for each box. With ten "
      "boxes the lines cross at 12 contacts a box, with four at 13, with one they do not up to "
      "24. Least constraint levels off: it never uses more contacts than there are degrees of "
      "freedom. Where the matrix of contact forces does not hold enough digits, the problem is "
      "solved again from its factors, by least constraint; that is counted as work of contact "
      "forces, and with ten boxes it is part of the last stretch. Setting up the matrix is not "
      "counted.";
  figure.parameters.add_whole("most", 24, 8, 64, "contacts on a box with the one before, at most")
      .add_whole("seeds", 20, 2, 1000, "random chains for each number of contacts");
  figure.quick = {"most=16", "seeds=3"};
  figure.experiment = measure_least_constraint;
  return figure;
}

Figure tolerance_figure() {
  Figure figure;
  figure.name = "claim_3_3_1a_tolerance";
  figure.section = "3.3.1";
  figure.title = "A tolerance ends more loops, and it need only be above rounding";
  figure.caption =
      "How the loop of the thesis's program ends, for tolerances from 0 (at the left edge) to "
      "1e-3 m/s². Above, stacks of one to four cubes on four corners each, pushed about: with "
      "a tolerance of 0 the loop ends in 71 of 100 problems, with the thesis's 1e-5 (dotted) "
      "in 77, and 1e-15 does as well. Below, contacts anywhere, every third given twice: 86 "
      "and 99 of 100, and from 1e-10 on nothing is gained. So the tolerance has to be above "
      "rounding and no more. The stacks that are left are left with any tolerance; all of them "
      "have a solution.";
  figure.parameters.add_whole("problems", 2000, 100, 100000, "random problems of each kind");
  figure.quick = {"problems=300"};
  figure.experiment = measure_tolerance;
  return figure;
}

Figure negative_forces_figure() {
  Figure figure;
  figure.name = "claim_3_3_1b_negative_forces";
  figure.section = "3.3.1";
  figure.title = "Bodies do sink into each other, but not because of negative forces";
  figure.caption =
      "A stack of three cubes rests on four corners to a joint, its loads going round slowly; "
      "forces by the thesis's program at every step, nothing repaired. The stack does sink, "
      "but whether negative forces are left (line) or set to zero (marks) makes no difference "
      "in any digit: they are below 1e-15 N. What sinks it are a few kicks: in 13 of 36000 "
      "steps the loop ends with an answer that is wrong by up to 90 m/s². Between kicks it "
      "creeps; the exponent of 2.7 is that of the kicks adding up. In one step of eight the "
      "loop does not end at all, and the library's solver stands in; used throughout (green) "
      "it holds the stack to rounding. One cube instead of three does not sink at all, with "
      "negative forces left. A load of 0.9 of the tolerance (orange) is held only in part and "
      "sinks with the square of time, 1 m in ten minutes, without a negative force; with a "
      "tolerance relative to the load it rests.";
  figure.parameters.add_number("duration", 600.0, 10.0, 36000.0, "s", "length of the runs")
      .add_whole("cubes", 3, 1, 20, "in the stack");
  figure.quick = {"duration=60"};
  figure.experiment = measure_negative_forces;
  return figure;
}

Figure friction_cost_figure() {
  Figure figure;
  figure.name = "claim_5_3d_friction_cost";
  figure.section = "5.3";
  figure.title = "A pivot with friction takes 81 times the work of one without";
  figure.caption =
      "A stack of cubes on four corners to a joint that has just been pushed. Above, "
      "multiplications for each pivot: without friction and with factors that are updated "
      "(blue), with friction in four directions and with new factors at each pivot (orange), "
      "and what new factors take without friction (green). At 64 contacts friction takes 81 "
      "times as much. Below, unknowns (lines) and entries of the matrix that are not zero "
      "(marks): six times as many and 23 times as many. New factors alone would be a factor of "
      "2.5.";
  figure.parameters.add_number("friction", 0.5, 0.01, 2.0, "-", "coefficient")
      .add_whole("seeds", 20, 2, 100, "random velocities");
  figure.quick = {"seeds=2"};
  figure.experiment = measure_friction_cost;
  return figure;
}

}  // namespace

void add_solver_figures(std::vector<Figure>& list) {
  list.push_back(least_constraint_figure());
  list.push_back(tolerance_figure());
  list.push_back(negative_forces_figure());
  list.push_back(friction_cost_figure());
}

}  // namespace tumble::chapters
