/// \file
/// \brief Convex polygons in the plane of the ground.
#include "tumble/geometric_stability/support_polygon.hpp"

#include <algorithm>
#include <limits>

namespace tumble {
namespace {

double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

}  // namespace

std::array<Vec2, 4> lower_corners(const Box& box) {
  int m = 0;
  box.axes_w.row(1).cwiseAbs().maxCoeff(&m);
  const int k = (m + 1) % 3;
  const int l = (m + 2) % 3;
  const int face = box.axes_w(1, m) > 0.0 ? 0 : 1 << m;
  std::array<Vec2, 4> corners;
  std::size_t next = 0;
  for (const int offset : {0, 1 << k, 1 << k | 1 << l, 1 << l}) {
    const Vec3 corner_w = corner_of(box, face | offset);
    corners[next++] = Vec2(corner_w.x(), corner_w.z());
  }
  return corners;
}

void corners_from_above(const Box& box, std::vector<Vec2>& corners) {
  corners.clear();
  for (const Vec3& corner_w : corners_of(box)) corners.emplace_back(corner_w.x(), corner_w.z());
}

void convex_hull(std::vector<Vec2>& points, std::vector<Vec2>& hull) {
  const auto before = [](const Vec2& a, const Vec2& b) {
    return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
  };
  std::sort(points.begin(), points.end(), before);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  hull.clear();
  if (points.size() < 3) {
    hull.assign(points.begin(), points.end());
    return;
  }
  // The lower side from left to right, then the upper one back.
  const auto add = [&](const Vec2& p, std::size_t least) {
    while (hull.size() >= least && hull.size() >= 2 &&
           cross(hull[hull.size() - 1] - hull[hull.size() - 2], p - hull.back()) <= 0.0)
      hull.pop_back();
    hull.push_back(p);
  };
  for (const Vec2& p : points) add(p, 2);
  const std::size_t lower = hull.size() + 1;
  for (auto p = points.rbegin() + 1; p != points.rend(); ++p) add(*p, lower);
  hull.pop_back();  // the first point again
}

double distance_to_hull(std::span<const Vec2> hull, const Vec2& point) {
  double nearest = std::numeric_limits<double>::infinity();
  bool inside = hull.size() >= 3;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Vec2& a = hull[i];
    const Vec2 edge = hull[(i + 1) % hull.size()] - a;
    if (cross(edge, point - a) < 0.0) inside = false;
    const double square = edge.squaredNorm();
    const double along = square > 0.0 ? std::clamp(edge.dot(point - a) / square, 0.0, 1.0) : 0.0;
    nearest = std::min(nearest, (a + along * edge - point).norm());
  }
  return inside ? 0.0 : nearest;
}

bool hull_contains(std::span<const Vec2> hull, const Vec2& point, double margin) {
  return !hull.empty() && distance_to_hull(hull, point) <= margin;
}

}  // namespace tumble
