/// \file
/// \brief Scenes of boxes near the limit of balance.
#include "tumble/math/elementary.hpp"
#include "tumble/math/rotation.hpp"
#include "tumble/scenes/recipes.hpp"

#include <numbers>

namespace tumble::recipes {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

Parameters rocking_parameters() {
  return {number("width", 0.4, 1e-3, 1e3, "m", "width of the block, along x and z"),
          number("height", 2.0, 1e-3, 1e3, "m", "height of the block"),
          number("tilt", 0.5, 0.0, 1.0, "-",
                 "at the start, over the angle at which it balances on its edge"),
          number("friction", 0.5, 0.0, 10.0, "-", "Coulomb coefficient")};
}

// Housner's block: it rocks from edge to edge. With tilt 1 its centre is above the left edge, at
// -width/2 on the ground.
Scene rocking_block(const Parameters& p, Random) {
  Scene scene{.title = "a block rocks from edge to edge"};
  const double width = p.number("width");
  const double height = p.number("height");
  const double tilt = p.number("tilt") * elementary::atan2(width, height);
  const Vec3 turn(0.0, 0.0, tilt);
  SceneBox block = box_at("block", Vec3(width, height, width), Vec3::Zero(), 1.0);
  block.orientation_wb = rotation_from_vector(turn);
  const Vec3 from_edge = block.orientation_wb * Vec3(0.5 * width, 0.5 * height, 0.0);
  block.position_w = Vec3(-0.5 * width, 0.0, 0.0) + from_edge;
  scene.boxes.push_back(block);
  add_ground(p, scene);
  return scene;
}

Parameters seesaw_parameters() {
  return {number("left", 2.0, 1e-3, 1e3, "kg", "load on the left end"),
          number("right", 1.0, 1e-3, 1e3, "kg", "load on the right end"),
          number("plank", 1.0, 1e-3, 1e3, "kg", "mass of the plank"),
          number("pivot", 0.1, 1e-3, 2.0, "m", "width of the pivot"),
          number("friction", 0.5, 0.0, 10.0, "-", "Coulomb coefficient")};
}

// It tips if 1.75 |left - right| > (left + right + plank) pivot/2: moments about the pivot's edge.
Scene seesaw(const Parameters& p, Random) {
  Scene scene{.title = "a see-saw with a load on each end"};
  const double load = 0.5;  // edge of a load
  scene.boxes = {fixed_at("pivot", Vec3(p.number("pivot"), 0.5, 1.0), Vec3(0.0, 0.25, 0.0)),
                 box_at("plank", Vec3(4.0, 0.1, 1.0), Vec3(0.0, 0.55, 0.0), p.number("plank")),
                 box_at("left", Vec3::Constant(load), Vec3(-1.75, 0.85, 0.0), p.number("left")),
                 box_at("right", Vec3::Constant(load), Vec3(1.75, 0.85, 0.0), p.number("right"))};
  add_ground(p, scene);
  return scene;
}

Parameters fig6_5_parameters() {
  return {
      number("mass_ratio", 1.0, 1e-3, 1e3, "-", "mass of the top block over that of a lower one"),
      number("offset", 0.0, -0.24, 0.24, "m", "offset of the top block, to the right"),
      number("friction", 0.5, 0.0, 10.0, "-", "Coulomb coefficient")};
}

// Two blocks that overhang outwards, each on a pedestal, are kept from falling by the weight of
// a block on their inner ends. Without friction the centred block has to have 2/3 of the mass of
// one of them, one that is off by 0.2 m 70/93: the load between a block's pedestal and its inner
// end must turn it inwards as much as its own weight turns it outwards.
Scene fig6_5(const Parameters& p, Random) {
  Scene scene{.title = "a heavy block keeps two others from tipping (figure 6.5)"};
  const Vec3 pedestal(0.75, 1.0, 1.0);
  const Vec3 lower(2.0, 1.0, 1.0);
  scene.boxes = {fixed_at("pedestal_left", pedestal, Vec3(-1.375, 0.5, 0.0)),
                 fixed_at("pedestal_right", pedestal, Vec3(1.375, 0.5, 0.0)),
                 box_at("left", lower, Vec3(-2.0, 1.5, 0.0), 1.0),
                 box_at("right", lower, Vec3(2.0, 1.5, 0.0), 1.0),
                 box_at("top", Vec3(2.5, 1.0, 1.0), Vec3(p.number("offset"), 2.5, 0.0),
                        p.number("mass_ratio"))};
  add_ground(p, scene);
  return scene;
}

Parameters leaning_parameters() {
  return {whole("count", 3, 1, 100, "planks, side by side, each with a block of its own"),
          number("angle", 60.0, 45.0, 80.0, "deg", "angle of a plank, from the ground"),
          flag("fixed", false, "whether the blocks are immovable"),
          number("block_mass", 2.0, 1e-3, 1e3, "kg", "mass of a block; a plank has 1 kg"),
          number("friction", 0.5, 0.0, 10.0, "-", "Coulomb coefficient")};
}

// A plank stands on its lower edge and leans on the upper right edge of a block.
Scene leaning(const Parameters& p, Random) {
  Scene scene{.title = "planks lean on blocks"};
  const double angle = p.number("angle") * kDegree;
  const Vec3 plank(2.2, 0.1, 0.5);
  const double high = 1.2;
  const double foot = high * elementary::cos(angle) / elementary::sin(angle);
  for (int k = 0; k < p.count("count"); ++k) {
    const double z = 1.0 * (k - 0.5 * (p.count("count") - 1));
    SceneBox block = box_at(numbered("block", {k + 1}), Vec3(1.0, high, 0.8),
                            Vec3(-0.5, 0.5 * high, z), p.number("block_mass"));
    block.fixed = p.flag("fixed");
    SceneBox board = box_at(numbered("plank", {k + 1}), plank, Vec3::Zero(), 1.0);
    // The plank's own x axis points down along it; its lower right edge is the foot.
    board.orientation_wb = rotation_from_vector(Vec3(0.0, 0.0, -angle));
    board.position_w =
        Vec3(foot, 0.0, z) + board.orientation_wb * Vec3(-0.5 * plank.x(), 0.5 * plank.y(), 0.0);
    scene.boxes.push_back(block);
    scene.boxes.push_back(board);
  }
  add_ground(p, scene);
  return scene;
}

Parameters table_parameters() {
  return {number("load", 2.0, 1e-3, 1e3, "kg", "mass of the box on the table; the plate has 1 kg"),
          number("offset", 0.2, -0.75, 0.75, "m", "offset of that box from the middle, along x"),
          number("friction", 0.5, 0.0, 10.0, "-", "Coulomb coefficient")};
}

// A plate lies on four legs that stand by themselves.
Scene table(const Parameters& p, Random) {
  Scene scene{.title = "a table with a box on it"};
  for (int k = 0; k < 4; ++k) {
    scene.boxes.push_back(box_at(numbered("leg", {k + 1}), Vec3(0.2, 0.8, 0.2),
                                 Vec3(k % 2 == 0 ? -0.8 : 0.8, 0.4, k < 2 ? -0.4 : 0.4), 0.2));
  }
  scene.boxes.push_back(box_at("plate", Vec3(2.0, 0.1, 1.2), Vec3(0.0, 0.85, 0.0), 1.0));
  scene.boxes.push_back(
      box_at("box", Vec3::Constant(0.5), Vec3(p.number("offset"), 1.15, 0.0), p.number("load")));
  add_ground(p, scene);
  return scene;
}

}  // namespace

void add_balanced(std::vector<SceneRecipe>& list) {
  list.push_back({"rocking_block", "6.2", "a block rocks from edge to edge", rocking_parameters,
                  rocking_block});
  list.push_back(
      {"seesaw", "5.4", "a loaded plank on a narrow pivot tips", seesaw_parameters, seesaw});
  list.push_back({"fig6_5", "6.3.1", "figure 6.5: a heavy block keeps two others from tipping",
                  fig6_5_parameters, fig6_5});
  list.push_back({"leaning", "5.3", "planks lean on blocks", leaning_parameters, leaning});
  list.push_back(
      {"table", "5.4", "a table on free legs with a box on it", table_parameters, table});
}

}  // namespace tumble::recipes
