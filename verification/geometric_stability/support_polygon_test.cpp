/// \file
/// \brief Hulls and distances in the plane, lower corners of a box.
#include "tumble/geometric_stability/support_polygon.hpp"

#include "support/test.hpp"

namespace {

std::vector<Vec2> hull_of(std::vector<Vec2> points) {
  std::vector<Vec2> hull;
  convex_hull(points, hull);
  return hull;
}

double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

// [m] Distance to the nearest of many points of the edges; 0 inside.
double sampled_distance(const std::vector<Vec2>& hull, const Vec2& p) {
  bool inside = true;
  double nearest = kInfinity;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Vec2& a = hull[i];
    const Vec2& b = hull[(i + 1) % hull.size()];
    inside = inside && cross(b - a, p - a) >= 0.0;
    for (int k = 0; k <= 1000; ++k)
      nearest = std::min(nearest, (a + 1e-3 * k * (b - a) - p).norm());
  }
  return inside ? 0.0 : nearest;
}

}  // namespace

TEST_CASE("A hull has the corners and no point within an edge or inside",
          "[exact][geometric_stability]") {
  const std::vector<Vec2> square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  CHECK(hull_of(square) == square);
  CHECK(hull_of({{1, 1}, {0, 1}, {0.5, 1}, {1, 0}, {0.5, 0.5}, {0, 0.25}, {0, 0}, {1, 1}}) ==
        square);
}

TEST_CASE(
    "A hull of points on a line has its two ends, one of a point that point, one of none none",
    "[exact][geometric_stability]") {
  CHECK(hull_of({}).empty());
  CHECK(hull_of({{3, 4}}) == std::vector<Vec2>{{3, 4}});
  CHECK(hull_of({{3, 4}, {3, 4}, {3, 4}, {3, 4}}) == std::vector<Vec2>{{3, 4}});
  CHECK(hull_of({{2, 1}, {0, 0}}) == std::vector<Vec2>{{0, 0}, {2, 1}});
  CHECK(hull_of({{2, 1}, {0, 0}, {4, 2}, {2, 1}}) == std::vector<Vec2>{{0, 0}, {4, 2}});
  CHECK(hull_of({{0, 2}, {0, 0}, {0, 1}, {0, 3}}) == std::vector<Vec2>{{0, 0}, {0, 3}});
}

TEST_CASE("Distances to a square, a line, a point and nothing are the closed forms",
          "[exact][geometric_stability]") {
  const std::vector<Vec2> square{{0, 0}, {2, 0}, {2, 2}, {0, 2}};
  CHECK(distance_to_hull(square, Vec2(1.0, 1.0)) == 0.0);
  CHECK(distance_to_hull(square, Vec2(2.0, 1.0)) == 0.0);
  CHECK(distance_to_hull(square, Vec2(2.0, 2.0)) == 0.0);
  CHECK(distance_to_hull(square, Vec2(1.0, 2.5)) == 0.5);
  CHECK(distance_to_hull(square, Vec2(-3.0, -4.0)) == 5.0);
  CHECK(distance_to_hull(square, Vec2(5.0, 6.0)) == 5.0);
  const std::vector<Vec2> line{{0, 0}, {4, 0}};
  CHECK(distance_to_hull(line, Vec2(1.0, 0.0)) == 0.0);
  CHECK(distance_to_hull(line, Vec2(1.0, -2.0)) == 2.0);
  CHECK(distance_to_hull(line, Vec2(1.0, 2.0)) == 2.0);
  CHECK(distance_to_hull(line, Vec2(7.0, 4.0)) == 5.0);
  const std::vector<Vec2> point{{1, 1}};
  CHECK(distance_to_hull(point, Vec2(4.0, 5.0)) == 5.0);
  CHECK(distance_to_hull(point, Vec2(1.0, 1.0)) == 0.0);
  CHECK(std::isinf(distance_to_hull({}, Vec2::Zero())));
}

