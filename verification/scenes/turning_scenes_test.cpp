/// \file
/// \brief Scenes of exterior rotation: what touches, which way it leans, how fast it turns.

#include "support/scenes.hpp"
#include "support/test.hpp"

namespace {

// [m] The deepest overlap of two boxes of a scene.
double deepest_overlap(const Scene& scene) {
  double deepest = 0.0;
  for (std::size_t i = 0; i < scene.boxes.size(); ++i)
    for (std::size_t j = i + 1; j < scene.boxes.size(); ++j)
      deepest = std::max(deepest,
                         -separation(shape_of(scene.boxes[i]), shape_of(scene.boxes[j])).distance);
  return deepest;
}

// A point of a box, given in its frame, and how fast it moves.
Vec3 place_of(const SceneBox& box, const Vec3& point_b) {
  return box.position_w + box.orientation_wb * point_b;
}
Vec3 speed_of(const SceneBox& box, const Vec3& point_w) {
  return box.velocity_w + box.angular_velocity_w.cross(point_w - box.position_w);
}

constexpr double kRounding = 1e-14;  // [m], [m/s]: of numbers up to 10

}  // namespace

TEST_CASE("The column of figure 6.1 leans over the edge by the angle that is asked for",
          "[exact][scenes][exterior_rotation]") {
  for (const int count : {2, 4, 7, 20})
    for (const char* angle : {"0", "0.3", "1"}) {
      INFO(count << " boxes, " << angle << " rad");
      const Scene scene =
          built("fig6_1", {{"count", std::to_string(count)}, {"angle", angle}, {"spin", "2"}});
      REQUIRE(scene.boxes.size() == idx(count) + 1);
      CHECK(scene.boxes[0].fixed);
      Vec3 centre_w = Vec3::Zero();
      for (std::size_t k = 1; k < scene.boxes.size(); ++k)
        centre_w += scene.boxes[k].position_w / count;
      const Vec3 pivot_w(0.0, 2.0, 0.0);
      CHECK(std::atan2(centre_w.x() - pivot_w.x(), centre_w.y() - pivot_w.y()) ==
            near(std::stod(angle), kRounding));
      // The lower right edge of the lowest box is the pivot, on the top of the larger one.
      CHECK((place_of(scene.boxes[1], Vec3(0.5, -0.5, 0.0)) - pivot_w).norm() <= kRounding);
      const SceneBox& larger = scene.boxes[0];
      CHECK(larger.position_w.y() + 0.5 * larger.size.y() == 2.0);
      CHECK(larger.position_w.x() + 0.5 * larger.size.x() == near(0.1, kRounding));
      // All turn as one about it; the lower corner of each is on the upper one of that below.
      for (std::size_t k = 1; k < scene.boxes.size(); ++k) {
        const SceneBox& box = scene.boxes[k];
        CHECK(box.angular_velocity_w == Vec3(0.0, 0.0, -2.0));
        CHECK(speed_of(box, pivot_w).norm() <= 10.0 * kRounding);  // levers up to 20 m
        if (k > 1)
          CHECK((place_of(box, Vec3(0.5, -0.5, 0.5)) -
                 place_of(scene.boxes[k - 1], Vec3(0.5, 0.5, 0.5)))
                    .norm() <= 2.0 * kRounding);
      }
      CHECK(deepest_overlap(scene) <= kRounding);
    }
}

TEST_CASE("Figure 6.2 is the lowest box of a column, leaning by its own angle",
          "[exact][scenes][exterior_rotation]") {
  const Scene one = built("fig6_2", {{"angle", "0.4"}, {"spin", "1.5"}});
  REQUIRE(one.boxes.size() == 2);
  const SceneBox& box = one.boxes[1];
  const Vec3 pivot_w(0.0, 2.0, 0.0);
  CHECK(one.boxes[0].fixed);
  CHECK(std::atan2(box.position_w.x(), box.position_w.y() - 2.0) == near(0.4, kRounding));
  CHECK((place_of(box, Vec3(0.5, -0.5, 0.0)) - pivot_w).norm() <= kRounding);
  CHECK(speed_of(box, pivot_w).norm() <= kRounding);
  CHECK(box.angular_velocity_w == Vec3(0.0, 0.0, -1.5));
  CHECK(deepest_overlap(one) <= kRounding);
  for (const SceneBox& each : one.boxes) CHECK(each.friction == 10.0);
}

TEST_CASE("In figure 6.3 each box turns about an edge of its own, and nothing overlaps",
          "[exact][scenes][exterior_rotation]") {
  const std::vector<Settings> cases = {
      {},
      {{"lower_angle", "-1"}, {"upper_angle", "-0.4"}},
      {{"lower_angle", "-0.5"}, {"upper_angle", "0"}, {"upper_spin", "-3"}},
      {{"lower_angle", "-0.5"}, {"upper_angle", "-0.4"}, {"lower_spin", "0"}},
      {{"lower_angle", "-1"}, {"upper_angle", "0"}, {"inset", "0.5"}}};
  for (const Settings& set : cases) {
    const Scene scene = built("fig6_3", set);
    REQUIRE(scene.boxes.size() == 3);
    const SceneBox& lower = scene.boxes[1];
    const SceneBox& upper = scene.boxes[2];
    const Vec3 pivot_w(0.0, 2.0, 0.0);
    CHECK((place_of(lower, Vec3(0.75, -0.5, 0.0)) - pivot_w).norm() <= kRounding);
    CHECK(speed_of(lower, pivot_w).norm() <= kRounding);
    // The upper one's left edge is on the middle of the lower one's top and moves with it.
    const Vec3 edge_w = place_of(upper, Vec3(-0.5, -0.5, 0.0));
    CHECK((edge_w - place_of(lower, Vec3(0.0, 0.5, 0.0))).norm() <= kRounding);
    CHECK((speed_of(upper, edge_w) - speed_of(lower, edge_w)).norm() <= kRounding);
    CHECK(deepest_overlap(scene) <= kRounding);
  }
  const Scene scene = built("fig6_3");
  CHECK(rotation_vector(scene.boxes[1].orientation_wb).z() == near(-0.65, kRounding));
  CHECK(rotation_vector(scene.boxes[2].orientation_wb).z() == near(-0.2, kRounding));
  CHECK(scene.boxes[1].angular_velocity_w == Vec3(0.0, 0.0, -1.5));
  CHECK(scene.boxes[2].angular_velocity_w == Vec3(0.0, 0.0, 1.5));
}

TEST_CASE("Scenes of exterior rotation refuse what they cannot build",
          "[unit][scenes][exterior_rotation]") {
  for (const char* name : {"fig6_1", "fig6_2"}) {
    CHECK_THROWS_WITH(built(name, {{"angle", "1.5"}}), Contains("angle"));
    CHECK_THROWS_WITH(built(name, {{"spin", "-1"}}), Contains("spin"));
  }
  CHECK_THROWS_WITH(built("fig6_1", {{"count", "0"}}), Contains("count"));
  CHECK_THROWS_WITH(built("fig6_3", {{"lower_angle", "0"}}), Contains("lower_angle"));
}
