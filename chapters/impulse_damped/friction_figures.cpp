/// \file
/// \brief The figures on what damping does in place of friction.
#include "impulse_damped/friction_experiments.hpp"

namespace tumble::chapters {
namespace {

Figure fig5_2_figure() {
  Figure figure;
  figure.name = "fig5_2_friction";
  figure.section = "5.3";
  figure.title = "Figure 5.2: block A slides on block B, damped and with Coulomb's friction";
  figure.caption =
      "The layout is reconstructed from the caption: A gets a damping effect close to friction, "
      "force B by Newton is not applied. Arrows are means while A slides on B; none was typed in. "
      "Ground without friction. A brakes alike, and B shows the difference: Newton's force on it "
      "(dashed) is missing under damping. So it stays where it is, A comes to a stop on it "
      "instead of a common speed, and momentum is lost that nothing took up.";
  figure.parameters.add_number("speed", 2.0, 0.1, 3.0, "m/s", "of A at the start")
      .add_number("mass", 1.0, 1e-3, 1e3, "kg", "of A")
      .add_number("lower_mass", 2.0, 1e-3, 1e3, "kg", "of B")
      .add_number("friction", 0.5, 0.01, 10.0, "-", "Coulomb's coefficient of A and B")
      .add_number("ground_friction", 0.0, 0.0, 10.0, "-", "of the ground")
      .add_number("duration", 1.0, 0.1, 10.0, "s", "of the run");
  figure.experiment = measure_sliding_blocks;
  return figure;
}

Figure upper_figure() {
  Figure figure;
  figure.name = "claim_5_3c_friction";
  figure.section = "5.3";
  figure.title = "Is the friction on the faster body close to Newton's?";
  figure.caption =
      "The upper block of figure 5.2. Above, its speed: damped, with half and twice the damping as "
      "a band, and with Coulomb's friction 0.5, B free to move or held by the ground. Damping is "
      "in "
      "proportion to the speed: at first it brakes twice as hard as friction, later less. Then the "
      "block stops that should go on together with B. Below, the largest difference of the two "
      "speeds for each coefficient of friction; damping knows none. On a block that is held it is "
      "least near 0.5; on one that is free the block that should not stop keeps it above a third.";
  figure.parameters.add_number("speed", 2.0, 0.1, 3.0, "m/s", "of the upper block at the start")
      .add_number("duration", 2.0, 0.1, 10.0, "s", "of the runs")
      .add_whole("steps", 40, 2, 400, "coefficients of friction from 0 to 1");
  figure.quick = {"steps=10"};
  figure.experiment = measure_friction_on_upper;
  return figure;
}

Figure chain_figure() {
  Figure figure;
  figure.name = "claim_5_3f_chain";
  figure.section = "5.3";
  figure.title = "Is friction handed on along a chain of bodies?";
  figure.caption =
      "Two boxes on a sled that moves at the start, on ground without friction. With Coulomb's "
      "friction the sled takes the lower box along, this one the upper, and soon all three have "
      "one speed. Damped, the sled comes to a stop by itself, and neither box has moved: each "
      "body is slowed down for itself, and one that is at rest gets nothing from the others.";
  figure.parameters.add_number("speed", 1.0, 0.1, 10.0, "m/s", "of the sled at the start")
      .add_number("duration", 1.0, 0.1, 10.0, "s", "of the runs");
  figure.experiment = measure_friction_chain;
  return figure;
}

Figure seen_figure() {
  Figure figure;
  figure.name = "claim_5_3g_seen";
  figure.section = "5.3";
  figure.title = "Does a viewer see what friction fails to hand on?";
  figure.caption =
      "The scenes of figures 6.6 and 6.7 made small, each with many seeds: how far the boxes go, "
      "as a mean over the boxes of a run. Each dot is a seed under both techniques; on the "
      "diagonal both agree, the cross is the medians, and the grey strip is a tenth off, which "
      "nobody sees. Above, a cube is shot at a pyramid; this decides. Below, cubes fly "
      "together and stop one another.";
  figure.parameters.add_whole("seeds", 24, 2, 1000, "runs of each scene")
      .add_whole("rows", 5, 2, 20, "of the pyramid")
      .add_whole("per_edge", 3, 2, 6, "cubes along each edge of the clump's grid")
      .add_number("duration", 5.0, 1.0, 60.0, "s", "of a run");
  figure.quick = {"seeds=4", "duration=3", "rows=3", "per_edge=2"};
  figure.experiment = measure_what_is_seen;
  return figure;
}

}  // namespace

void add_friction_figures(std::vector<Figure>& list) {
  list.push_back(fig5_2_figure());
  list.push_back(upper_figure());
  list.push_back(chain_figure());
  list.push_back(seen_figure());
}

}  // namespace tumble::chapters
