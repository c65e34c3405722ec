/// \file
/// \brief Normals and points of overlapping pairs, by each rule, at poses checked by hand.
#include "tumble/impulse_damped/pair_gatherer.hpp"

#include "support/test.hpp"

namespace {

BodyId add_cube(World& world, const Vec3& position_w, const Quat& q = Quat::Identity(),
                const Vec3& size = Vec3::Ones()) {
  return world.add(box_properties(size, 1.0, 0.5, 0.9), position_w, q);
}

// What one rule finds between poses of the step's start and now.
ContactList gathered(const World& last, const World& now, NormalRule normals,
                     PointRule points = PointRule::one) {
  PairGatherer gatherer(normals, points);
  ContactList out;
  gatherer.gather(now, last.states(), now.states(), nullptr, 0.0, out);
  return out;
}

constexpr std::array<NormalRule, 3> kRules{NormalRule::last_face, NormalRule::separation,
                                           NormalRule::signed_distance};

}  // namespace

TEST_CASE("All rules push a box upwards that has sunk into another one",
          "[exact][impulse_damped]") {
  World last;
  add_cube(last, Vec3(0.0, 0.5, 0.0));
  add_cube(last, Vec3(0.3, 1.5, 0.1));
  World now = last;
  now.states()[1].position_w.y() = 1.497;
  for (const NormalRule rule : kRules) {
    const ContactList found = gathered(last, now, rule);
    REQUIRE(found.size() == 1);
    CHECK(found[0].normal_w == Vec3::UnitY());
    CHECK(found[0].restitution == 0.9);
    REQUIRE(found[0].count == 1);
    // The middle of the area in which the faces lie over each other: x from -0.2 to 0.5, z from
    // -0.4 to 0.5. Depths of 3 mm are differences of metres, so weights have an error of 1e-13.
    CHECK((found[0].points[0].position_w - Vec3(0.15, 0.9985, 0.05)).norm() < 1e-12);
    CHECK(found[0].points[0].distance == near(-0.003, 1e-15));
    CHECK(gathered(last, now, rule, PointRule::area)[0].count == 4);
  }
}

TEST_CASE("Boxes of the same size that stand on each other exactly are pushed upwards by all rules",
          "[exact][impulse_damped]") {
  // Their sides are flush: by corners alone, the distance function would point sideways.
  World last;
  add_cube(last, Vec3(0.0, 0.5, 0.0));
  add_cube(last, Vec3(0.0, 1.5, 0.0));
  World now = last;
  now.states()[1].position_w.y() = 1.497;
  for (const NormalRule rule : kRules)
    CHECK(gathered(last, now, rule)[0].normal_w == Vec3::UnitY());
}

TEST_CASE("The last face is wrong once a box has moved on to another face",
          "[reference][impulse_damped]") {
  // When the step began the second box stood beside the first; now it lies a little over its edge.
  World last;
  add_cube(last, Vec3(0.0, 0.5, 0.0));
  add_cube(last, Vec3(1.01, 1.4, 0.0));
  World now = last;
  now.states()[1].position_w = Vec3(0.95, 1.49, 0.0);
  CHECK(gathered(last, now, NormalRule::last_face)[0].normal_w == Vec3::UnitX());
  CHECK(gathered(last, now, NormalRule::separation)[0].normal_w == Vec3::UnitY());
  CHECK(gathered(last, now, NormalRule::signed_distance)[0].normal_w == Vec3::UnitY());
}

TEST_CASE("The last face turns with its body", "[exact][impulse_damped]") {
  World last;
  add_cube(last, Vec3(0.0, 0.0, 0.0));
  add_cube(last, Vec3(0.0, 1.0, 0.0), rotation_from_degrees(Vec3(0.0, 0.0, 20.0)),
           Vec3(0.2, 0.2, 0.2));
  World now = last;
  now.states()[0].orientation_wb = rotation_from_degrees(Vec3(0.0, 0.0, 5.0));
  now.states()[1].position_w.y() = 0.6;
  const ContactList found = gathered(last, now, NormalRule::last_face);
  REQUIRE(found.size() == 1);
  // cos and sin of 5 degrees; one rounding of the matrix
  CHECK((found[0].normal_w - Vec3(-0.08715574274765817, 0.9961946980917455, 0.0)).norm() < 1e-15);
}

TEST_CASE("Where edges cross no face is the exact normal", "[reference][impulse_damped]") {
  World last;
  add_cube(last, Vec3(0.0, 0.0, 0.0), rotation_from_degrees(Vec3(45.0, 0.0, 0.0)));
  add_cube(last, Vec3(0.0, 1.40, 0.0), rotation_from_degrees(Vec3(0.0, 0.0, 45.0)));
  const Vec3 exact = gathered(last, last, NormalRule::separation)[0].normal_w;
  CHECK((exact - Vec3::UnitY()).norm() < 1e-12);  // across both edges; no rounding above 1e-15
  const Vec3 face = gathered(last, last, NormalRule::last_face)[0].normal_w;
  CHECK(face.y() == near(0.7071067811865476, 1e-12));  // 45 degrees off
  // Its middle of an edge lies in the other box, whose nearest face is as far off.
  const Vec3 gradient = gathered(last, last, NormalRule::signed_distance)[0].normal_w;
  CHECK(gradient.y() == near(0.7071067811865476, 1e-12));
}

TEST_CASE("On the ground all rules point up from it and the deepest side counts most",
          "[exact][impulse_damped]") {
  World world = test::ground_world();
  add_cube(world, Vec3(0.0, 0.49, 0.0), rotation_from_degrees(Vec3(0.0, 0.0, 1.0)));
  for (const NormalRule rule : kRules) {
    const ContactList found = gathered(world, world, rule);
    REQUIRE(found.size() == 1);
    CHECK(found[0].normal_w == Vec3::UnitY());
    // Depths of 1.866 cm and 0.121 cm at x = -0.4912 and 0.5086: (-0.4912·1.866 +
    // 0.5086·0.121)/1.987.
    const std::array<Vec3, 8> corners = corners_of(box_of(world.bodies()[1], world.states()[1]));
    double sum = 0.0;
    double weight = 0.0;
    for (const Vec3& c : corners) {
      const double depth = std::max(0.0, -c.y());
      sum += depth * c.x();
      weight += depth;
    }
    CHECK(found[0].points[0].position_w.x() == near(sum / weight, 1e-15));
    CHECK(found[0].points[0].position_w.x() < -0.4);
  }
}

TEST_CASE("Every overlap that the separating axis test sees is gathered, by every rule",
          "[reference][impulse_damped]") {
  Random random(7);
  int overlapping = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    World world;
    const Vec3 a_w = random.in_cube(0.3);
    const Quat a = random.orientation();
    const Vec3 b_w = random.in_cube(1.2);
    const Quat b = random.orientation();
    add_cube(world, a_w, a, Vec3(1.0, 0.5, 0.3));
    add_cube(world, b_w, b, Vec3(0.6, 0.9, 0.4));
    const Separation exact =
        separation(box_of(world.bodies()[0], world.states()[0]),
                   box_of(world.bodies()[1], world.states()[1]), {.prefer_faces = false});
    overlapping += exact.distance < 0.0 ? 1 : 0;
    for (const NormalRule rule : kRules) {
      const ContactList found = gathered(world, world, rule);
      REQUIRE((found.size() == 1) == (exact.distance < 0.0));
      if (found.empty()) continue;
      CHECK(found[0].normal_w.norm() == near(1.0, 1e-14));
      CHECK(found[0].points[0].position_w.allFinite());
    }
  }
  CHECK(overlapping > 300);  // 349
}
