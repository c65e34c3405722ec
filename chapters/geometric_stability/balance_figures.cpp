/// \file
/// \brief The figures on towers, balance and thresholds.
#include "geometric_stability/balance_figures.hpp"

#include "geometric_stability/heavy_top_experiments.hpp"
#include "geometric_stability/threshold_experiments.hpp"
#include "geometric_stability/tower_experiments.hpp"

namespace tumble::chapters {
namespace {

Figure one_block_figure() {
  Figure figure;
  figure.name = "fig6_4_one_block";
  figure.section = "6.3.1";
  figure.title = "Figure 6.4: a series of blocks, taken for one heavier block";
  figure.caption =
      "The layout is reconstructed from the caption, which has a series of blocks stand for one "
      "object; ours is a staircase. Left: at each level a bar, the hull of the contact, and a dot, "
      "the centre of all above. Middle: one block with this mass and centre, and the support "
      "force. Right: a step too far, the centre of the upper four has left its bar; arrows and "
      "outlines: the motion that starts, by balance. Below: counted work for longer series.";
  figure.parameters.add_whole("count", 5, 2, 20, "blocks of the staircase")
      .add_number("overhang", 0.18, 0.0, 0.9, "-", "of each block, one that stands")
      .add_number("beyond", 0.23, 0.0, 0.9, "-", "of each block, one that tips")
      .add_whole("largest", 16, 1, 60, "blocks of the longest series");
  figure.quick = {"largest=8"};
  figure.experiment = measure_one_block;
  return figure;
}

Figure heavy_top_figure() {
  Figure figure;
  figure.name = "fig6_5_heavy_top";
  figure.section = "6.3.1";
  figure.title = "Figure 6.5: a very heavy block keeps two others from tipping";
  figure.caption =
      "The layout is reconstructed from the caption: a heavy top, blocks below it, and its weight "
      "shared by two contacts. Above, forces that balance, in weights of a lower block; then a top "
      "that is too light, and how the blocks start to move. Below, the least mass of the top: "
      "marks by bisection on balance, lines by hand; in the shaded area it stands. Runs of five "
      "seconds: filled "
      "ones stand, open ones fall. With friction forces exist from the lower line on, and runs "
      "find them.";
  figure.parameters.add_number("mass_ratio", 1.0, 1e-3, 1e3, "-", "of the top that stands")
      .add_number("too_light", 0.5, 1e-3, 1e3, "-", "of the top that does not")
      .add_number("offset", 0.2, -0.24, 0.24, "m", "of the top in both")
      .add_number("friction", 0.5, 0.01, 2.0, "-", "of the runs with friction")
      .add_number("seconds", 5.0, 0.1, 100.0, "s", "of each run")
      .add_number("resolution", 1e-5, 1e-9, 0.1, "-", "of the limit of runs, as a share of it")
      .add_whole("steps", 12, 2, 200, "offsets from -0.24 to 0.24 m");
  figure.quick = {"steps=2", "seconds=2", "resolution=0.01"};
  figure.experiment = measure_heavy_top;
  return figure;
}

Figure claim_figure() {
  Figure figure;
  figure.name = "claim_6_3_1d_equilibrium";
  figure.section = "6.3.1";
  figure.title = "Can figures 6.4 and 6.5 be decided, and how exactly?";
  figure.caption =
      "Above: the least mass of the top of figure 6.5. Middle: the largest overhang of a staircase "
      "of blocks. The test of balance (marks) lies on the closed forms. Two rules that go level by "
      "level do not: loads at the middles of areas give other limits, and own centres alone let "
      "figure 6.5 never stand and every staircase up to a half. Below: errors of the test and of "
      "towers, far under the millionth that the claim allows.";
  figure.parameters.add_whole("steps", 12, 2, 200, "offsets from -0.24 to 0.24 m")
      .add_whole("rows", 8, 2, 10, "of the pyramid whose work is counted");
  figure.quick = {"steps=4", "rows=4"};
  figure.experiment = measure_thresholds;
  return figure;
}

Figure weakly_stable_figure() {
  Figure figure;
  figure.name = "weakly_stable";
  figure.section = "6.3.1";
  figure.title = "Balance with friction: how exact it is, and what it leaves open";
  figure.caption =
      "Above: the least friction with which a plank can lean on a smooth wall, against the closed "
      "form. Along an edge of the pyramid of friction it is exact; between two edges the pyramid "
      "lacks what the line says. Below: a box between two walls that touch it. Friction could hold "
      "it, if the walls pressed; nothing makes them press, and it falls freely. Balance with "
      "friction says that forces exist, not that they come about.";
  figure.parameters.add_number("angle", 60.0, 30.0, 85.0, "deg", "of the plank, from the ground")
      .add_whole("edges", 32, 16, 64, "of the finest pyramid of friction")
      .add_number("friction", 0.5, 0.01, 10.0, "-", "of walls and box")
      .add_number("duration", 0.5, 0.1, 0.6, "s", "of the fall");
  figure.quick = {"edges=16"};
  figure.experiment = measure_weakly_stable;
  return figure;
}

}  // namespace

std::vector<Figure> balance_figures() {
  return {one_block_figure(), heavy_top_figure(), claim_figure(), weakly_stable_figure()};
}

}  // namespace tumble::chapters
