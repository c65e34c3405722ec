/// \file
/// \brief The overlap of two rectangles in a plane.
#include "tumble/geometry/rectangle.hpp"

#include "tumble/base/error.hpp"
#include "tumble/base/tolerances.hpp"
#include "tumble/geometry/rectangle_clip.hpp"

#include <algorithm>
#include <cmath>

namespace tumble {
namespace {

void check(const Rectangle& r) {
  require::finite(Vec3(r.center.x(), r.center.y(), 0.0), "rectangle.center");
  require::unit(Vec3(r.axis.x(), r.axis.y(), 0.0), "rectangle.axis");
  require::positive(r.half.x(), "rectangle.half.x");
  require::positive(r.half.y(), "rectangle.half.y");
}

// The other axis, a quarter turn on.
Vec2 across(const Vec2& axis) { return {-axis.y(), axis.x()}; }

}  // namespace

Polygon intersection(const Rectangle& a, const Rectangle& b) {
  check(a);
  check(b);
  // The second rectangle in the frame of the first.
  const Vec2 axis_x = a.axis, axis_y = across(a.axis);
  const auto seen = [&](const Vec2& v) { return Vec2(v.dot(axis_x), v.dot(axis_y)); };
  const Vec2 center = seen(b.center - a.center);
  const Vec2 along = seen(b.half.x() * b.axis);
  const Vec2 aside = seen(b.half.y() * across(b.axis));
  ClipArea area, scratch;
  area.count = 4;
  for (std::size_t i = 0; i < 4; ++i) {
    const double x = i == 1 || i == 2 ? 1.0 : -1.0, y = i >= 2 ? 1.0 : -1.0;
    const Vec2 corner = center + x * along + y * aside;
    area.corners[i] = {{corner.x(), corner.y(), 0.0}, i};
  }
  const ClipArea& clipped = clip_to_rectangle(area, scratch, a.half.x(), a.half.y());

  // Back, without corners that fall together.
  const double near = tolerance::same_point * std::min(a.half.maxCoeff(), b.half.maxCoeff());
  const auto same = [near](const Vec2& p, const Vec2& q) {
    return (p - q).cwiseAbs().maxCoeff() <= near;
  };
  Polygon out;
  for (std::size_t i = 0; i < clipped.count; ++i) {
    const ClipCorner& p = clipped.corners[i];
    const Vec2 corner = a.center + p.x[0] * axis_x + p.x[1] * axis_y;
    if (out.count > 0 && (same(corner, out.corners[0]) ||
                          same(corner, out.corners[static_cast<std::size_t>(out.count - 1)])))
      continue;
    out.corners[static_cast<std::size_t>(out.count++)] = corner;
  }
  return out;
}

double area(const Polygon& polygon) {
  // Triangles that fan out from the first corner: no digits are lost far from the origin.
  double twice = 0.0;
  for (int i = 2; i < polygon.count; ++i) {
    const Vec2 p = polygon.corners[static_cast<std::size_t>(i - 1)] - polygon.corners[0];
    const Vec2 q = polygon.corners[static_cast<std::size_t>(i)] - polygon.corners[0];
    twice += p.x() * q.y() - p.y() * q.x();
  }
  return 0.5 * twice;
}

}  // namespace tumble
