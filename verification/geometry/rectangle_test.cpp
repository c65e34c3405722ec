/// \file
/// \brief The overlap of rectangles against closed forms, counted points and symmetries.
#include "tumble/geometry/rectangle.hpp"

#include "tumble/base/random.hpp"

#include "support/catch.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>

namespace {

using namespace tumble;

Rectangle rectangle(const Vec2& center, double angle, const Vec2& size) {
  return {center, Vec2(std::cos(angle), std::sin(angle)), 0.5 * size};
}

Rectangle square(double angle = 0.0, const Vec2& center = Vec2::Zero()) {
  return rectangle(center, angle, Vec2::Ones());
}

double overlap_area(const Rectangle& a, const Rectangle& b) { return area(intersection(a, b)); }

bool contains(const Rectangle& r, const Vec2& p) {
  const Vec2 d = p - r.center;
  return std::abs(d.dot(r.axis)) <= r.half.x() &&
         std::abs(d.x() * -r.axis.y() + d.y() * r.axis.x()) <= r.half.y();
}

}  // namespace

TEST_CASE("Two unit squares turned by 45 degrees share an octagon of area 2 sqrt 2 - 2",
          "[exact][rectangle]") {
  const Polygon octagon = intersection(square(), square(M_PI_4));
  CHECK(octagon.count == 8);
  CHECK(area(octagon) == near(2.0 * (std::sqrt(2.0) - 1.0)).margin(1e-15));  // rounding
  CHECK(area(octagon) == near(0.828427124746).margin(1e-12));                // digits given
}

TEST_CASE("Two unit squares turned by 30 degrees share an area of 0.845299461621",
          "[exact][rectangle]") {
  CHECK(overlap_area(square(), square(M_PI / 6.0)) == near(0.845299461621).margin(1e-12));
}

TEST_CASE("Two unit squares offset by 0.3 and 0.2 share an area of 0.56", "[exact][rectangle]") {
  CHECK(overlap_area(square(), square(0.0, {0.3, 0.2})) == near(0.56).margin(1e-15));
  CHECK(intersection(square(), square(0.0, {0.3, 0.2})).count == 4);
}

TEST_CASE("A 2 x 1 rectangle across a 1 x 2 one shares an area of 1", "[exact][rectangle]") {
  CHECK(overlap_area(rectangle({0, 0}, 0.0, {2, 1}), rectangle({0, 0}, 0.0, {1, 2})) ==
        near(1.0).margin(1e-15));
}

TEST_CASE("A 2 x 1 rectangle at 45 degrees over a unit square shares a hexagon of 0.914213562373",
          "[exact][rectangle]") {
  const Polygon hexagon = intersection(square(), rectangle({0, 0}, M_PI_4, {2, 1}));
  CHECK(hexagon.count == 6);
  CHECK(area(hexagon) == near(0.914213562373).margin(1e-12));
}

TEST_CASE("Touching squares share a line of two corners or a single corner", "[exact][rectangle]") {
  CHECK(intersection(square(), square(0.0, {1.0, 0.25})).count == 2);  // edge on edge, shifted
  CHECK(intersection(square(), square(0.0, {1.0, 0.0})).count == 2);   // edge on edge
  CHECK(intersection(square(), square(0.0, {1.0, 1.0})).count == 1);   // corner on corner
  CHECK(intersection(square(), square(M_PI_4, {0.5 + std::sqrt(0.5), 0.1})).count == 1);
  CHECK(intersection(square(), square(0.0, {1.0, 1.001})).count == 0);
  CHECK(area(intersection(square(), square(0.0, {5.0, 0.0}))) == 0.0);
  CHECK(intersection(square(), square()).count == 4);  // identical
}

TEST_CASE("The overlap is the same in both orders, within both and counter-clockwise",
          "[unit][rectangle]") {
  Random random(1);
  double worst = 0.0;
  int outside = 0, clockwise = 0, overlapping = 0;
  for (int n = 0; n < 100000; ++n) {
    const double angle_a = random.uniform(-4.0, 4.0);
    const double turn = random.uniform(-4.0, 4.0);
    // Also parallel and almost parallel ones.
    const double angle_b = n % 3 == 0 ? turn : angle_a + (n % 3 == 1 ? 0.0 : 1e-9 * turn);
    const Vec2 size_a(random.uniform(0.1, 2.0), 1.0), size_b(1.0, random.uniform(0.1, 2.0));
    const Vec3 offset = random.in_cube(1.2);
    const Rectangle a = rectangle({3.0, -2.0}, angle_a, size_a);
    const Rectangle b = rectangle({3.0 + offset.x(), -2.0 + offset.y()}, angle_b, size_b);
    const Polygon one = intersection(a, b);
    worst = std::max(worst, std::abs(area(one) - overlap_area(b, a)));
    if (one.count > 0) ++overlapping;
    if (area(one) < -1e-15) ++clockwise;
    Rectangle wide_a = a, wide_b = b;
    wide_a.half += Vec2::Constant(1e-12);
    wide_b.half += Vec2::Constant(1e-12);
    for (int i = 0; i < one.count; ++i) {
      const Vec2& p = one.corners[static_cast<std::size_t>(i)];
      if (!contains(wide_a, p) || !contains(wide_b, p)) ++outside;
    }
  }
  CHECK(worst < 1e-14);  // rounding at coordinates of 3; measured 3.1e-15
  CHECK(outside == 0);
  CHECK(clockwise == 0);
  CHECK(overlapping > 50000);
}

TEST_CASE("The overlap has the area that counting points in both rectangles gives",
          "[reference][rectangle]") {
  Random random(2);
  const Rectangle a = rectangle({0.2, 0.1}, 0.4, {1.3, 0.7});
  const Rectangle b = rectangle({-0.1, 0.2}, 1.7, {1.1, 0.9});
  int inside = 0;
  constexpr int kPoints = 1000000;
  for (int n = 0; n < kPoints; ++n) {
    const Vec3 p = random.in_cube(1.0);
    if (contains(a, {p.x(), p.y()}) && contains(b, {p.x(), p.y()})) ++inside;
  }
  // Three standard deviations of the count: 4 * 3 * sqrt(0.15 / 1e6) = 0.005. Measured 2e-4.
  CHECK(overlap_area(a, b) == near(4.0 * inside / kPoints).margin(0.005));
}

TEST_CASE("A rectangle that is none is refused", "[unit][rectangle]") {
  Rectangle bad;
  bad.half = Vec2(0.5, 0.0);
  CHECK_THROWS_WITH(intersection(bad, Rectangle()), Catch::Contains("rectangle.half.y"));
  bad = Rectangle();
  bad.axis = Vec2(1.0, 1.0);
  CHECK_THROWS_WITH(intersection(Rectangle(), bad), Catch::Contains("rectangle.axis"));
  bad = Rectangle();
  bad.center.x() = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(intersection(bad, Rectangle()), std::invalid_argument);
}
