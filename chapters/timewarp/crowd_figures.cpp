/// \file
/// \brief The figure on crowded frames.
#include "timewarp/crowd_experiments.hpp"

namespace tumble::chapters {

std::vector<Figure> crowd_figures() {
  Figure figure;
  figure.name = "claim_5_1a_order";
  figure.section = "5.1";
  figure.title = "How often is a crowded frame told wrong?";
  figure.caption =
      "Single frames of 27 cubes in a cage with 1.8 or 2 edges of room each, from fresh random "
      "states, against a search over all bodies that misses nothing. Above, frames with an "
      "event missed or out of order; middle, such events. Safer finds most of what simple "
      "misses, but hardly a frame more is right. Swept is right until, at 8 edges, billionths "
      "of a second decide. On a line simple is exact up to 2 edges; in the cage it misses "
      "brief overlaps long before.";
  figure.parameters.add_whole("seeds", 24, 2, 1000, "cages")
      .add_whole("frames", 3, 1, 1000, "fresh states of each cage, at each speed")
      .add_whole("cubes", 27, 2, 1000, "in a cage")
      .add_whole("chains", 400, 1, 100000, "on a line, at each speed")
      .add_whole("checked", 12, 1, 1000, "cages in which the two references are compared")
      .add_whole("finest", 1024, 64, 1024, "steps in a frame of the other reference")
      .add_number("resolution", 1e-9, 1e-12, 1e-3, "s", "of every search for collisions");
  figure.quick = {"seeds=4", "frames=2", "chains=60", "finest=64"};
  figure.experiment = measure_crowd_order;
  return {figure};
}

}  // namespace tumble::chapters
