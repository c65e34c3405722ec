/// \file
/// \brief Scenes of many boxes in motion.
#include "tumble/base/error.hpp"
#include "tumble/scenes/recipes.hpp"

namespace tumble::recipes {
namespace {

Parameters clump_parameters() {
  return with_surface(
      {whole("per_edge", 5, 1, 20, "cubes along each edge of the grid they start on"),
       number("spacing", 2.0, 1.75, 100.0, "m", "distance of centres at the start"),
       number("speed", 2.0, 0.0, 100.0, "m/s", "speed of each cube at the start"),
       word("toward", {"axis", "origin"}, "target of the flight: the vertical axis or the origin")},
      0.5, 0.0);
}

// As the caption of the figure says.
Parameters fig6_7_parameters() {
  Parameters p = clump_parameters();
  p.set("toward", "origin");
  return p;
}

Scene clump(const Parameters& p, Random random) {
  Scene scene{.title = "cubes that fly together and settle (figure 6.7)"};
  build_clump(p.count("per_edge"), p.number("spacing"), random, scene);
  for (SceneBox& box : scene.boxes) {
    Vec3 inward = -box.position_w;
    if (p.word("toward") == "axis") inward.y() = 0.0;
    const double length = inward.norm();
    if (length > 0.0) box.velocity_w = p.number("speed") / length * inward;
  }
  add_bouncing_ground(p, scene);
  return scene;
}

Parameters projectile_parameters() {
  return with_surface(
      {word("target", {"pyramid", "clump"}, "target of the shot"),
       whole("rows", 10, 1, 100, "rows of the pyramid"),
       whole("per_edge", 4, 1, 20, "cubes along each edge of the clump's grid"),
       number("mass", 5.0, 1e-3, 1e6, "kg", "mass of the projectile"),
       number("speed", 20.0, 0.0, 1e3, "m/s", "speed of the projectile"),
       number("height", 3.5, 0.5, 1e3, "m", "height of the projectile's centre"),
       number("distance", 5.0, 1.5, 1e3, "m", "distance from the projectile to the target"),
       number("appears", 2.0, 0.0, 1e3, "s", "time of the shot")},
      0.5, 0.0);
}

Scene projectile(const Parameters& p, Random random) {
  Scene scene;
  scene.title = "a cube shot at a " + p.word("target") + " (figure 6.6)";
  if (p.word("target") == "pyramid") {
    build_pyramid(p.count("rows"), 1.05, scene);
  } else {
    build_clump(p.count("per_edge"), 2.0, random, scene);
  }
  double near_side = 0.0;
  for (const SceneBox& box : scene.boxes)
    near_side = std::max(near_side, box.position_w.z() + 0.5 * box.size.norm());
  SceneBox shot =
      box_at("projectile", Vec3::Ones(),
             Vec3(0.0, p.number("height"), near_side + p.number("distance")), p.number("mass"));
  shot.velocity_w = Vec3(0.0, 0.0, -p.number("speed"));
  shot.appears = p.number("appears");
  scene.boxes.push_back(shot);
  add_bouncing_ground(p, scene);
  return scene;
}

Parameters dice_parameters() {
  return with_surface(
      {whole("count", 5, 1, 100, "dice"), number("size", 0.1, 1e-3, 100.0, "m", "edge of a die"),
       number("mass", 0.4, 1e-6, 1e6, "kg", "mass of a die"),
       number("speed", 2.0, 0.0, 100.0, "m/s", "sideways, at the start"),
       number("spin", 15.0, 0.0, 1e3, "rad/s", "at the start, about a random axis")},
      0.3, 0.4);
}

Scene dice(const Parameters& p, Random random) {
  Scene scene{.title = "thrown dice"};
  const double size = p.number("size");
  for (int k = 0; k < p.count("count"); ++k) {
    Random chance = random.fork(static_cast<std::uint64_t>(k));
    SceneBox die =
        box_at(numbered("die", {k + 1}), Vec3::Constant(size),
               size * Vec3(2.0 * (k % 3 - 1), 4.0 + 2.0 * (k / 9), 2.0 * (k / 3 % 3 - 1)),
               p.number("mass"));
    die.orientation_wb = chance.orientation();
    die.velocity_w = Vec3(p.number("speed"), 0.0, 0.0);
    die.angular_velocity_w = p.number("spin") * chance.direction();
    scene.boxes.push_back(die);
  }
  add_bouncing_ground(p, scene);
  return scene;
}

Parameters cage_parameters() {
  return {whole("count", 20, 1, 1000, "cubes"),
          number("room", 2.0, 1.8, 100.0, "m", "edge of the space that each cube has at the start"),
          number("speed", 2.0, 0.0, 1e3, "m/s", "largest component of a cube's velocity"),
          number("spin", 2.0, 0.0, 1e3, "rad/s", "largest component of a cube's angular velocity"),
          number("restitution", 1.0, 0.0, 1.0, "-", "0 sticks, 1 bounces back")};
}

// Cubes in a closed cage without gravity: nothing rests, everything collides.
Scene cage(const Parameters& p, Random random) {
  Scene scene{.title = "cubes in a cage without gravity", .gravity_w = Vec3::Zero()};
  const int count = p.count("count");
  int per_edge = 1;
  while (per_edge * per_edge * per_edge < count) ++per_edge;
  const double inside = per_edge * p.number("room");
  const double thick = 1.0;
  for (int side = 0; side < 6; ++side) {
    const int axis = side / 2;
    SceneBox wall =
        fixed_at(numbered("wall", {side + 1}), Vec3::Constant(inside + 2.0 * thick), Vec3::Zero());
    wall.size[axis] = thick;
    wall.position_w[axis] = (side % 2 == 0 ? -0.5 : 0.5) * (inside + thick);
    scene.boxes.push_back(wall);
  }
  for (int k = 0; k < count; ++k) {
    Random chance = random.fork(static_cast<std::uint64_t>(k));
    const Vec3 cell(k % per_edge, k / per_edge % per_edge, k / (per_edge * per_edge));
    SceneBox box = box_at(numbered("box", {k + 1}), Vec3::Ones(),
                          (cell - Vec3::Constant(0.5 * (per_edge - 1))) * p.number("room"), 1.0);
    box.orientation_wb = chance.orientation();
    box.velocity_w = chance.in_cube(p.number("speed"));
    box.angular_velocity_w = chance.in_cube(p.number("spin"));
    scene.boxes.push_back(box);
  }
  for (SceneBox& box : scene.boxes) {
    box.friction = 0.0;
    box.restitution = p.number("restitution");
  }
  return scene;
}

Parameters toss_parameters() {
  return with_surface({number("size", 0.1048, 1e-3, 100.0, "m", "edge of the cube"),
                       number("mass", 0.37, 1e-6, 1e6, "kg", "mass of the cube")},
                      0.18, 0.125);
}

// Drawn from the ranges of the first twenty measured tosses of a cube (ContactNets: Pfrommer, Halm
// and Posa, CoRL 2020), with its size, mass, friction and restitution. Another size gets heights in
// edges; speeds stay.
Scene toss(const Parameters& p, Random random) {
  Scene scene{.title = "a cube tossed onto a table"};
  SceneBox cube = box_at("cube", Vec3::Constant(p.number("size")), Vec3::Zero(), p.number("mass"));
  cube.position_w.y() = p.number("size") * random.uniform(1.18, 1.57);  // 0.124 to 0.165 m
  cube.orientation_wb = random.orientation();
  const double speed = random.uniform(1.03, 1.35);
  cube.velocity_w = Vec3(speed, random.uniform(-0.18, 0.26), 0.0);
  const double spin = random.uniform(0.6, 6.7);
  cube.angular_velocity_w = spin * random.direction();
  scene.boxes.push_back(cube);
  add_bouncing_ground(p, scene);
  return scene;
}

}  // namespace

void build_clump(int per_edge, double spacing, Random random, Scene& scene) {
  for (int k = 0; k < per_edge * per_edge * per_edge; ++k) {
    Random chance = random.fork(static_cast<std::uint64_t>(k));
    const Vec3 cell(k % per_edge, k / (per_edge * per_edge), k / per_edge % per_edge);
    SceneBox box = box_at(numbered("box", {k + 1}), Vec3::Ones(), Vec3::Zero(), 1.0);
    box.position_w = spacing * (cell - Vec3(0.5 * (per_edge - 1), 0.0, 0.5 * (per_edge - 1)));
    box.position_w.y() += 0.5 * spacing;
    box.orientation_wb = chance.orientation();
    scene.boxes.push_back(box);
  }
}

void add_thrown(std::vector<SceneRecipe>& list) {
  list.push_back({"clump", "6.1", "cubes fly together and settle", clump_parameters, clump});
  list.push_back({"projectile", "6.1", "a cube is shot at a pyramid or a clump",
                  projectile_parameters, projectile});
  list.push_back({"fig6_6", "6.1", "figure 6.6: a cube is shot at the pyramid",
                  projectile_parameters, projectile});
  list.push_back({"fig6_7", "6.1", "figure 6.7: cubes fly towards the origin and settle",
                  fig6_7_parameters, clump});
  list.push_back({"dice", "4.2", "thrown dice", dice_parameters, dice});
  list.push_back(
      {"toss", "4.2", "a cube tossed onto a table, like measured ones", toss_parameters, toss});
  list.push_back({"cage", "3.3.1", "cubes in a cage without gravity", cage_parameters, cage});
}

}  // namespace tumble::recipes
