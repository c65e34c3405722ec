/// \file
/// \brief The figures that show what contact forces are, how pivoting finds them, and where there
///        are none.
#include "analytic_lcp/experiments.hpp"
#include "analytic_lcp/force_experiments.hpp"

namespace tumble::chapters {
namespace {

Figure pyramid_forces_figure() {
  Figure figure;
  figure.name = "pyramid_forces";
  figure.section = "2.6, 3.3.1";
  figure.title = "The forces in a pyramid: one answer on feet, a range on full faces";
  figure.caption =
      "Forces between bricks, in weights of a brick. Above, each brick has two feet, and each "
      "foot is right above a foot of the next row: loads go straight down, and there is one "
      "answer. An arrow is all that a brick bears of another one, or the ground of a brick, "
      "drawn where it acts. Below, bricks lie flat on each other, and only the load of a whole "
      "row is certain. Every height in a bar is the force of some answer under which no brick "
      "moves, from the smallest to the largest one possible. The marks are four such answers: "
      "each solver finds another one, all are right, and they differ by more than a brick's "
      "weight.";
  figure.parameters.add_whole("rows", 3, 2, 6, "bricks in the lowest row")
      .add_number("spacing", 1.05, 1.001, 1.5, "m", "from brick to brick in a row, 1 m wide");
  figure.quick = {"rows=2"};
  figure.experiment = measure_pyramid_forces;
  return figure;
}

Figure index_sets_figure() {
  Figure figure;
  figure.name = "index_sets";
  figure.section = "3.3.1";
  figure.title = "Baraff's algorithm, step by step: contacts enter, leave and return";
  figure.caption =
      "Two planks on three posts touch in five contacts. The middle of the upper one (cross) "
      "is beyond the third post, so it will tip. The algorithm takes up one contact after the "
      "other and lets its force grow (triangle) until it no longer sinks. Meanwhile contacts "
      "that push (full circle, set C) stay at rest, and those that part (ring, set NC) stay "
      "without force. Whoever would break this rule ends the step and changes sets. The force "
      "at contact 4, at the end of the lower plank, lifts its other end: 1 parts. Then post 5 "
      "takes the load off, and 1 returns. Below, forces and accelerations: straight within a "
      "step, with a kink wherever a set changes.";
  figure.parameters.add_number("centre", 1.625, 0.5, 2.2, "m", "middle of the upper plank")
      .add_number("post", 1.5, 1.05, 2.5, "m", "place of the third post");
  figure.experiment = measure_index_sets;
  return figure;
}

Figure painleve_map_figure() {
  Figure figure;
  figure.name = "painleve_map";
  figure.section = "2.6.3";
  figure.title = "Painlevé's rod: friction leaves no force or two, and a time step one impulse";
  figure.caption =
      "A rod of 1 kg and 2 m slides on its lower end at 1 m/s, away from its lean. Above the "
      "curve, friction turns the end into the ground faster than the push lifts it. Without "
      "spin no force at all then obeys Coulomb's law; with spin two do, none and a large one. "
      "Each dot is a time step with unknown impulses instead of forces: it has a solution "
      "everywhere. Full dots: the end sticks within the step; rings: it slides on. A step "
      "knows velocities only, and is the same for both maps. At the bottom, its impulse "
      "against its length, at 60 degrees. Below the curve it is a force times the step. Above, "
      "it stays however short the step is: an impulse without a collision that stops the "
      "sliding at once.";
  figure.parameters.add_number("spin", 5.0, 0.1, 100.0, "rad/s", "of the rods in the second map")
      .add_number("step", 1.0 / 60.0, 1e-6, 1.0, "s", "time step of the dots")
      .add_whole("friction_steps", 120, 10, 2000, "rows of the grid of either map");
  figure.quick = {"friction_steps=30"};
  figure.experiment = measure_painleve_map;
  return figure;
}

}  // namespace

void add_force_figures(std::vector<Figure>& list) {
  list.push_back(pyramid_forces_figure());
  list.push_back(index_sets_figure());
  list.push_back(painleve_map_figure());
}

}  // namespace tumble::chapters
