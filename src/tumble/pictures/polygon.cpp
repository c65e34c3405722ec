/// \file
/// \brief Hull, clipping and area of polygons.
#include "tumble/pictures/polygon.hpp"

#include <algorithm>

namespace tumble {
namespace {

double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

}  // namespace

Polygon convex_hull(Polygon points) {
  if (points.size() < 3) return points;
  std::sort(points.begin(), points.end(), [](const Vec2& a, const Vec2& b) {
    return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
  });
  // First the lower half from left to right, then the upper one back: corners without a left turn are
  // removed.
  Polygon hull;
  for (int half = 0; half < 2; ++half) {
    const std::size_t start = hull.size();
    for (const Vec2& p : points) {
      while (hull.size() >= start + 2 &&
             cross(hull.back() - hull[hull.size() - 2], p - hull.back()) <= 0.0)
        hull.pop_back();
      hull.push_back(p);
    }
    hull.pop_back();  // the other half begins with it
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

Polygon clipped(const Polygon& polygon, const HalfPlane& half_plane) {
  const auto outside = [&](const Vec2& p) { return half_plane.normal.dot(p) - half_plane.offset; };
  Polygon out;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vec2& a = polygon[k];
    const Vec2& b = polygon[(k + 1) % polygon.size()];
    const double at_a = outside(a);
    const double at_b = outside(b);
    if (at_a <= 0.0) out.push_back(a);
    if ((at_a < 0.0 && at_b > 0.0) || (at_a > 0.0 && at_b < 0.0))
      out.emplace_back(a + at_a / (at_a - at_b) * (b - a));
  }
  return out;
}

Polygon clipped(const Polygon& polygon, const Polygon& convex, double slack) {
  Polygon out = polygon;
  for (std::size_t k = 0; k < convex.size() && !out.empty(); ++k) {
    // In counter-clockwise order the outside is on the right.
    const Vec2 edge = convex[(k + 1) % convex.size()] - convex[k];
    const Vec2 normal(edge.y(), -edge.x());
    out = clipped(out, HalfPlane{normal, normal.dot(convex[k]) + slack * edge.norm()});
  }
  return out;
}

double area_of(const Polygon& polygon) {
  double twice = 0.0;
  for (std::size_t k = 2; k < polygon.size(); ++k)
    twice += cross(polygon[k - 1] - polygon[0], polygon[k] - polygon[0]);
  return 0.5 * twice;
}

}  // namespace tumble
