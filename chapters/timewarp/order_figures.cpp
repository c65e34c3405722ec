/// \file
/// \brief The figures on the order of collisions: figure 5.1, and the queue at work.
#include "timewarp/order_figures.hpp"

#include "tumble/scenes/library.hpp"

#include "timewarp/order_experiments.hpp"

namespace tumble::chapters {
namespace {

Figure five_figure() {
  Figure figure;
  figure.name = "fig5_1_order";
  figure.section = "5.1";
  figure.title = "Figure 5.1: five cubes on a line, and who meets whom first";
  figure.caption =
      "The layout is reconstructed from the caption: A is fast and first seen to meet C only; D is "
      "slow and seen to meet E (C is printed). Dashed: the frame's end without collisions. "
      "Below, each cube is a band; numbers count collisions as they were resolved, red squares are "
      "out of place, hatched two cubes overlap. Simple and safer let A pass through B and tell the "
      "same wrong story. Swept volumes tell that of the reference, a search over all bodies in "
      "steps of a thousandth of a frame.";
  figure.parameters = scene_recipe("fig5_1").parameters();
  figure.parameters.add_number("frame", 1.0 / 60.0, 1e-4, 1.0, "s", "length of the frame")
      .add_whole("reference_steps", 1000, 1, 100000, "steps of the reference in the frame");
  figure.experiment = measure_order_of_five;
  return figure;
}

Figure queue_figure() {
  Figure figure;
  figure.name = "queue_at_work";
  figure.section = "5.1";
  figure.title = "The queue at work: one frame of the safer form, collision by collision";
  figure.caption =
      "Four cubes on a line, a panel for each collision that is taken out of the queue. Bands are "
      "filled up to the valid time of a cube, dashed where it goes if it meets nobody. "
      "C-D comes out first, but by then A overlaps B: A-B goes in front, and C-D is put back. "
      "After a "
      "collision only its two cubes lose what was foreseen for them, and most of that never comes: "
      "A-C, B-D and the first C-D. When nothing is left, the test states become valid.";
  figure.parameters
      .add_text("boxes", "0:2.7,1.5:0,3:0,4.25:-0.4",
                "place and speed of each cube, as x:v in m and m/s")
      .add_number("frame", 1.0, 1e-3, 100.0, "s", "length of the frame")
      .add_word("form", {"safer", "simple", "swept"}, "of the timewarp");
  figure.experiment = measure_queue_at_work;
  return figure;
}

}  // namespace

std::vector<Figure> order_figures() { return {five_figure(), queue_figure()}; }

}  // namespace tumble::chapters
