/// \file
/// \brief The figures on exterior rotation under every technique of the library.
#include "exterior_rotation/technique_figures.hpp"

#include "exterior_rotation/technique_experiments.hpp"

namespace tumble::chapters {
namespace {

Figure gaps_figure(const char* name, double time) {
  Figure figure;
  figure.name = name;
  figure.section = "6.2";
  figure.parameters.add_number("time", time, 0.1, time, "s", "from the start")
      .add_number("rate", 60.0, 10.0, 1000.0, "1/s", "steps a second");
  figure.quick = {"time=0.2"};
  return figure;
}

Figure column_gaps() {
  Figure figure = gaps_figure("technique_gaps", 0.8);
  figure.title = "Which technique keeps figure 6.1's column together?";
  figure.caption =
      "Largest opening or overlap in 0.8 s of the fall at 60 steps a second, with friction and no "
      "glue. Hollow: each body moved by itself. Filled: by what it stands on, pose=exponential. "
      "With analytic, time_stepping and glued joints nothing is left but rounding; contact_damped "
      "keeps what its solver leaves. The impulse technique does not gain, because its ten passes "
      "do "
      "not make the column turn as one in the first place; with a hundred they do.";
  figure.experiment = measure_column_gaps;
  return figure;
}

Figure one_box_gaps() {
  Figure figure = gaps_figure("technique_gaps_one_box", 0.45);
  figure.title = "Which technique keeps figure 6.2's box on its edge?";
  figure.caption =
      "Largest height of the edge above the larger box, or depth in it, in 0.45 s at 60 steps a "
      "second. Hollow: centre and orientation moved apart; filled: pose=exponential. The option "
      "takes away the gap in all of them; what the impulse technique has left is what its passes "
      "leave. In contact_damped a hundredth of a millimetre comes back as the face comes near the "
      "larger box.";
  figure.experiment = measure_one_box_gaps;
  return figure;
}

Figure nested_gaps() {
  Figure figure = gaps_figure("technique_gaps_nested", 0.4);
  figure.title = "Which technique keeps figure 6.3's two edges together?";
  figure.caption =
      "Largest opening or overlap at either edge in 0.4 s at 60 steps a second. Hollow: centre and "
      "orientation moved apart; filled: pose=exponential. Carried along a tree of pivots, both "
      "edges stay together to rounding in analytic and time_stepping. In glued joints the "
      "exponential is that of each body's own twist, which is not enough where the spins differ.";
  figure.experiment = measure_nested_gaps;
  return figure;
}

Figure other_gaps() {
  Figure figure;
  figure.name = "technique_gaps_other";
  figure.section = "6.2";
  figure.title = "And the techniques that have no such option?";
  figure.caption =
      "Largest opening or overlap at 60 steps a second in figures 6.1, 6.2 and 6.3. Timewarps fly "
      "freely and then part what overlaps, but for a thousandth of an edge that they leave: no gap "
      "shows, as bodies creep along their faces instead. Under damped the column does not fall at "
      "all, as its thresholds take each step's speed away. The basic technique has no resting "
      "contact; it meets its cap on collisions, and its boxes rattle.";
  figure.parameters.add_number("rate", 60.0, 10.0, 1000.0, "1/s", "steps a second")
      .add_number("share", 1.0, 0.1, 1.0, "-", "of 0.8 s, 0.45 s and 0.4 s");
  figure.quick = {"share=0.5"};
  figure.experiment = measure_other_gaps;
  return figure;
}

Figure gap_reasons() {
  Figure figure;
  figure.name = "technique_gap_orders";
  figure.section = "6.2";
  figure.title = "Why do the gaps of techniques differ?";
  figure.caption =
      "Figure 6.1's column, each body moved by itself: gap against the step. Where nobody "
      "takes gaps back they are of first order: in glued joints with impulses, and under the "
      "impulse technique with enough passes. Time stepping has the gap in its conditions and "
      "closes "
      "in a step what the last one has opened. What is left is the gap of one step, the grey line. "
      "contact_damped does nearly so. The analytic technique flies parabolas, which err in "
      "the third power of the step; that adds up to the second.";
  figure.parameters.add_number("time", 0.8, 0.1, 0.8, "s", "from the start")
      .add_whole("halvings", 2, 1, 4, "of the step of 1/30 s");
  figure.quick = {"time=0.4", "halvings=1"};
  figure.experiment = measure_gap_reasons;
  return figure;
}

}  // namespace

std::vector<Figure> technique_figures() {
  return {column_gaps(), one_box_gaps(), nested_gaps(), other_gaps(), gap_reasons()};
}

}  // namespace tumble::chapters
