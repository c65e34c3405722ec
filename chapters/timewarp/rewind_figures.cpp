/// \file
/// \brief The figures on what taking back costs, and what waiting for one another costs.
#include "timewarp/rewind_experiments.hpp"

namespace tumble::chapters {
namespace {

Parameters cage_settings() {
  Parameters p;
  p.add_whole("seeds", 20, 2, 1000, "cages of each kind")
      .add_number("speed", 2.0, 0.01, 100.0, "m/s", "largest component of a velocity at the start")
      .add_number("spin", 2.0, 0.0, 100.0, "rad/s",
                  "largest component of an angular velocity at the start")
      .add_whole("lead", 30, 0, 10000, "frames of 1/60 s before work is counted");
  return p;
}

Figure rewinding_figure() {
  Figure figure;
  figure.name = "claim_2_4_3a_rewinding";
  figure.section = "2.4.3";
  figure.title = "Is it cheaper to take back only the bodies near a collision?";
  figure.caption =
      "Cubes in cages of one density, without gravity and loss, frames of 1/60 s. Above, "
      "integrations for a collision: all taken back, they grow with the number of bodies; of those "
      "near it four are enough, and the rest is the flight that every body has in every frame "
      "(thin line). Full timewarp flies eight frames at a time. In the middle, pair tests. Below, "
      "512 "
      "cubes faster and slower, and what counting gives (line): the fewer collisions a frame has, "
      "the less "
      "there is to be saved.";
  figure.parameters = cage_settings();
  figure.parameters.add_whole("frames", 2, 1, 100,
                              "in which the work of 512 bodies is counted; of fewer bodies, more");
  figure.quick = {"seeds=2", "lead=20"};
  figure.experiment = measure_rewinding;
  return figure;
}

Figure synchronising_figure() {
  Figure figure;
  figure.name = "claim_2_4_3b_synchronising";
  figure.section = "2.4.3";
  figure.title = "What full timewarp loses if all bodies wait for one another on every frame";
  figure.caption =
      "The cages of 512 and 64 cubes. Above, integrations in a simulated second: full timewarp "
      "synchronised on every 1, 2, 4, 8 frames, and never; flat lines, all taken back. To wait on "
      "every frame costs several times as much as never to wait, and is little beside what is "
      "saved. Below, the share of the saving that it loses, at several speeds: it falls with the "
      "number of collisions in a frame as 1/(1 + collisions).";
  figure.parameters = cage_settings();
  figure.parameters.add_whole("larger", 512, 8, 1000, "cubes in the larger cage")
      .add_whole("smaller", 64, 8, 1000, "cubes in the smaller cage")
      .add_whole(
          "flights", 4, 1, 100,
          "of 8 frames each, in which the work of the smaller cage is counted; of the larger "
          "one it is counted in one");
  figure.quick = {"seeds=4", "lead=20", "larger=64", "smaller=27"};
  figure.experiment = measure_synchronising;
  return figure;
}

Figure stride_figure() {
  Figure figure;
  figure.name = "timewarp_stride";
  figure.section = "2.4.3";
  figure.title = "How far ahead full timewarp should fly";
  figure.caption =
      "Full timewarp, never synchronised, in a cage of 64 cubes: integrations, pair tests and "
      "bodies taken back for each collision, against the length of a flight. Longer flights are "
      "fewer, so integrations fall to less than three. But the farther bodies fly ahead the more "
      "of it is thrown away: pair tests are fewest at about the time that passes between two "
      "collisions of a body (dashed). Bars: 95 per cent over 20 cages.";
  figure.parameters = cage_settings();
  figure.parameters.add_whole("count", 64, 8, 1000, "cubes in the cage")
      .add_whole("frames", 32, 1, 1000,
                 "in which work is counted, or one flight if that is longer");
  figure.quick = {"seeds=2", "count=27", "lead=20", "frames=8"};
  figure.experiment = measure_stride;
  return figure;
}

}  // namespace

std::vector<Figure> rewind_figures() {
  return {rewinding_figure(), synchronising_figure(), stride_figure()};
}

}  // namespace tumble::chapters
