/// \file
/// \brief Scenes of one box, or of a few that meet once.
#include "tumble/base/error.hpp"
#include "tumble/math/rotation.hpp"
#include "tumble/scenes/recipes.hpp"

#include <string>

namespace tumble::recipes {
namespace {

Parameters box_drop_parameters() {
  return with_surface(
      {number("height", 1.0, 0.0, 1e4, "m", "height of the lowest corner over the ground"),
       number("size", 1.0, 1e-3, 1e3, "m", "edge of the cube"),
       number("tilt", 30.0, -180.0, 180.0, "deg", "rotation about the z axis")},
      0.5, 0.0);
}

// How far a cube that is turned about z reaches below its centre.
double reach_below(const SceneBox& box) {
  return reach(make_box(Vec3::Zero(), box.orientation_wb, box.size), Vec3::UnitY());
}

Scene box_drop(const Parameters& p, Random) {
  Scene scene{.title = "a cube dropped on an edge"};
  SceneBox box = box_at("cube", Vec3::Constant(p.number("size")), Vec3::Zero(), 1.0);
  box.orientation_wb = rotation_from_degrees(Vec3(0.0, 0.0, p.number("tilt")));
  box.position_w.y() = p.number("height") + reach_below(box);
  scene.boxes.push_back(box);
  add_bouncing_ground(p, scene);
  return scene;
}

Parameters bouncing_box_parameters() {
  return {number("height", 1.0, 0.0, 1e4, "m", "height of the lower face over the ground"),
          number("size", 1.0, 1e-3, 1e3, "m", "edge of the cube"),
          number("restitution", 0.9, 0.0, 1.0, "-", "0 sticks, 1 bounces back")};
}

Scene bouncing_box(const Parameters& p, Random) {
  Scene scene{.title = "a cube dropped flat on the ground"};
  SceneBox box = box_at("cube", Vec3::Constant(p.number("size")),
                        Vec3(0.0, p.number("height") + 0.5 * p.number("size"), 0.0), 1.0);
  box.restitution = p.number("restitution");
  scene.ground = SceneGround{0.5, p.number("restitution")};
  scene.boxes.push_back(box);
  return scene;
}

Parameters tumbling_box_parameters() {
  return {
      number("spin_x", 0.01, -100.0, 100.0, "rad/s", "angular velocity about the longest edge"),
      number("spin_y", 5.0, -100.0, 100.0, "rad/s", "angular velocity about the middle edge"),
      number("spin_z", 0.02, -100.0, 100.0, "rad/s", "angular velocity about the shortest edge")};
}

// Spinning about its middle axis a free body turns over again and again (Dzhanibekov).
Scene tumbling_box(const Parameters& p, Random) {
  Scene scene{.title = "a free box of three different edges, spinning about the middle one",
              .gravity_w = Vec3::Zero()};
  SceneBox box = box_at("box", Vec3(3.0, 2.0, 1.0), Vec3::Zero(), 12.0);
  box.angular_velocity_w = Vec3(p.number("spin_x"), p.number("spin_y"), p.number("spin_z"));
  scene.boxes.push_back(box);
  return scene;
}

Parameters two_boxes_parameters() {
  return {
      number("speed", 2.0, 0.0, 1e3, "m/s", "speed of the left cube"),
      number("offset", 0.75, -1.4, 1.4, "m", "height of the right box's centre over the left's"),
      number("gap", 1.0, 0.0, 1e3, "m", "gap between the faces at the start"),
      number("restitution", 0.5, 0.0, 1.0, "-", "0 sticks, 1 bounces back"),
      number("friction", 0.0, 0.0, 10.0, "-", "Coulomb coefficient")};
}

Scene two_boxes(const Parameters& p, Random) {
  Scene scene{.title = "a cube flies into a heavier box, off its centre",
              .gravity_w = Vec3::Zero()};
  scene.boxes = {box_at("left", Vec3::Ones(), Vec3::Zero(), 1.0),
                 box_at("right", Vec3(1.0, 2.0, 1.0),
                        Vec3(1.0 + p.number("gap"), p.number("offset"), 0.0), 3.0)};
  scene.boxes[0].velocity_w.x() = p.number("speed");
  set_surfaces(p, scene);
  return scene;
}

Parameters crate_parameters() {
  return with_surface(
      {number("speed", 3.5, 0.0, 100.0, "m/s", "speed of the crate along the table")}, 0.3, 0.1);
}

// The example with which the thesis opens (1.1).
Scene crate_off_table(const Parameters& p, Random) {
  Scene scene{.title = "a crate slides along a table and tumbles over its edge"};
  scene.boxes = {fixed_at("table", Vec3(2.0, 0.8, 1.2), Vec3(0.0, 0.4, 0.0)),
                 box_at("crate", Vec3(0.4, 0.3, 0.3), Vec3(-0.6, 0.95, 0.0), 2.0)};
  scene.boxes[1].velocity_w.x() = p.number("speed");
  add_bouncing_ground(p, scene);
  return scene;
}

Parameters cradle_parameters() {
  return {whole("count", 5, 2, 1000, "cubes in all"),
          whole("moving", 1, 1, 999, "cubes that arrive together from the left, fewer than count"),
          number("restitution", 1.0, 0.0, 1.0, "-", "0 sticks, 1 bounces back"),
          number("gap", 0.5, 0.0, 100.0, "m", "gap between the arriving cubes and the row")};
}

// Newton's cradle without strings: cubes in a row that touch, in free space.
Scene cradle(const Parameters& p, Random) {
  Scene scene{.title = "Newton's cradle", .gravity_w = Vec3::Zero()};
  const std::string count = std::to_string(p.count("count"));
  require::that(p.count("moving") < p.count("count"),
                "moving = " + std::to_string(p.count("moving")) +
                    ": expected fewer than count = " + count + ", so that there is a cube to hit");
  for (int k = 0; k < p.count("count"); ++k) {
    const bool arrives = k < p.count("moving");
    SceneBox box = box_at(numbered("ball", {k + 1}), Vec3::Ones(),
                          Vec3(k - (arrives ? p.number("gap") : 0.0), 0.0, 0.0), 1.0);
    box.velocity_w.x() = arrives ? 1.0 : 0.0;
    box.restitution = p.number("restitution");
    box.friction = 0.0;
    scene.boxes.push_back(box);
  }
  return scene;
}

}  // namespace

void add_single(std::vector<SceneRecipe>& list) {
  list.push_back({"box_drop", "2.1", "a cube dropped on an edge", box_drop_parameters, box_drop});
  list.push_back({"bouncing_box", "2.1, 4.3", "a cube dropped flat, bouncing",
                  bouncing_box_parameters, bouncing_box});
  list.push_back({"tumbling_box", "3.1", "a free box spinning about its middle axis",
                  tumbling_box_parameters, tumbling_box});
  list.push_back({"two_boxes", "3.3.2", "a cube hits a heavier box off its centre",
                  two_boxes_parameters, two_boxes});
  list.push_back(
      {"crate_off_table", "1.1", "a crate slides off a table", crate_parameters, crate_off_table});
  list.push_back({"cradle", "3.3.1", "Newton's cradle of cubes", cradle_parameters, cradle});
}

}  // namespace tumble::recipes
