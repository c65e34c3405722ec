/// \file
/// \brief The figures of what rests: tosses, faces, sleeping, work of a step, size.
#include "impulse_damped/rest_experiments.hpp"
#include "impulse_damped/scale_experiments.hpp"
#include "impulse_damped/toss_experiments.hpp"

namespace tumble::chapters {
namespace {

Figure tosses_figure() {
  Figure figure;
  figure.name = "claim_2_4_2a_tosses";
  figure.section = "2.4.2, 4.2";
  figure.title = "Tossed cubes with and without chance, and measured ones";
  figure.caption =
      "Cubes are tossed onto a table as twenty real ones were (ContactNets, CoRL 2020); their "
      "starts are drawn from the same ranges. Curves: share of the tosses that get no farther, and "
      "that rest no later. Dots: quartiles of the measured tosses. Times are whole frames of 1/60 "
      "s.";
  figure.parameters.add_whole("tosses", 40, 2, 10000, "for each seed")
      .add_whole("seeds", 20, 2, 1000, "groups of tosses");
  figure.quick = {"tosses=4", "seeds=3"};
  figure.experiment = measure_tosses;
  return figure;
}

Figure faces_figure() {
  Figure figure;
  figure.name = "claim_3_1a_faces";
  figure.section = "3.1";
  figure.title = "How boxes lie that flew together and settled";
  figure.caption =
      "Cubes fly together as in figure 6.7, fall and settle: 8, 27 and 64 of them, twenty clumps "
      "each. Share of the boxes against the tilt of the face that is nearest to level. Left of the "
      "dashed line a face counts as down. What is not down leans on a neighbour.";
  figure.parameters.add_whole("smallest", 2, 1, 10, "cubes along each edge of the smallest grid")
      .add_whole("largest", 4, 1, 10, "cubes along each edge of the largest grid")
      .add_number("duration", 7.0, 0.1, 100.0, "s", "until they have settled")
      .add_whole("seeds", 20, 2, 1000, "clumps of each size");
  figure.quick = {"largest=2", "seeds=3", "duration=5"};
  figure.experiment = measure_faces;
  return figure;
}

Figure sleeping_figure() {
  Figure figure;
  figure.name = "claim_4_5a_sleeping";
  figure.section = "4.5";
  figure.title = "Work of a step against how many boxes move; who wakes if a support goes";
  figure.caption =
      "Stacks of cubes stand side by side and sleep. Some of them are pushed and slide. Above: "
      "pair tests, impulses and integrations of a step, a mean over a quarter of a second. Below: "
      "two stacks sleep, a box of one is taken away, and boxes are counted that are awake. The "
      "other stack sleeps on.";
  figure.parameters.add_whole("stacks", 20, 10, 1000, "side by side; tens are best")
      .add_whole("boxes", 5, 2, 50, "in each stack")
      .add_number("speed", 2.0, 0.0, 10.0, "m/s", "of the boxes that are pushed");
  figure.quick = {"stacks=10", "boxes=3"};
  figure.experiment = measure_sleeping;
  return figure;
}

Figure frame_rate_figure() {
  Figure figure;
  figure.name = "claim_6_1a_frame_rate";
  figure.section = "6.1";
  figure.title = "How much there is to do in a step of the clump and of the pyramid";
  figure.caption =
      "Means over ten seconds of the clump of figure 6.7 and of a pyramid at rest, against the "
      "number of boxes. Damped integration tests a pair again in each of its passes; "
      "contact_damped keeps the contact areas of boxes that rest. Counts are the same on every "
      "machine. Times are not, and nothing is drawn from them.";
  figure.parameters.add_whole("per_edge", 5, 2, 10, "cubes along each edge of the largest clump")
      .add_whole("rows", 10, 4, 30, "of the largest pyramid")
      .add_number("duration", 10.0, 0.1, 100.0, "s", "of each run");
  figure.quick = {"per_edge=2", "rows=4", "duration=2"};
  figure.experiment = measure_frame_work;
  return figure;
}

Figure size_figure() {
  Figure figure;
  figure.name = "claim_6_3_1a_size";
  figure.section = "6.3.1";
  figure.title = "The same motion at 0.01, 1 and 100 times the size";
  figure.caption =
      "Lengths times 0.01 and 100, masses times the cube of it, times and the step times its root. "
      "Above: the way of a box that slides at 3 m/s on friction 0.3. Below: the largest distance "
      "of a corner from where it is at size 1, over that scene, a crate that slides off a table "
      "and a pushed stack.";
  figure.parameters.add_number("duration", 3.0, 1.5, 60.0, "s", "of each run, at size 1");
  figure.quick = {"duration=1.5"};
  figure.experiment = measure_size;
  return figure;
}

}  // namespace

void add_rest_figures(std::vector<Figure>& list) {
  list.push_back(tosses_figure());
  list.push_back(faces_figure());
  list.push_back(sleeping_figure());
  list.push_back(frame_rate_figure());
  list.push_back(size_figure());
}

}  // namespace tumble::chapters
