/// \file
/// \brief The figures of impulses without damping.
#include "impulse_damped/impulse_figures.hpp"

#include "impulse_damped/chatter_experiments.hpp"
#include "impulse_damped/repair_experiments.hpp"

namespace tumble::chapters {
namespace {

Figure oscillation_figure() {
  Figure figure;
  figure.name = "claim_3_3_2a_oscillation";
  figure.section = "3.3.2";
  figure.title = "Without damping a stack chatters: by how much, and why";
  figure.caption =
      "Five cubes of restitution 0.9 stand on each other, up to 2 cm aside of each other and "
      "turned by up to 3 degrees. They are held up by impulses as the thesis has them, without "
      "its damping. Shown is the amplitude of their chatter against the time step, for three "
      "ways to choose the contact normal; the line is at 1/60 s. Upper row: overlap is ended by "
      "pushes of a millimetre, and chatter does not get below some millimetres. Lower row: "
      "velocities are stopped from the ground up, and chatter goes with the square of the step "
      "if the thesis's normal is used at the whole contact area. Marks at the upper edge: no box "
      "rests, the stack comes apart. True normals do not help.";
  figure.parameters.add_whole("boxes", 5, 1, 50, "in the stack")
      .add_number("restitution", 0.9, 0.0, 1.0, "-", "of boxes and ground: the thesis's")
      .add_number("aside", 0.02, 0.0, 0.4, "m", "by how much a box is moved aside, at most")
      .add_number("turn", 0.05, 0.0, 0.7, "rad", "by how much it is turned, at most")
      .add_number("duration", 2.0, 1.0, 60.0, "s", "of each run")
      .add_whole("finest", 480, 60, 3840, "steps a second; others are halves of it")
      .add_whole("seeds", 2, 1, 1000, "stacks for each point that is drawn")
      .add_whole("many", 20, 2, 1000, "stacks for the numbers");
  figure.quick = {"seeds=1", "many=2", "duration=1", "finest=240"};
  figure.experiment = measure_oscillation;
  return figure;
}

Figure push_energy_figure() {
  Figure figure;
  figure.name = "claim_4_4a_push_energy";
  figure.section = "4.4";
  figure.title = "Pushes out of overlap: the energy that they add, and what becomes of it";
  figure.caption =
      "Five cubes at rest overlap by up to what gravity moves in a step. A pass over them pushes "
      "the upper of two up by a millimetre until they are apart. Top: energies of one stack in "
      "the steps after it. The pass itself adds potential energy only. What appears as kinetic "
      "energy comes from the gaps that whole pushes leave: the boxes fall into them for a step, "
      "until they are told to be stable. Our repair leaves none, and overlap below a millimetre "
      "as it is. If velocities are stopped from the ground up and nothing is moved, both "
      "energies stay at 0, and so does the overlap. Bottom: the share that becomes kinetic, "
      "against the depth.";
  figure.parameters.add_whole("boxes", 5, 1, 50, "in the stack")
      .add_number("restitution", 0.9, 0.0, 1.0, "-", "of boxes and ground: the thesis's")
      .add_number("depth", 9.81 / 3600, 1e-6, 0.5, "m",
                  "largest overlap of two cubes; the default is what gravity moves in a step, g h²")
      .add_whole("seeds", 20, 2, 1000, "stacks");
  figure.quick = {"seeds=3"};
  figure.experiment = measure_push_energy;
  return figure;
}

Figure overlap_left_figure() {
  Figure figure;
  figure.name = "claim_4_4b_overlap_left";
  figure.section = "4.4";
  figure.title = "How much overlap is left for the pushes";
  figure.caption =
      "27 cubes of restitution 0.9 fly together, fall and settle; means over twenty heaps. Sums "
      "over all pairs in a step: the overlap that the bodies would have at its end if no impulse "
      "had acted, the overlap that the pass finds, and the overlap that it leaves. 0 is not "
      "drawn. Impulses leave the pass a few per cent in the fall and less than one at rest, with "
      "damping and without.";
  figure.parameters.add_whole("per_edge", 3, 1, 20, "cubes along each edge of the heap's grid")
      .add_number("restitution", 0.9, 0.0, 1.0, "-", "of cubes and ground: the thesis's")
      .add_number("duration", 5.0, 0.2, 600.0, "s", "of each run")
      .add_whole("seeds", 20, 2, 1000, "heaps");
  figure.quick = {"seeds=2", "duration=2"};
  figure.experiment = measure_overlap_left;
  return figure;
}

}  // namespace

void add_impulse_figures(std::vector<Figure>& list) {
  list.push_back(oscillation_figure());
  list.push_back(push_energy_figure());
  list.push_back(overlap_left_figure());
}

}  // namespace tumble::chapters
