/// \file
/// \brief Scenes in which some boxes cannot move, whatever presses on them (thesis 5.4).
#include "tumble/base/error.hpp"
#include "tumble/math/rotation.hpp"
#include "tumble/scenes/recipes.hpp"

#include <array>
#include <cstddef>
#include <numbers>
#include <string>

namespace tumble::recipes {
namespace {

constexpr double kRadiansPerDegree = std::numbers::pi / 180.0;

// Everything is as heavy as it is large: 1 kg/m³.
SceneBox solid_at(const std::string& name, const Vec3& size, const Vec3& position_w) {
  return box_at(name, size, position_w, size.x() * size.y() * size.z());
}

Quat about_vertical(double degrees) {
  return rotation_from_vector(Vec3(0.0, degrees * kRadiansPerDegree, 0.0));
}

Parameters fig5_3_parameters() {
  return {number("shift", 0.6, 0.0, 0.8, "m",
                 "shift of the top cube, along x and along -z; tips above 0.5"),
          number("yaw", 20.0, -45.0, 45.0, "deg", "angle of the top cube about the vertical"),
          friction()};
}

// At 20 degrees one lower corner is over the bottom cube if shift is from 0.21 to 0.79. The corner
// of the bottom cube at (0.5, -0.5) is under the top one at all settings, and where the centre of the
// top cube is over the bottom one, it stands.
Scene fig5_3(const Parameters& p, Random) {
  Scene scene{.title = "a cube with one corner on another cube (figure 5.3)"};
  const double shift = p.number("shift");
  scene.boxes = {solid_at("bottom", Vec3::Ones(), Vec3(0.0, 0.5, 0.0)),
                 solid_at("top", Vec3::Ones(), Vec3(shift, 1.5, -shift))};
  scene.boxes[1].orientation_wb = about_vertical(p.number("yaw"));
  add_ground(p, scene);
  return scene;
}

Parameters fig5_4_parameters() {
  return {number("offset", 0.0, -0.5, 0.5, "m", "offset of the top cube from the middle, along x"),
          number("speed", 0.0, -100.0, 100.0, "m/s", "speed of the top cube along x at the start"),
          friction()};
}

// At both ends of its range of offsets a face of the top cube is over one of the bottom box.
Scene fig5_4(const Parameters& p, Random) {
  Scene scene{.title = "a cube whole on a larger box (figure 5.4)"};
  scene.boxes = {solid_at("bottom", Vec3(2.0, 1.0, 2.0), Vec3(0.0, 0.5, 0.0)),
                 solid_at("top", Vec3::Ones(), Vec3(p.number("offset"), 1.5, 0.0))};
  scene.boxes[1].velocity_w = Vec3(p.number("speed"), 0.0, 0.0);
  add_ground(p, scene);
  return scene;
}

Parameters fig5_5_parameters() {
  return {number("gap", 0.4, 0.0, 0.8, "m", "gap between the two bottom boxes; 0: they touch"),
          number("yaw", 0.0, -30.0, 30.0, "deg", "angle of the top box about the vertical"),
          friction()};
}

// At all settings each bottom box is under two of the top one's lower corners.
Scene fig5_5(const Parameters& p, Random) {
  Scene scene{.title = "a box on two others (figure 5.5)"};
  const Vec3 bottom(1.0, 1.0, 2.0);
  const double aside = 0.5 * (bottom.x() + p.number("gap"));
  scene.boxes = {solid_at("left", bottom, Vec3(-aside, 0.5, 0.0)),
                 solid_at("right", bottom, Vec3(aside, 0.5, 0.0)),
                 solid_at("top", Vec3(1.5, 1.0, 0.8), Vec3(0.0, 1.5, 0.0))};
  scene.boxes[2].orientation_wb = about_vertical(p.number("yaw"));
  add_ground(p, scene);
  return scene;
}

Parameters fig5_6_parameters() {
  return with_scatter(
      {whole("rows", 11, 3, 99, "boxes in the lowest row before one is taken out; an odd number"),
       number("gap", 0.05, 0.0, 0.9, "-",
              "gap between neighbours in a row, in edges; 0: they touch"),
       friction()});
}

// Its boxes have the names that they have in the whole pyramid.
Scene fig5_6(const Parameters& p, Random random) {
  const int rows = p.count("rows");
  const std::string given = std::to_string(rows);
  require::that(rows % 2 == 1, "rows = " + given + ": a bottom row of " + given +
                                   " has no centre box; give an odd number");
  Scene scene;
  scene.title = "a flat pyramid of " + given + " rows without its bottom centre box (figure 5.6)";
  build_pyramid(rows, 1.0 + p.number("gap"), scene);
  scene.boxes.erase(scene.boxes.begin() + rows / 2);
  add_ground(p, scene);
  scatter(p, random, scene);
  return scene;
}

Parameters fig6_4_parameters() {
  return {whole("count", 5, 1, 100, "blocks on the base"),
          word("pattern", {"to_and_fro", "staircase"},
               "direction of shifts: right, left, left, right and so on, or always right"),
          number("overhang", 0.25, 0.0, 0.99, "-",
                 "overhang from each block to the one on it, in lengths of a block"),
          friction()};
}

// Blocks upon one block stand if the centre of all of them is over the face that they stand on. To
// and fro, five blocks stand up to an overhang of 3/8: those from the third up have their centre
// overhang/3 to the left of it, and the second reaches to overhang - 1/2. A staircase of N blocks
// stands up to 1/N.
Scene fig6_4(const Parameters& p, Random) {
  Scene scene;
  const int count = p.count("count");
  scene.title = "a series of " + std::to_string(count) + " shifted blocks on a base (figure 6.4)";
  scene.boxes.push_back(solid_at("base", Vec3(2.0, 0.5, 2.0), Vec3(0.0, 0.25, 0.0)));
  const bool staircase = p.word("pattern") == "staircase";
  constexpr std::array<int, 4> kToAndFro = {0, 1, 0, -1};  // in overhangs
  for (int k = 0; k < count; ++k) {
    const int aside = staircase ? k : kToAndFro[static_cast<std::size_t>(k % 4)];
    scene.boxes.push_back(solid_at(numbered("block", {k + 1}), Vec3(1.0, 0.5, 1.0),
                                   Vec3(aside * p.number("overhang"), 0.5 * k + 0.75, 0.0)));
  }
  add_ground(p, scene);
  return scene;
}

}  // namespace

void add_stability(std::vector<SceneRecipe>& list) {
  list.push_back({"fig5_3", "5.4", "figure 5.3: a cube with one corner on another cube",
                  fig5_3_parameters, fig5_3});
  list.push_back(
      {"fig5_4", "5.4", "figure 5.4: a cube whole on a larger box", fig5_4_parameters, fig5_4});
  list.push_back(
      {"fig5_5", "5.4", "figure 5.5: a box across two others", fig5_5_parameters, fig5_5});
  list.push_back({"fig5_6", "5.4", "figure 5.6: a flat pyramid without its bottom centre box",
                  fig5_6_parameters, fig5_6});
  list.push_back({"fig6_4", "6.3.1", "figure 6.4: a series of shifted blocks, as if one",
                  fig6_4_parameters, fig6_4});
}

}  // namespace tumble::recipes
