/// \file
/// \brief Scenes in which boxes that stick to each other turn about a point outside them (thesis 6.2).
#include "tumble/math/elementary.hpp"
#include "tumble/math/rotation.hpp"
#include "tumble/scenes/recipes.hpp"

#include <string>

namespace tumble::recipes {
namespace {

constexpr double kTop = 2.0;  // [m] height of the larger box: room for four boxes to fall beside it

Parameters with_common(Parameters p) {
  p.add(
      number("inset", 0.1, 0.0, 1.0, "m", "distance from the edge of the larger box to the pivot"));
  return p.add(
      number("friction", 10.0, 0.0, 1e3, "-", "Coulomb coefficient of everything: very high"));
}

// The larger box, with its top at kTop and its edge to the right of the pivot; the pivot is at x = 0.
void add_larger(const Parameters& p, Scene& scene) {
  scene.boxes.push_back(
      fixed_at("larger", Vec3(4.0, kTop, 4.0), Vec3(p.number("inset") - 2.0, 0.5 * kTop, 0.0)));
}

// A box that turns about a point of its own, given where that point is and how it moves.
struct Turning {
  Vec3 pivot_w = Vec3::Zero();           // [m]
  Vec3 pivot_velocity_w = Vec3::Zero();  // [m/s]
  double angle = 0.0;                    // [rad] about z, anticlockwise
  double spin = 0.0;                     // [rad/s]
};

SceneBox turning_box(const std::string& name, const Vec3& size, const Vec3& from_pivot_b,
                     const Turning& how) {
  const Quat turned = rotation_from_vector(Vec3(0.0, 0.0, how.angle));
  const Vec3 lever_w = turned * from_pivot_b;
  SceneBox box = box_at(name, size, how.pivot_w + lever_w, size.x() * size.y() * size.z());
  box.orientation_wb = turned;
  box.angular_velocity_w = Vec3(0.0, 0.0, how.spin);
  box.velocity_w = how.pivot_velocity_w + box.angular_velocity_w.cross(lever_w);
  return box;
}

// Cubes on top of each other that lean over their lower right edge as one. The angle is that of the
// centre of all of them, as seen from the edge, from the vertical.
Scene leaning_column(const Parameters& p, int count) {
  Scene scene;
  add_larger(p, scene);
  const double upright = elementary::atan2(0.5, 0.5 * count);  // of a column that stands
  for (int k = 0; k < count; ++k)
    scene.boxes.push_back(turning_box(
        numbered("box", {k + 1}), Vec3::Ones(), Vec3(-0.5, 0.5 + k, 0.0),
        {Vec3(0.0, kTop, 0.0), Vec3::Zero(), -(p.number("angle") + upright), -p.number("spin")}));
  add_ground(p, scene);
  return scene;
}

Parameters fig6_1_parameters() {
  return with_common(
      {whole("count", 4, 2, 20, "boxes in the column; fig6_2 has one"),
       number("angle", 0.3, 0.0, 1.0, "rad",
              "angle of the column's centre, as seen from the pivot, from the vertical"),
       number("spin", 0.0, 0.0, 10.0, "rad/s",
              "angular velocity of the column at the start, falling")});
}

Scene fig6_1(const Parameters& p, Random) {
  Scene scene = leaning_column(p, p.count("count"));
  scene.title = "a column falls over the edge of a larger box (figure 6.1)";
  return scene;
}

Parameters fig6_2_parameters() {
  return with_common(
      {number("angle", 0.3, 0.0, 0.75, "rad",
              "angle of the box's centre, as seen from the pivot, from the vertical"),
       number("spin", 0.0, 0.0, 10.0, "rad/s",
              "angular velocity of the box at the start, falling")});
}

Scene fig6_2(const Parameters& p, Random) {
  Scene scene = leaning_column(p, 1);
  scene.title = "one box falls over the edge of a larger one (figure 6.2)";
  return scene;
}

Parameters fig6_3_parameters() {
  return with_common(
      {number("lower_angle", -0.65, -1.0, -0.5, "rad", "angle of the lower box, anticlockwise"),
       number("upper_angle", -0.2, -0.4, 0.0, "rad", "angle of the upper box, anticlockwise"),
       number("lower_spin", -1.5, -10.0, 0.0, "rad/s",
              "angular velocity of the lower box, anticlockwise"),
       number("upper_spin", 1.5, -10.0, 10.0, "rad/s",
              "angular velocity of the upper box, anticlockwise")});
}

// The lower box turns about its right edge on the larger one; the upper box turns about its left edge
// on the middle of the lower one's top. Each has a centre of rotation of its own, and the upper one's
// moves.
Scene fig6_3(const Parameters& p, Random) {
  Scene scene{.title = "a box rotates on a box that rotates (figure 6.3)"};
  add_larger(p, scene);
  const Turning lower{Vec3(0.0, kTop, 0.0), Vec3::Zero(), p.number("lower_angle"),
                      p.number("lower_spin")};
  scene.boxes.push_back(turning_box("lower", Vec3(1.5, 1.0, 1.0), Vec3(-0.75, 0.5, 0.0), lower));
  const Vec3 lever_w = rotation_from_vector(Vec3(0.0, 0.0, lower.angle)) * Vec3(-0.75, 1.0, 0.0);
  const Turning upper{lower.pivot_w + lever_w, Vec3(0.0, 0.0, lower.spin).cross(lever_w),
                      p.number("upper_angle"), p.number("upper_spin")};
  scene.boxes.push_back(turning_box("upper", Vec3::Ones(), Vec3(0.5, 0.5, 0.0), upper));
  add_ground(p, scene);
  return scene;
}

}  // namespace

void add_turning(std::vector<SceneRecipe>& list) {
  list.push_back({"fig6_1", "6.2", "figure 6.1: a column of boxes falls over an edge as one",
                  fig6_1_parameters, fig6_1});
  list.push_back(
      {"fig6_2", "6.2", "figure 6.2: one box falls over an edge", fig6_2_parameters, fig6_2});
  list.push_back({"fig6_3", "6.2", "figure 6.3: a box rotates on a box that rotates",
                  fig6_3_parameters, fig6_3});
}

}  // namespace tumble::recipes
