/// \file
/// \brief The figures of time stepping.
#include "analytic_lcp/experiments.hpp"
#include "analytic_lcp/time_stepping_experiments.hpp"

namespace tumble::chapters {
namespace {

Figure no_events_figure() {
  Figure figure;
  figure.name = "claim_2_6_3a_no_events";
  figure.section = "2.6.3";
  figure.title = "A projectile hits a stack, and no step knows of an event";
  figure.caption =
      "A cube of half a metre flies at 12 m/s into four cubes on top of each other. Every step "
      "of 1/60 s is one problem for impulses, impacts and resting contact alike. Top: the "
      "deepest overlap found in a step, over the small cube's edge; the line is 1 %. Bottom: "
      "the error of the velocities, over the fastest; the line is what is accepted. Steps "
      "without any error are at the lower edge. Drawn is the first of ten shots, which has two of "
      "the three steps above the line.";
  figure.parameters.add_whole("cubes", 4, 2, 10, "in the stack")
      .add_number("duration", 3.0, 0.1, 60.0, "s", "of each run")
      .add_whole("shots", 10, 1, 1000, "the first one is drawn, the others are random");
  figure.quick = {"duration=1", "shots=2", "cubes=3"};
  figure.experiment = measure_no_events;
  return figure;
}

Figure always_solved_figure() {
  Figure figure;
  figure.name = "claim_2_6_3b_always_solved";
  figure.section = "2.6.3";
  figure.title = "Anitescu and Potra's form: how well random problems are solved";
  figure.caption =
      "5000 problems of random points between random boxes, 5000 of three cubes, one on top of "
      "two, "
      "with four points to a face and turned by a millionth, and 1088 of Painlevé's rod, for "
      "angles from 5 to 85 degrees, friction from 0 to 3 and four angular velocities; for many "
      "of these no force exists. Shown is how the errors of the answers are distributed, as a "
      "share of the fastest speed. The theorem speaks of exact numbers; in ours the retries of "
      "the solver were chosen on seed 1, so that seed 2 decides. It leaves 2 of the 5000 "
      "problems of cubes without an answer.";
  figure.parameters.add_whole("problems", 10000, 2, 1000000, "random ones, half of each kind")
      .add_whole("seed", 2, 0, 1000000000, "of the random problems");
  figure.quick = {"problems=400"};
  figure.experiment = measure_always_solved;
  return figure;
}

}  // namespace

void add_time_stepping_figures(std::vector<Figure>& list) {
  list.push_back(no_events_figure());
  list.push_back(always_solved_figure());
}

}  // namespace tumble::chapters
