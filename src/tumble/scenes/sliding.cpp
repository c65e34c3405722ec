/// \file
/// \brief Scenes of boxes that slide.
#include "tumble/math/elementary.hpp"
#include "tumble/math/rotation.hpp"
#include "tumble/scenes/recipes.hpp"

#include <numbers>

namespace tumble::recipes {
namespace {

Parameters slide_parameters() {
  return {number("speed", 3.0, 0.0, 1e3, "m/s", "speed of the box at the start"),
          number("heading", 0.0, -180.0, 180.0, "deg",
                 "direction of the speed, from the x axis towards -z"),
          number("width", 1.0, 1e-3, 1e3, "m", "width of the box, along x and z"),
          number("height", 0.2, 1e-3, 1e3, "m", "height of the box"),
          number("friction", 0.3, 0.0, 10.0, "-", "Coulomb coefficient")};
}

// It stops after v²/(2 μ g).
Scene slide(const Parameters& p, Random) {
  Scene scene{.title = "a box slides on the ground and stops"};
  const double heading = p.number("heading") * std::numbers::pi / 180.0;
  SceneBox box = box_at("box", Vec3(p.number("width"), p.number("height"), p.number("width")),
                        Vec3(0.0, 0.5 * p.number("height"), 0.0), 1.0);
  box.velocity_w =
      p.number("speed") * Vec3(elementary::cos(heading), 0.0, -elementary::sin(heading));
  scene.boxes.push_back(box);
  add_ground(p, scene);
  return scene;
}

Parameters slope_parameters() {
  return {
      number("angle", 30.0, 0.0, 80.0, "deg", "angle of the slope, down along x"),
      number("speed", 0.0, -100.0, 100.0, "m/s", "speed of the box down the slope at the start"),
      number("width", 1.0, 1e-3, 5.0, "m", "width of the box, along the slope"),
      number("height", 0.2, 1e-3, 1e3, "m", "height of the box"),
      number("friction", 0.3, 0.0, 10.0, "-", "Coulomb coefficient")};
}

// The middle of the slope's face is the origin. The box slides down above atan μ and tips over its
// lower edge above atan(width/height).
Scene slope(const Parameters& p, Random) {
  Scene scene{.title = "a box on a slope"};
  const double angle = p.number("angle") * std::numbers::pi / 180.0;
  const Vec3 along(elementary::cos(angle), -elementary::sin(angle), 0.0);
  const Vec3 up(-along.y(), along.x(), 0.0);
  const Vec3 board_size(40.0, 1.0, 4.0);
  SceneBox board = fixed_at("slope", board_size, -0.5 * board_size.y() * up);
  SceneBox box = box_at("box", Vec3(p.number("width"), p.number("height"), 1.0),
                        0.5 * p.number("height") * up, 1.0);
  box.velocity_w = p.number("speed") * along;
  for (SceneBox* b : {&board, &box}) {
    b->orientation_wb = rotation_from_degrees(Vec3(0.0, 0.0, -p.number("angle")));
    b->friction = p.number("friction");
  }
  scene.boxes = {board, box};
  return scene;
}

Parameters fig5_2_parameters() {
  return {number("speed", 2.0, 0.0, 3.0, "m/s", "speed of A at the start; B is at rest"),
          number("mass", 1.0, 1e-3, 1e3, "kg", "mass of A"),
          number("lower_mass", 2.0, 1e-3, 1e3, "kg", "mass of B"),
          number("friction", 0.5, 0.0, 10.0, "-", "Coulomb coefficient of A and B"),
          number("ground_friction", 0.0, 0.0, 10.0, "-",
                 "Coulomb coefficient of the ground; B on the ground has the root of the product "
                 "of both")};
}

// A slows down and B is dragged along: on ground without friction both end at the speed
// m_A v/(m_A + m_B), which a friction that only slows bodies down cannot do.
Scene fig5_2(const Parameters& p, Random) {
  Scene scene{.title = "a block slides on a block that is free to move (figure 5.2)"};
  SceneBox lower = box_at("B", Vec3(4.0, 0.4, 1.0), Vec3(0.0, 0.2, 0.0), p.number("lower_mass"));
  SceneBox upper = box_at("A", Vec3(0.6, 0.4, 0.6), Vec3(-1.5, 0.6, 0.0), p.number("mass"));
  upper.velocity_w = Vec3(p.number("speed"), 0.0, 0.0);
  for (SceneBox* box : {&lower, &upper}) box->friction = p.number("friction");
  scene.ground = SceneGround{p.number("ground_friction"), 0.0};
  scene.boxes = {lower, upper};
  return scene;
}

Parameters sled_parameters() {
  return {number("speed", 1.0, 0.0, 100.0, "m/s",
                 "speed of the sled at the start; its load is at rest"),
          whole("count", 2, 1, 100, "boxes on the sled, on top of each other"),
          number("sled_mass", 4.0, 1e-3, 1e3, "kg", "mass of the sled; a box has 1 kg"),
          number("friction", 0.5, 0.0, 10.0, "-", "Coulomb coefficient of sled and boxes"),
          number("ground_friction", 0.0, 0.0, 10.0, "-",
                 "Coulomb coefficient of the ground; the sled on the ground has the root of the "
                 "product of both")};
}

// Friction has to be handed on from box to box for the upper ones to come along. The boxes are
// flat, so that they slide and do not topple.
Scene sled(const Parameters& p, Random) {
  Scene scene{.title = "a stack on a sled"};
  SceneBox sledge = box_at("sled", Vec3(3.0, 0.2, 1.0), Vec3(0.0, 0.1, 0.0), p.number("sled_mass"));
  sledge.velocity_w = Vec3(p.number("speed"), 0.0, 0.0);
  scene.boxes.push_back(sledge);
  for (int k = 0; k < p.count("count"); ++k)
    scene.boxes.push_back(
        box_at(numbered("load", {k + 1}), Vec3(1.0, 0.2, 0.8), Vec3(0.5, 0.3 + 0.2 * k, 0.0), 1.0));
  for (SceneBox& box : scene.boxes) box.friction = p.number("friction");
  scene.ground = SceneGround{p.number("ground_friction"), 0.0};
  return scene;
}

}  // namespace

void add_sliding(std::vector<SceneRecipe>& list) {
  list.push_back(
      {"slide", "2.6, 5.3", "a box slides on the ground and stops", slide_parameters, slide});
  list.push_back({"slope", "2.6, 5.3", "a box on a slope: it rests, slides or tips over",
                  slope_parameters, slope});
  list.push_back({"fig5_2", "5.3", "figure 5.2: a block slides on one that is free to move",
                  fig5_2_parameters, fig5_2});
  list.push_back({"sled", "5.3", "a sled is pulled away under a stack", sled_parameters, sled});
}

}  // namespace tumble::recipes
