/// \file
/// \brief The figures of the thesis's own scenes under damped integration; those on friction too.
#include "impulse_damped/friction_experiments.hpp"
#include "impulse_damped/scene_experiments.hpp"

#include <string>

namespace tumble::chapters {
namespace {

void add_shot(Parameters& parameters) {
  parameters.add_whole("rows", 10, 2, 30, "of the pyramid")
      .add_number("height", 3.5, 0.5, 30.0, "m", "of the projectile's centre")
      .add_number("speed", 20.0, 0.1, 100.0, "m/s", "of the projectile")
      .add_number("mass", 5.0, 1e-3, 1e3, "kg", "of the projectile; a box has 1 kg")
      .add_number("appears", 5.0, 1.0, 100.0, "s", "for how long the pyramid stands before");
}

Figure projectile_figure() {
  Figure figure;
  figure.name = "fig6_6_projectile";
  figure.section = "6.1";
  figure.title = "Figure 6.6: a box is shot from the eye point towards the pyramid";
  figure.caption =
      "The layout is reconstructed from the caption, by which the box comes from where the viewer "
      "stands; the eye is a little above and beside the one who shoots, so that "
      "the box does not hide what it hits. Its size, mass and speed and the rows of the "
      "pyramid are ours. Damped integration, times since the shot. The pyramid has stood for five "
      "seconds, and for all but the first half second no box has moved at all. The shot knocks a "
      "hole into it, and the rest stays up around the hole, as with Coulomb's friction.";
  figure.film =
      "The same, from a little before the shot to three seconds after it, as fast as it is.";
  add_shot(figure.parameters);
  constexpr double times[] = {0.05, 0.25, 0.4, 0.7, 1.2, 3.0};
  for (int k = 0; k < 6; ++k)
    figure.parameters.add_number(std::string("t").append(std::to_string(k + 1)), times[k], 0.0,
                                 60.0, "s", "of a frame, since the shot");
  figure.quick = {"rows=4", "height=1.5", "appears=1"};
  figure.experiment = measure_projectile;
  return figure;
}

Figure projectile_curves_figure() {
  Figure figure;
  figure.name = "fig6_6_projectile_curves";
  figure.section = "6.1";
  figure.title = "The shot of figure 6.6 over time: energy, overlap, chatter";
  figure.caption =
      "The run of figure 6.6 from one second before the shot. Energy is over that of the standing "
      "pyramid. Chatter is how far the worst of the resting boxes moves within half a second. "
      "Before "
      "the shot nothing overlaps and nothing chatters. After it the boxes around the hole do not "
      "stand "
      "on firm ground any more. All still lie flat, but each row is pushed up by the one below: "
      "overlap and chatter of a few hundredths of an edge stay, and chatter grows from row to row.";
  add_shot(figure.parameters);
  figure.parameters.add_number("duration", 5.0, 1.0, 60.0, "s", "after the shot");
  figure.quick = {"rows=4", "height=1.5", "appears=1", "duration=2"};
  figure.experiment = measure_projectile_curves;
  return figure;
}

Figure clump_figure() {
  Figure figure;
  figure.name = "fig6_7_clump";
  figure.section = "6.1";
  figure.title = "Figure 6.7: boxes fly towards the origin and settle, and some still chatter";
  figure.caption =
      "The layout is reconstructed from the caption: everything starts by flying to the middle, "
      "and once it has settled some of it still chatters a little. How many, how fast "
      "and how turned is ours. Damped integration. Above, the start; below, the end, each "
      "cube with the colour of its chatter: how far its corners move within half a second.";
  figure.film =
      "The first three seconds, as fast as they are; then what moves moves too little to be seen.";
  figure.parameters.add_whole("per_edge", 5, 2, 8, "cubes along each edge of the grid at the start")
      .add_number("speed", 2.0, 0.0, 10.0, "m/s", "of each cube at the start")
      .add_number("duration", 10.0, 1.0, 100.0, "s", "until they have settled");
  figure.quick = {"per_edge=2", "duration=4"};
  figure.experiment = measure_clump_settles;
  return figure;
}

Figure crate_figure() {
  Figure figure;
  figure.name = "crate_off_table";
  figure.section = "1.1";
  figure.title = "A crate slides off a table and tumbles";
  figure.caption =
      "The example of the thesis's introduction; the layout is reconstructed from its words, a box "
      "that slides across a table and tumbles over the edge. Left damped integration, right "
      "Coulomb's friction 0.3; times since the crate's centre passed the edge. Over the edge both "
      "tip and fall. "
      "On the table they differ: damping slows in proportion to the speed, so the "
      "crate has to start at 10 m/s to get as far as with friction at 3.5 m/s.";
  figure.parameters.add_number("speed", 3.5, 0.0, 100.0, "m/s", "at the start, Coulomb's friction")
      .add_number("damped_speed", 10.0, 0.0, 100.0, "m/s", "at the start, damped")
      .add_number("friction", 0.3, 0.0, 10.0, "-", "Coulomb's coefficient");
  constexpr double times[] = {-0.25, 0.2, 0.4, 1.5};
  for (int k = 0; k < 4; ++k)
    figure.parameters.add_number(std::string("t").append(std::to_string(k + 1)), times[k], -10.0,
                                 60.0, "s", "of a frame, since the crate passes the edge");
  figure.experiment = measure_crate;
  return figure;
}

}  // namespace

void add_scene_figures(std::vector<Figure>& list) {
  add_friction_figures(list);
  list.push_back(projectile_figure());
  list.push_back(projectile_curves_figure());
  list.push_back(clump_figure());
  list.push_back(crate_figure());
}

}  // namespace tumble::chapters
