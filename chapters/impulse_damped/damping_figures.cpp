/// \file
/// \brief The figures of claims 4.2a, 5.3a, 5.3b and 5.3e.
#include "impulse_damped/alignment_experiments.hpp"
#include "impulse_damped/chance_experiments.hpp"
#include "impulse_damped/damping_experiments.hpp"

namespace tumble::chapters {
namespace {

Figure energy_figure() {
  Figure figure;
  figure.name = "claim_5_3a_energy";
  figure.section = "5.3";
  figure.title =
      "Whether the damping ever adds energy: each stage, bricks of several lengths, and heaps";
  figure.caption =
      "Above, the largest factor by which a stage raises the kinetic energy of a box, over random "
      "states: of cubes none does; of bricks turning upright does by a thousandth and the scaling "
      "of slow components by 7 %. A component of the angular momentum that is scaled by itself "
      "turns the spin towards an axis about which it has more energy. Middle: that stage for "
      "longer "
      "bricks, beside the closed forms for a component that is shrunk by k7 and for one that is "
      "ended. Below, energy in one heap of 27: what damping has taken, and what pushes out of "
      "overlap have added. They add a tenth of it or more, and no stage of the damping knows of "
      "it.";
  figure.parameters.add_whole("states", 5000, 10, 10000000, "random states of each seed and stage")
      .add_whole("seeds", 20, 2, 1000, "streams of random states, and heaps")
      .add_whole("longest", 8, 1, 100, "length of the longest brick, over its other edges")
      .add_number("duration", 3.0, 0.1, 60.0, "s", "of the heaps");
  figure.quick = {"states=2000", "seeds=2", "longest=4", "duration=1.5"};
  figure.experiment = measure_damping_energy;
  return figure;
}

Figure ablation_figure() {
  Figure figure;
  figure.name = "claim_5_3b_ablation";
  figure.section = "5.3";
  figure.title = "What each part of the damping does against chatter, and for the time to rest";
  figure.caption =
      "Heaps of 27 cubes, three seconds after they began to fly together. Left, the share of the "
      "boxes that are at rest but shake by more than a tenth of free fall; right, the mean time "
      "until a box last moved, no later than the end of the run. Scaling alone leaves three boxes "
      "of four shaking; the alignment tests take a quarter of the boxes away from it, the test of "
      "slow components more. Of the alignment tests, turning upright is what helps. With other "
      "constants the gain from alignment is between none and half of the boxes. To undo small "
      "moves changes nothing here: what is slow has been stopped before.";
  figure.parameters.add_whole("per_edge", 3, 2, 10, "cubes along each edge of the grid")
      .add_number("duration", 3.0, 1.0, 60.0, "s", "of each run")
      .add_whole("seeds", 20, 2, 1000, "heaps");
  figure.quick = {"per_edge=2", "duration=2", "seeds=3"};
  figure.experiment = measure_ablation;
  return figure;
}

Figure leaning_figure() {
  Figure figure;
  figure.name = "claim_5_3e_leaning";
  figure.section = "5.3";
  figure.title =
      "The alignment test catches every chattering box that lies flat, and none that leans";
  figure.caption =
      "Each mark is a box that chatters when velocities are only scaled: boxes of heaps, planks "
      "that lean on blocks, and those blocks. Across, how far it is tilted from a level face; "
      "upwards, how much it shakes. The line is the test's tolerance of two degrees. Boxes that "
      "lie on a face are left of it by far, planks that lean are right of it by far: no tolerance "
      "between half a degree and twenty would change what is caught.";
  figure.parameters.add_whole("per_edge", 3, 2, 10, "cubes along each edge of the grid")
      .add_number("duration", 3.0, 1.0, 60.0, "s", "of each run")
      .add_whole("seeds", 20, 2, 1000, "heaps, and sets of planks");
  figure.quick = {"per_edge=2", "duration=2", "seeds=3"};
  figure.experiment = measure_leaning;
  return figure;
}

Figure chance_figure() {
  Figure figure;
  figure.name = "claim_4_2a_chance";
  figure.section = "4.2";
  figure.title = "Chance in slow collisions makes dice rest three hundredths later";
  figure.caption =
      "Five dice thrown forty times. Above, the mean time until they rest with chance in no "
      "collision, in those faster than half of sqrt(g L), in the slower ones, and in all; with all "
      "of the damping, and with the scaling of velocities only. Below, the lowest corner of one "
      "die of the first throw: one more hop. Chance cannot keep them jumping here: an impulse "
      "along a varied normal never adds energy, and contact, which ends each step, takes what it "
      "leaves.";
  figure.parameters.add_number("duration", 6.0, 1.0, 60.0, "s", "of each run")
      .add_whole("seeds", 40, 2, 1000, "throws");
  figure.quick = {"duration=2.5", "seeds=2"};
  figure.experiment = measure_chance;
  return figure;
}

}  // namespace

void add_damping_figures(std::vector<Figure>& list) {
  list.push_back(energy_figure());
  list.push_back(ablation_figure());
  list.push_back(leaning_figure());
  list.push_back(chance_figure());
}

}  // namespace tumble::chapters
