/// \file
/// \brief The figures that show boxes in three dimensions: a strip of frames and the gallery.
#include "tumble/base/error.hpp"
#include "tumble/base/number_text.hpp"
#include "tumble/scenes/library.hpp"

#include "basic_colliding/experiments.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

namespace tumble::chapters {
namespace {

Figure dice_strip_figure() {
  Figure figure;
  figure.name = "dice_strip";
  figure.section = "2.1, 4.2";
  figure.title = "A thrown die under the basic technique";
  figure.caption =
      "A die of 10 cm is thrown to the right; six moments, seen by the same camera. Each meeting "
      "of the die with the ground is found at its own moment within a step: the first one agrees "
      "with the exact flight of a turning cube to a microsecond. Between impacts the die flies "
      "freely. The strip ends before it settles, because the basic technique never lets it: its "
      "hops get ever shorter without end. What it loses in energy is booked to the last digit "
      "as restitution and friction.";
  figure.parameters.add_number("speed", 0.5, 0.0, 10.0, "m/s", "sideways, at the start")
      .add_number("spin", 15.0, 0.0, 100.0, "rad/s", "at the start, about a random axis")
      .add_number("restitution", 0.4, 0.0, 1.0, "-", "rebound speed over impact speed")
      .add_whole("seed", 1, 0, 1000000, "of orientation and axis of spin")
      .add_number("first", 0.16, 0.0, 10.0, "s", "time of the first frame")
      .add_number("interval", 0.09, 0.001, 10.0, "s", "from frame to frame")
      .add_number("step", 0.01, 1e-4, 0.1, "s", "time step");
  figure.experiment = measure_dice_strip;
  return figure;
}

// How a scene is shown in the gallery.
struct Shot {
  std::string_view scene;
  std::string_view title;      // one line
  std::string_view change;     // "key=value" with spaces in between, from the defaults of the scene
  double time;                 // [s] since the start
  std::array<double, 3> view;  // from the boxes to the eye
};

constexpr std::array<Shot, 26> kShots = {{
    {"box_drop", "A cube falls on an edge", "", 0.4, {0.4, 0.4, 1.0}},
    {"bouncing_box", "A cube that was dropped flat rebounds", "", 0.8, {0.6, 0.4, 1.0}},
    {"tumbling_box", "A free box turns over", "", 2.8, {0.5, 0.6, 1.0}},
    {"two_boxes", "A cube has hit a heavier box off its centre", "", 1.2, {-0.4, 0.5, 1.0}},
    {"crate_off_table", "A crate tumbles off a table", "", 0.9, {0.6, 0.45, 1.0}},
    {"cradle", "Newton's cradle, made of cubes", "", 0.0, {0.4, 0.5, 1.0}},
    {"stack", "A stack of ten cubes", "", 0.0, {0.6, 0.35, 1.0}},
    {"pyramid", "A flat pyramid of ten rows", "", 0.0, {0.35, 0.3, 1.0}},
    {"pyramid3d", "A pyramid of square layers", "rows=6", 0.0, {0.5, 0.5, 1.0}},
    {"wall", "A wall in quarter bond", "courses=12 bricks=9", 0.0, {0.5, 0.35, 1.0}},
    {"clump", "Cubes fly together", "", 0.6, {0.6, 0.5, 1.0}},
    {"projectile",
     "A cube has gone through a pyramid, seen from behind",
     "rows=8 appears=0",
     0.7,
     {0.7, 0.4, -1.0}},
    {"dice", "Five dice are thrown", "", 0.35, {0.3, 0.5, 1.0}},
    {"slide", "A box slides on the ground", "", 0.0, {0.6, 0.5, 1.0}},
    {"slope", "A box on a slope", "", 0.0, {0.3, 0.4, 1.0}},
    {"sled", "A stack on a sled", "", 0.0, {0.5, 0.5, 1.0}},
    {"rocking_block", "A block rocks from edge to edge", "", 0.0, {0.4, 0.3, 1.0}},
    {"seesaw", "A loaded see-saw", "", 0.0, {0.4, 0.4, 1.0}},
    {"leaning", "Planks lean on blocks", "", 0.0, {0.8, 0.5, 1.0}},
    {"table", "A table on free legs", "", 0.0, {0.5, 0.4, 1.0}},
    {"toss", "A cube is tossed like measured ones", "", 0.0, {0.5, 0.5, 1.0}},
    {"line", "Cubes on a line, each with a speed of its own", "", 0.3, {0.3, 0.4, 1.0}},
    {"cage", "Cubes in a cage without gravity, opened for the view", "", 2.0, {0.6, 0.5, 1.0}},
    // Figures of the thesis that run in the book: these are their still pictures.
    {"fig5_1", "Figure 5.1: five cubes in a row, the first one fast", "", 0.0, {0.3, 0.4, 1.0}},
    {"fig5_6", "Figure 5.6: a pyramid over a hole", "rows=9", 0.0, {0.35, 0.3, 1.0}},
    {"fig6_1", "Figure 6.1: a column leans over an edge", "", 0.0, {0.35, 0.3, 1.0}},
}};

Figure gallery_figure(const Shot& shot) {
  const SceneRecipe& recipe = scene_recipe(shot.scene);
  Figure figure;
  figure.name = "gallery_" + std::string(shot.scene);
  figure.section = recipe.section;
  figure.title = shot.title;
  figure.caption = shot.time > 0.0 ? "After " + shortest_text(shot.time) +
                                         " s under the basic technique: tumble run "
                                   : std::string("At the start: tumble run ");
  figure.caption += shot.scene;
  if (shot.time > 0.0) figure.caption += " --technique basic --set event_cap=20";

  figure.parameters = recipe.parameters();
  for (std::string_view rest = shot.change; !rest.empty();) {
    const std::string_view one = rest.substr(0, rest.find(' '));
    const std::size_t equals = one.find('=');
    figure.parameters.set(one.substr(0, equals), one.substr(equals + 1));
    figure.caption += " --set " + std::string(one);
    rest.remove_prefix(std::min(rest.size(), one.size() + 1));
  }
  figure.parameters.add_number("time", shot.time, 0.0, 60.0, "s", "when the picture is taken")
      .add_whole("event_cap", 20, 1, 1000000, "moments of impact allowed in one step")
      .add_number("view_x", shot.view[0], -1e3, 1e3, "-", "direction to the eye, x")
      .add_number("view_y", shot.view[1], -1e3, 1e3, "-", "direction to the eye, y")
      .add_number("view_z", shot.view[2], -1e3, 1e3, "-", "direction to the eye, z");
  figure.experiment = [name = std::string(shot.scene)](const Parameters& settings) {
    return measure_gallery(name, settings);
  };
  return figure;
}

}  // namespace

void add_picture_figures(std::vector<Figure>& list) {
  list.push_back(dice_strip_figure());
  for (const Shot& shot : kShots) list.push_back(gallery_figure(shot));
}

}  // namespace tumble::chapters
