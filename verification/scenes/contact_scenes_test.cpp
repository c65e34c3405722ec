/// \file
/// \brief Scenes in which boxes touch: gaps of 0 at the start, boxes where their settings put them.

#include "support/scenes.hpp"
#include "support/test.hpp"

namespace {

const SceneBox& called(const Scene& scene, const std::string& name) {
  const auto found =
      std::ranges::find_if(scene.boxes, [&](const SceneBox& box) { return box.name == name; });
  REQUIRE(found != scene.boxes.end());
  return *found;
}

double height_over_ground(const SceneBox& box) {
  return box.position_w.y() - reach(shape_of(box), Vec3::UnitY());
}

// [m] The smallest distance of a box from the ground or from another box; below 0 for overlap.
double nearest(const Scene& scene, std::size_t box) {
  double least = kInfinity;
  if (scene.ground) least = height_over_ground(scene.boxes[box]);
  SeparationOptions exact{.prefer_faces = false};
  for (std::size_t k = 0; k < scene.boxes.size(); ++k) {
    if (k == box) continue;
    least = std::min(
        least, separation(shape_of(scene.boxes[box]), shape_of(scene.boxes[k]), exact).distance);
  }
  return least;
}

struct Touching {
  const char* scene;
  Settings settings;
};

}  // namespace

TEST_CASE("In scenes of boxes that rest or slide every movable box touches something exactly",
          "[exact][scenes]") {
  const Touching cases[] = {{"slide", {}},
                            {"slide", {{"heading", "30"}, {"width", "0.3"}}},
                            {"slope", {}},
                            {"slope", {{"angle", "67"}, {"height", "2"}}},
                            {"fig5_2", {}},
                            {"sled", {{"count", "5"}}},
                            {"rocking_block", {{"tilt", "0"}}},
                            {"rocking_block", {{"tilt", "0.25"}}},
                            {"rocking_block", {{"tilt", "1"}, {"width", "1"}}},
                            {"seesaw", {}},
                            {"fig6_5", {{"offset", "0.2"}}},
                            {"leaning", {}},
                            {"leaning", {{"angle", "75"}, {"fixed", "on"}}},
                            {"table", {}},
                            {"stack", {}},
                            {"pyramid3d", {{"rows", "3"}}}};
  for (const Touching& c : cases) {
    const Scene scene = built(c.scene, c.settings);
    for (std::size_t k = 0; k < scene.boxes.size(); ++k) {
      if (scene.boxes[k].fixed) continue;
      INFO(c.scene << ", " << scene.boxes[k].name);
      CHECK(std::abs(nearest(scene, k)) < 1e-13);  // [m] rounding: measured 4e-16
    }
  }
}

TEST_CASE("Boxes of the scenes of contact move as their settings say", "[unit][scenes]") {
  // 30 degrees down: (cos 30, -sin 30). [m/s] rounding.
  const Vec3 down = called(built("slope", {{"speed", "2"}}), "box").velocity_w;
  CHECK((down - Vec3(std::sqrt(3.0), -1.0, 0.0)).norm() < 1e-14);
  const Scene aside = built("slide", {{"speed", "2"}, {"heading", "-90"}});
  CHECK((called(aside, "box").velocity_w - Vec3(0.0, 0.0, 2.0)).norm() < 1e-14);
  CHECK(called(built("fig5_2", {}), "A").velocity_w == Vec3(2.0, 0.0, 0.0));
  CHECK(called(built("fig5_2", {}), "B").velocity_w == Vec3::Zero());
  CHECK(called(built("sled", {}), "sled").velocity_w == Vec3(1.0, 0.0, 0.0));
  CHECK(called(built("sled", {}), "load2").velocity_w == Vec3::Zero());
  // With tilt 1 the centre is above the edge: x = -width/2, as high as half the diagonal.
  const SceneBox on_edge = called(built("rocking_block", {{"tilt", "1"}}), "block");
  CHECK(std::abs(on_edge.position_w.x() + 0.2) < 1e-15);
  CHECK(std::abs(on_edge.position_w.y() - std::hypot(0.2, 1.0)) < 1e-15);
}

TEST_CASE("A scattered pile has its boxes off their places by no more than it says, and no overlap",
          "[unit][scenes]") {
  const double angle = 0.2 * std::numbers::pi / 180.0;
  for (const char* name : {"stack", "pyramid", "pyramid3d", "wall"}) {
    const bool wall = std::string(name) == "wall";
    const Settings sizes = wall ? Settings{{"courses", "4"}, {"bricks", "4"}} : Settings{};
    Scene exact = built(name, sizes);
    Parameters p = scene_recipe(name).parameters();
    for (const auto& [key, value] : sizes) p.set(key, value);
    p.set("scatter", "0.001");
    p.set("scatter_angle", "0.2");
    const Scene scene = checked(scene_recipe(name).build(p, Random(5)));
    REQUIRE(scene.boxes.size() == exact.boxes.size());
    double sideways = 0.0;
    double turned = 0.0;
    for (std::size_t k = 0; k < scene.boxes.size(); ++k) {
      INFO(name << ", " << scene.boxes[k].name);
      const Vec3 off = scene.boxes[k].position_w - exact.boxes[k].position_w;
      sideways = std::max({sideways, std::abs(off.x()), std::abs(off.z())});
      turned = std::max(turned, angle_between(scene.boxes[k].orientation_wb, Quat::Identity()));
      CHECK(off.y() > 0.0);  // what is turned is higher
      const double near_by = nearest(scene, k);
      CHECK(near_by > -1e-12);         // [m] rounding of the sweep
      CHECK(near_by < 0.001 + 1e-12);  // [m] lifted by no more than 1 mm
    }
    CHECK(sideways <= 0.001);
    CHECK(sideways > 0.0005);
    CHECK(turned <= angle * (1.0 + 1e-12));
    CHECK(turned > 0.5 * angle);
  }
}

TEST_CASE("Scatter follows the seed, one stream a box, and is nothing when its settings are 0",
          "[determinism][scenes]") {
  const auto hash = [](const Scene& scene) { return build_world(scene).hash().value(); };
  const Settings scattered = {{"scatter", "0.001"}, {"scatter_angle", "0.2"}};
  CHECK(hash(built("stack", scattered, 1)) == hash(built("stack", scattered, 1)));
  CHECK(hash(built("stack", scattered, 1)) != hash(built("stack", scattered, 2)));
  CHECK(hash(built("stack", {}, 1)) == hash(built("stack", {}, 2)));
  const Scene two = built("stack", {{"count", "2"}, {"scatter", "0.001"}});
  CHECK(two.boxes[0].position_w.x() != two.boxes[1].position_w.x());
  // The lower boxes of a higher stack are those of a lower one.
  const Scene low = built("stack", {{"count", "3"}, {"scatter", "0.001"}});
  const Scene high = built("stack", {{"count", "6"}, {"scatter", "0.001"}});
  for (std::size_t k = 0; k < 3; ++k) CHECK(low.boxes[k].position_w == high.boxes[k].position_w);
}

TEST_CASE("Tosses start within the ranges of the measured ones and above the table",
          "[unit][scenes]") {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    const SceneBox cube = built("toss", {}, seed).boxes.front();
    REQUIRE(cube.velocity_w.x() >= 1.03);
    REQUIRE(cube.velocity_w.x() < 1.35);
    REQUIRE(cube.angular_velocity_w.norm() < 6.7 + 1e-12);
    REQUIRE(height_over_ground(cube) > 0.03);  // [m] 0.1237 less half a diagonal of 0.0908
    REQUIRE(cube.position_w.y() < 0.165);
  }
}
