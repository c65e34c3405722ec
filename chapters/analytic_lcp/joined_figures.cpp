/// \file
/// \brief The figures of the joined simulator: impacts in the order of time, and contact forces.
#include "analytic_lcp/experiments.hpp"
#include "analytic_lcp/joined_experiments.hpp"

namespace tumble::chapters {
namespace {

Figure joined_figure() {
  Figure figure;
  figure.name = "claim_3_3_1d_joined";
  figure.section = "3.3.1";
  figure.title = "Impacts in the order of time and analytic contact forces, joined in one run";
  figure.caption =
      "One world, one run, one technique. A cube is dropped from 1 m, bounces six times at the "
      "closed-form moments, and sticks at the seventh impact. Another one slides to a stop "
      "where Coulomb's law says. A post that leans by 20 degrees falls over and comes to lie "
      "flat. A stack of three stands; the curve shows how far a cube of it has moved at most, "
      "on a log axis (it has not). The energy falls and never rises, but for rounding. The thesis "
      "had "
      "impacts and contact forces in two programs and could not join them.";
  figure.parameters.add_number("step", 1.0 / 60.0, 1e-4, 0.1, "s", "time step")
      .add_number("duration", 5.0, 2.0, 60.0, "s", "length of the run");
  figure.quick = {"duration=3.5"};
  figure.experiment = measure_joined;
  return figure;
}

Figure exact_times_figure() {
  Figure figure;
  figure.name = "claim_3_3_1e_exact_times";
  figure.section = "3.3.1";
  figure.title = "What exact impact times cost, against time stepping at equal error";
  figure.caption =
      "Cubes bounce side by side without touching one another, each from a height of its own. "
      "Above, ten of them: separations and integrations in two seconds against the largest "
      "error of a height. Exact impact times give the same motion whatever the step; the "
      "tenths of a millimetre that are left are bounces too slow to be made. Time stepping has "
      "to make its steps short until a bounce comes at the right moment. Below, the two at "
      "equal error, an accepted hundredth of an edge. Each impact puts all bodies back, so "
      "exact times grow faster with the number of cubes: 64 need half of what time stepping "
      "needs.";
  figure.parameters
      .add_whole("cubes", 64, 1, 1000, "the largest number of cubes, doubled from one up to there")
      .add_number("duration", 2.0, 0.2, 60.0, "s", "length of each run")
      .add_number("restitution", 0.5, 0.0, 0.9, "-", "rebound speed over impact speed")
      .add_number("accepted", 0.01, 1e-6, 1.0, "m", "largest error of a height; the edge is 1 m")
      .add_number("finest", 1e-5, 1e-7, 0.01, "s", "shortest step that is tried");
  figure.quick = {"cubes=2"};
  figure.experiment = measure_exact_times;
  return figure;
}

Figure sticky_figure() {
  Figure figure;
  figure.name = "claim_4_3a_sticky";
  figure.section = "4.3";
  figure.title = "Sticky collisions spare the tail of ever smaller ones";
  figure.caption =
      "Collisions slower than a threshold stick. Above, how many a die makes until it rests, "
      "against that threshold. The lowest one is where the technique takes a contact for "
      "resting in any case: without sticky collisions the tail goes on to there. Circles: a "
      "flat drop, where every bounce halves the speed; each is on the closed form. Squares: "
      "dice thrown with a random orientation and spin; they also fall from corner to edge to "
      "face, and those collisions no threshold spares. Below, how far away from its other "
      "resting place a die comes to rest.";
  figure.parameters.add_number("height", 2.0, 0.1, 100.0, "m", "free height of the die")
      .add_number("restitution", 0.5, 0.1, 0.9, "-", "rebound speed over impact speed")
      .add_whole("seeds", 20, 2, 1000, "dice");
  figure.quick = {"seeds=3"};
  figure.experiment = measure_sticky;
  return figure;
}

Figure all_sticky_figure() {
  Figure figure;
  figure.name = "claim_4_3b_all_sticky";
  figure.section = "4.3";
  figure.title = "If every collision is sticky, a die falls like a bag of sand";
  figure.caption =
      "Above, the lowest corner of a die that is thrown from 2 m: with restitution 0.5 it "
      "leaves the ground again and again (full), with every collision sticky it never does "
      "(dashed). Below, how often each of the dice leaves the ground by more than a thousandth "
      "of its edge. None does under sticky collisions, and it travels about a fifth of the "
      "way.";
  figure.parameters.add_number("height", 2.0, 0.1, 100.0, "m", "free height of the die")
      .add_number("restitution", 0.5, 0.1, 0.9, "-", "rebound speed over impact speed")
      .add_whole("seeds", 20, 2, 1000, "dice");
  figure.quick = {"seeds=3"};
  figure.experiment = measure_all_sticky;
  return figure;
}

}  // namespace

void add_joined_figures(std::vector<Figure>& list) {
  list.push_back(joined_figure());
  list.push_back(exact_times_figure());
  list.push_back(sticky_figure());
  list.push_back(all_sticky_figure());
}

}  // namespace tumble::chapters
