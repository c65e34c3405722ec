/// \file
/// \brief Boxes on the ground: which corners touch, and how deep.
#include "tumble/geometry/ground.hpp"

#include "geometry/boxes.hpp"
#include "support/pose.hpp"
#include "support/test.hpp"

namespace {

const ManifoldPoint& point(const Manifold& m, int i) { return m.points[idx(i)]; }

}  // namespace

TEST_CASE("A box flat on the ground touches with the four corners of its lower face",
          "[exact][ground]") {
  Manifold m;
  REQUIRE(collide_with_ground(make_box({1, 0.5, 2}, Quat::Identity(), {2, 1, 3}), 0.0, m));
  CHECK(m.count == 4);
  CHECK(m.normal_w == Vec3::UnitY());
  CHECK(m.axis == kNoAxis);
  Vec3 middle = Vec3::Zero();
  for (int i = 0; i < 4; ++i) {
    CHECK(point(m, i).distance == 0.0);
    CHECK(point(m, i).position_w.y() == 0.0);
    middle += 0.25 * point(m, i).position_w;
    // In order around the area: neighbours differ in one coordinate.
    const Vec3 side = point(m, (i + 1) % 4).position_w - point(m, i).position_w;
    CHECK(std::min(std::abs(side.x()), std::abs(side.z())) == 0.0);
  }
  CHECK(middle == Vec3(1, 0, 2));
}

TEST_CASE("A cube on an edge touches in two points, on a corner in one, above the ground in none",
          "[exact][ground]") {
  Manifold m;
  const double low = std::sqrt(0.5);
  const Quat on_edge = about(Vec3::UnitX(), M_PI_4);
  CHECK(collide_with_ground(make_box({0, low - 1e-6, 0}, on_edge, Vec3::Ones()), 0.0, m));
  CHECK(m.count == 2);
  // Space diagonal upright: half of it is below the centre.
  const Quat on_corner = test::on_corner();
  const double reach_down = std::sqrt(0.75);
  CHECK(collide_with_ground(make_box({0, reach_down - 1e-6, 0}, on_corner, Vec3::Ones()), 0.0, m));
  CHECK(m.count == 1);
  CHECK(point(m, 0).distance == near(-1e-6, 1e-15));
  CHECK(point(m, 0).position_w.head<1>().norm() < 1e-15);
  CHECK_FALSE(
      collide_with_ground(make_box({0, reach_down + 1e-6, 0}, on_corner, Vec3::Ones()), 0.0, m));
  CHECK(m.count == 0);
}

TEST_CASE("The margin keeps corners up to that height and no higher", "[unit][ground]") {
  // Tilted by 0.01 rad about z: the corners of the lower face are about 0.01 apart in height.
  const Box box = make_box({0, 0.505, 0}, about(Vec3::UnitZ(), 0.01), Vec3::Ones());
  Manifold m;
  collide_with_ground(box, 0.001, m);
  CHECK(m.count == 2);
  collide_with_ground(box, 0.02, m);
  CHECK(m.count == 4);
  for (int i = 0; i < m.count; ++i) CHECK(point(m, i).distance <= 0.02);
}

TEST_CASE("The lowest corner of any box is among its points", "[unit][ground]") {
  Random random(1);
  int missed = 0, doubled = 0, misplaced = 0, touching = 0;
  for (int n = 0; n < 20000; ++n) {
    const Quat q = random.orientation();
    const Vec3 size = random.in_cube(1.0).cwiseAbs() + Vec3::Constant(0.01);
    const Vec3 center = random.in_cube(0.6);
    const Box box = make_box(center, q, size);
    double lowest = kInfinity;
    for (const Vec3& corner : corners_of(box)) lowest = std::min(lowest, corner.y());
    Manifold m;
    const bool touches = collide_with_ground(box, 0.01, m);
    if (touches != (lowest <= 0.01)) ++missed;
    if (!touches) continue;
    ++touching;
    double found = kInfinity;
    std::set<FeatureId> names;
    for (int i = 0; i < m.count; ++i) {
      found = std::min(found, point(m, i).distance);
      names.insert(point(m, i).feature);
      const Vec3 corner = corner_of(box, static_cast<int>(point(m, i).feature));
      const Vec3 halfway(corner.x(), 0.5 * corner.y(), corner.z());
      if (point(m, i).position_w != halfway || point(m, i).distance != corner.y()) ++misplaced;
    }
    if (found != lowest) ++missed;
    if (static_cast<int>(names.size()) != m.count) ++doubled;
  }
  CHECK(touching > 5000);
  CHECK(missed == 0);
  CHECK(doubled == 0);
  CHECK(misplaced == 0);
}

TEST_CASE("A negative or infinite margin above the ground is refused", "[unit][ground]") {
  Manifold m;
  const Box box;
  CHECK_THROWS_WITH(collide_with_ground(box, -1.0, m), Contains("margin = -1"));
  CHECK_THROWS_AS(collide_with_ground(box, kInfinity, m), std::invalid_argument);
  CHECK_THROWS_AS(collide_with_ground(box, kNan, m), std::invalid_argument);
}
