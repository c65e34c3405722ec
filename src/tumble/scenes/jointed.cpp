/// \file
/// \brief Scenes with joints: chain, pendulum, crane, plank_bridge (thesis 2.6.5).
#include "tumble/math/elementary.hpp"
#include "tumble/math/rotation.hpp"
#include "tumble/scenes/recipes.hpp"

#include <numbers>
#include <string>

namespace tumble::recipes {
namespace {

// Joins the box that was added last.
void join_last(Scene& scene, const std::string& to, JointKind kind, const Vec3& anchor_w,
               const Vec3& axis_w = Vec3::Zero()) {
  scene.joints.push_back({"", kind, to, scene.boxes.back().name, anchor_w, axis_w});
}

// Links that hang from a box, one from the other, all in a line.
struct Links {
  std::string first_on;             // the box that carries them
  int count = 1;                    // links
  Vec3 from_w = Vec3::Zero();       // [m] where they begin
  Quat turned = Quat::Identity();   // [-] from hanging straight down
  Vec3 size = Vec3(0.1, 0.5, 0.1);  // [m]
  double mass = 1.0;                // [kg] of each
  JointKind kind = JointKind::ball;
  Vec3 axis_w = Vec3::Zero();
};

// Returns where they end.
Vec3 hang(const Links& links, Scene& scene) {
  Vec3 end_w = links.from_w;
  std::string on = links.first_on;
  for (int k = 1; k <= links.count; ++k) {
    const Vec3 down_w = links.turned * Vec3(0.0, -links.size.y(), 0.0);
    SceneBox link = box_at(numbered("link", {k}), links.size, end_w + 0.5 * down_w, links.mass);
    link.orientation_wb = links.turned;
    scene.boxes.push_back(link);
    join_last(scene, on, links.kind, end_w, links.axis_w);
    on = link.name;
    end_w += down_w;
  }
  return end_w;
}

// --- chain and pendulum -----------------------------------------------------------------------------

Parameters hanging(int count, double angle) {
  return {whole("count", count, 1, 1000, "links"),
          number("length", 0.5, 0.01, 100.0, "m", "length of a link"),
          number("angle", angle, -std::numbers::pi, std::numbers::pi, "rad",
                 "angle of all links from hanging straight down, anticlockwise")};
}

Scene hanging_scene(const Parameters& p, JointKind kind) {
  Scene scene;
  const double length = p.number("length");
  const double thick = 0.2 * length;
  const double height = (p.count("count") + 1.0) * length;
  scene.boxes.push_back(fixed_at("hook", Vec3::Constant(thick), Vec3(0.0, height, 0.0)));
  Links links;
  links.first_on = "hook";
  links.count = p.count("count");
  links.from_w = Vec3(0.0, height, 0.0);
  links.turned = rotation_from_vector(Vec3(0.0, 0.0, p.number("angle")));
  links.size = Vec3(thick, length, thick);
  links.kind = kind;
  if (kind == JointKind::hinge) links.axis_w = Vec3::UnitZ();
  hang(links, scene);
  return scene;
}

Parameters chain_parameters() { return hanging(10, 0.6); }

Scene chain(const Parameters& p, Random) {
  Scene scene = hanging_scene(p, JointKind::ball);
  scene.title = "a chain swings from a hook, in ball joints";
  return scene;
}

Parameters pendulum_parameters() { return hanging(2, 2.0); }

Scene pendulum(const Parameters& p, Random) {
  Scene scene = hanging_scene(p, JointKind::hinge);
  scene.title = "a pendulum of links on hinges";
  return scene;
}

// --- crane ------------------------------------------------------------------------------------------

Parameters crane_parameters() {
  return {number("angle", 0.9, 0.0, 1.2, "rad", "how far the wrecking box is pulled back"),
          number("mass", 200.0, 1.0, 1e4, "kg", "mass of the wrecking box"),
          whole("rows", 7, 1, 8, "rows of bricks in the wall"),
          whole("columns", 3, 1, 8, "bricks in a row of the wall"),
          number("friction", 0.5, 0.0, 1e3, "-", "Coulomb coefficient of everything")};
}

// The boom reaches out along x; the box swings along z, from the one side of the boom to the wall on the other.
Scene crane(const Parameters& p, Random) {
  Scene scene{.title = "a crane swings a wrecking box into a wall"};
  constexpr double height = 6.0;  // [m] of the boom's lower side
  constexpr double reach = 3.5;   // [m] of its tip
  scene.boxes.push_back(fixed_at("mast", Vec3(0.5, height, 0.5), Vec3(0.0, 0.5 * height, 0.0)));
  scene.boxes.push_back(box_at("boom", Vec3(4.0, 0.4, 0.4), Vec3(1.75, height + 0.2, 0.0), 100.0));
  join_last(scene, "mast", JointKind::fixed, Vec3(0.0, height, 0.0));
  Links rope;
  rope.first_on = "boom";
  rope.count = 4;
  rope.from_w = Vec3(reach, height, 0.0);
  rope.turned = rotation_from_vector(Vec3(p.number("angle"), 0.0, 0.0));
  rope.size = Vec3(0.1, 0.85, 0.1);
  rope.mass = 5.0;
  const Vec3 end_w = hang(rope, scene);
  SceneBox box = box_at("wrecker", Vec3(0.9, 0.9, 0.9), end_w + rope.turned * Vec3(0.0, -0.45, 0.0),
                        p.number("mass"));
  box.orientation_wb = rope.turned;
  scene.boxes.push_back(box);
  join_last(scene, "link4", JointKind::fixed, end_w);
  const Vec3 brick(0.8, 0.4, 0.4);
  for (int row = 1; row <= p.count("rows"); ++row)
    for (int column = 1; column <= p.count("columns"); ++column) {
      const double shift = row % 2 == 0 ? 0.25 : -0.25;  // courses overlap
      const double x = reach + (column - 0.5 * (p.count("columns") + 1) + shift) * brick.x();
      scene.boxes.push_back(box_at(numbered("brick", {row, column}), brick,
                                   Vec3(x, (row - 0.5) * brick.y(), 0.8), 60.0));
    }
  add_ground(p, scene);
  return scene;
}

// --- plank_bridge -----------------------------------------------------------------------------------

Parameters plank_bridge_parameters() {
  return {
      whole("planks", 8, 2, 100, "planks of the bridge"),
      number("sag", 0.5, 0.1, 1.0, "rad", "slope of the bridge at its ends"),
      number("load", 20.0, 0.1, 1e3, "kg", "mass of the box that falls on it; a plank has 5 kg"),
      number("friction", 0.8, 0.0, 1e3, "-", "Coulomb coefficient of everything")};
}

// The ends of planks lie on an arc.
Scene plank_bridge(const Parameters& p, Random) {
  Scene scene{.title = "a load falls on a bridge of planks in hinges"};
  const int count = p.count("planks");
  const double sag = p.number("sag");
  const Vec3 plank(0.5, 0.1, 1.0);
  const double radius = 0.5 * plank.x() / elementary::sin(sag / count);
  const double height = 0.5 + radius * (1.0 - elementary::cos(sag));  // [m] of its ends
  const auto end_of = [&](int k) -> Vec3 {
    const double angle = sag * (2.0 * k / count - 1.0);
    return Vec3(radius * elementary::sin(angle),
                height + radius * (elementary::cos(sag) - elementary::cos(angle)), 0.0);
  };
  const double half = end_of(count).x();
  for (const double side : {-1.0, 1.0})
    scene.boxes.push_back(
        fixed_at(side < 0.0 ? "left" : "right", Vec3(1.0, height + 0.5 * plank.y(), plank.z()),
                 Vec3(side * (half + 0.5), 0.5 * height + 0.25 * plank.y(), 0.0)));
  std::string on = "left";
  for (int k = 1; k <= count; ++k) {
    const Vec3 from_w = end_of(k - 1), to_w = end_of(k);
    SceneBox box = box_at(numbered("plank", {k}), plank, 0.5 * (from_w + to_w), 5.0);
    box.orientation_wb =
        rotation_from_vector(Vec3(0.0, 0.0, sag * ((2.0 * k - 1.0) / count - 1.0)));
    scene.boxes.push_back(box);
    join_last(scene, on, JointKind::hinge, from_w, Vec3::UnitZ());
    on = box.name;
  }
  join_last(scene, "right", JointKind::hinge, end_of(count), Vec3::UnitZ());
  scene.boxes.push_back(
      box_at("load", Vec3::Constant(0.4), Vec3(0.0, height + 1.0, 0.0), p.number("load")));
  add_ground(p, scene);
  return scene;
}

}  // namespace

void add_jointed(std::vector<SceneRecipe>& list) {
  list.push_back({"chain", "2.6.5", "a chain swings from a hook, in ball joints; for glued",
                  chain_parameters, chain});
  list.push_back({"pendulum", "2.6.5", "a pendulum of links on hinges; for glued",
                  pendulum_parameters, pendulum});
  list.push_back({"crane", "2.6.5",
                  "a crane swings a box into a wall; for glued with contacts=collide",
                  crane_parameters, crane});
  list.push_back({"plank_bridge", "2.6.5",
                  "a load falls on a bridge of planks; for glued with contacts=collide",
                  plank_bridge_parameters, plank_bridge});
}

}  // namespace tumble::recipes