TEST_CASE("A margin widens a hull on all sides, and gives nothing to an empty one",
          "[exact][geometric_stability]") {
  const std::vector<Vec2> line{{0, 0}, {4, 0}};
  CHECK(hull_contains(line, Vec2(2.0, 0.5), 0.5));
  CHECK(hull_contains(line, Vec2(4.5, 0.0), 0.5));
  CHECK_FALSE(hull_contains(line, Vec2(4.5, 0.5), 0.5));  // round at the ends: 0.71 away
  CHECK_FALSE(hull_contains({}, Vec2::Zero(), kInfinity));
}

TEST_CASE("Hulls of random points are convex, counterclockwise, and hold every point in any order",
          "[exact][determinism][geometric_stability]") {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    Random random(seed);
    std::vector<Vec2> points;
    const std::uint32_t count = 3 + random.below(12);
    for (std::uint32_t k = 0; k < count; ++k) {
      // Multiples of a quarter: many lie on one line, and cross products have no rounding.
      const double x = 0.25 * random.below(9);
      points.emplace_back(x, 0.25 * random.below(9));
    }
    const std::vector<Vec2> hull = hull_of(points);
    INFO("seed " << seed);
    for (std::size_t i = 0; i < hull.size() && hull.size() >= 3; ++i) {
      const Vec2& b = hull[(i + 1) % hull.size()];
      CHECK(cross(b - hull[i], hull[(i + 2) % hull.size()] - b) > 0.0);
    }
    for (const Vec2& corner : hull) CHECK(std::ranges::find(points, corner) != points.end());
    for (const Vec2& p : points) CHECK(distance_to_hull(hull, p) == 0.0);
    for (std::size_t i = points.size(); i > 1; --i)
      std::swap(points[i - 1], points[random.below(static_cast<std::uint32_t>(i))]);
    CHECK(hull_of(points) == hull);
    if (hull.size() < 3) continue;
    // [m] An edge of at most 2.9 m is sampled every 3 mm; at 0.1 m off that is 11 µm, nearer 1.5 mm.
    for (int k = 0; k < 20; ++k) {
      const double x = random.uniform(-1.0, 3.0);
      const Vec2 p(x, random.uniform(-1.0, 3.0));
      CHECK(std::abs(distance_to_hull(hull, p) - sampled_distance(hull, p)) < 1.5e-3);
    }
  }
}

TEST_CASE("The lower corners of a box are those of the face that looks down, in order around it",
          "[exact][geometric_stability]") {
  const Vec3 half(0.5, 1.0, 2.0);
  // On each of its six faces, and slightly tilted.
  const std::vector<std::pair<Vec3, Vec2>> turns{
      {Vec3(0, 0, 0), Vec2(0.5, 2.0)},  {Vec3(180, 0, 0), Vec2(0.5, 2.0)},
      {Vec3(90, 0, 0), Vec2(0.5, 1.0)}, {Vec3(-90, 0, 0), Vec2(0.5, 1.0)},
      {Vec3(0, 0, 90), Vec2(1.0, 2.0)}, {Vec3(0, 0, -90), Vec2(1.0, 2.0)},
  };
  for (const auto& [degrees, reach] : turns) {
    const Box box{Vec3(3.0, 5.0, -1.0), rotation_from_degrees(degrees).toRotationMatrix(), half};
    const std::array<Vec2, 4> corners = lower_corners(box);
    INFO(degrees.transpose());
    for (std::size_t k = 0; k < 4; ++k) {
      const Vec2 from_centre = corners[k] - Vec2(3.0, -1.0);
      CHECK(std::abs(from_centre.x()) == near(reach.x(), 1e-14));  // [m] rounding
      CHECK(std::abs(from_centre.y()) == near(reach.y(), 1e-14));
      // Neighbours share an edge, so they differ in one coordinate only.
      const Vec2 step = corners[(k + 1) % 4] - corners[k];
      CHECK(std::min(std::abs(step.x()), std::abs(step.y())) == near(0.0, 1e-14));
      CHECK(step.norm() > 0.9);
    }
  }
  // Tilted by 20 degrees about z: the lower face has moved to the right, by sin 20 times 1 m.
  const Box tilted{Vec3::Zero(), rotation_from_degrees(Vec3(0, 0, 20)).toRotationMatrix(), half};
  double sum = 0.0;
  for (const Vec2& corner : lower_corners(tilted)) sum += 0.25 * corner.x();
  CHECK(sum == near(0.34202014332566873, 1e-14));
}
