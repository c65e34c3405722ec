/// \file
/// \brief The figure on filters that run live.
#include "filtering/live_experiments.hpp"

namespace tumble::chapters {

std::vector<Figure> live_figures() {
  Figure figure;
  figure.name = "claim_5_5e_live";
  figure.section = "5.5";
  figure.title = "What does a filter show while a run is computed, and how late?";
  figure.caption =
      "Filtered live or afterwards, frames are the same to the bit. What differs is when they are "
      "seen. Top: a cube lands. A mean around a frame has to wait for two later ones, and its cube "
      "hits "
      "the ground late. Taking only earlier frames is no way out: the same poses come at the same "
      "time. Envelopes show an impact at once; they leave the cube within an envelope of where it "
      "is. "
      "Middle: where bodies creep, envelopes are the later ones. Bottom: frames of waiting and "
      "delay.";
  figure.parameters
      .add_whole("cubes", 5, 1, 6, "along each edge of the clump that is filtered live")
      .add_number("duration", 12.0, 0.5, 60.0, "s", "of each run that is filtered live")
      .add_whole("pieces", 5, 1, 100, "ways to cut each run into pieces")
      .add_number("height", 1.0, 0.01, 100.0, "m", "from which the cube falls")
      .add_number("creep", 0.08, 0.001, 0.5, "m/s", "speed of the body that creeps")
      .add_number("fast", 3.0, 0.7, 100.0, "m/s", "speed of the body that is fast")
      .add_number("near", 0.01, 1e-4, 0.1, "m", "from its place at rest a cube has landed");
  figure.quick = {"cubes=2", "duration=1", "pieces=2"};
  figure.experiment = measure_live;
  return {figure};
}

}  // namespace tumble::chapters
