/// \file
/// \brief The listing SETGEOMETRICALLYSTABLE.
#include "tumble/geometric_stability/geometrically_stable.hpp"

#include "tumble/base/error.hpp"
#include "tumble/base/suggestion.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>

namespace tumble {
namespace {

constexpr std::uint8_t kAllCorners = 0b1111;

std::size_t at(int index) { return static_cast<std::size_t>(index); }

// Along the positive or negative y axis.
bool vertical(const Vec3& normal_w) {
  return std::sqrt(normal_w.x() * normal_w.x() + normal_w.z() * normal_w.z()) <=
         tolerance::vertical_normal;
}

double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

}  // namespace

StableRule stable_rule_from(std::string_view name) {
  static constexpr std::array<std::string_view, 3> kNames{"off", "corners", "hull"};
  const auto found = std::find(kNames.begin(), kNames.end(), name);
  require::that(found != kNames.end(),
                "stable_boxes = " + std::string(name) + ": " + expected_names(name, kNames));
  return static_cast<StableRule>(found - kNames.begin());
}

void GeometricStability::run(const World& world, std::span<const Contact> contacts, StableRule rule,
                             double rising, std::vector<char>& stable) {
  const std::span<const BodyProperties> objects = world.bodies();
  // [SETGEOMETRICALLYSTABLE:1-5]
  // What has infinite mass is stable, whatever touches it.
  stable.resize(objects.size());
  for (std::size_t o = 0; o < objects.size(); ++o) stable[o] = objects[o].movable() ? 0 : 1;
  // [SETGEOMETRICALLYSTABLE:1-5]
  if (rule == StableRule::off) return;
  find_vetoes(world, contacts, rising);
  below_.assign(objects.size(), 0);
  // [SETGEOMETRICALLYSTABLE:6]
  sort_contact_points_ascending(contacts);
  // [SETGEOMETRICALLYSTABLE:6]

  // In a pile supporters are lower than what they support and are
  // decided first. Wherever that is not so, another sweep finds it.
  held_.assign(objects.size(), 0);
  holds_.assign(sorted_.size(), 0);
  corners_.assign(objects.size(), 0);
  for (bool found = true; found;) {
    found = false;
    // [SETGEOMETRICALLYSTABLE:7-17]
    // A point on a stable body marks the corner that it is under.
    // With all corners marked, and nothing under it that is not
    // stable, the upper body is stable.
    for (std::size_t i = 0; i < sorted_.size(); ++i) {
      const Point& c = sorted_[i];
      if (stable[at(c.bottom)] == 0 || holds_[i] != 0) continue;
      holds_[i] = 1;
      ++held_[at(c.top)];
      if (stable[at(c.top)] != 0) continue;
      mark_projected_corners(world, c);
      if (vetoed_[at(c.top)] != 0 || held_[at(c.top)] != below_[at(c.top)]) continue;
      const bool firm =
          rule == StableRule::hull ? covered(world, c.top) : corners_[at(c.top)] == kAllCorners;
      if (!firm) continue;
      stable[at(c.top)] = 1;
      found = true;
    }
    // [SETGEOMETRICALLYSTABLE:7-17]
  }
  // [SETGEOMETRICALLYSTABLE:21]
  return;
  // [SETGEOMETRICALLYSTABLE:21]
}

void GeometricStability::find_vetoes(const World& world, std::span<const Contact> contacts,
                                     double rising) {
  vetoed_.assign(world.bodies().size(), 0);
  // [SETGEOMETRICALLYSTABLE:18-20]
  // A contact from the side speaks against both bodies, and
  // nothing that comes later overrules it.
  for (const Contact& contact : contacts) {
    if (vertical(contact.normal_w)) continue;
    vetoed_[at(contact.first)] = 1;
    vetoed_[at(contact.second)] = 1;
  }
  // [SETGEOMETRICALLYSTABLE:18-20]
  const double g = world.gravity_w.norm();
  for (std::size_t o = 0; o < vetoed_.size(); ++o) {
    const BodyProperties& body = world.bodies()[o];
    if (!body.movable()) continue;
    const double limit = rising * body.mass * std::sqrt(g * body.size.minCoeff());
    if (world.states()[o].linear_momentum_w.y() > limit) vetoed_[o] = 1;
  }
}

void GeometricStability::sort_contact_points_ascending(std::span<const Contact> contacts) {
  sorted_.clear();
  for (const Contact& contact : contacts) {
    if (!vertical(contact.normal_w)) continue;
    const bool second_is_top = contact.normal_w.y() > 0.0;
    for (int p = 0; p < contact.count; ++p) {
      const Vec3& position_w = contact.points[at(p)].position_w;
      const int top = second_is_top ? contact.second : contact.first;
      const int bottom = second_is_top ? contact.first : contact.second;
      sorted_.push_back({position_w.y(), top, bottom, Vec2(position_w.x(), position_w.z())});
      ++below_[at(top)];
    }
  }
  const auto key = [](const Point& c) {
    return std::tuple(c.height, c.top, c.bottom, c.xz.x(), c.xz.y());
  };
  std::sort(sorted_.begin(), sorted_.end(),
            [&](const Point& a, const Point& b) { return key(a) < key(b); });
}

void GeometricStability::mark_projected_corners(const World& world, const Point& c) {
  const BodyProperties& body = world.bodies()[at(c.top)];
  const std::array<Vec2, 4> corners = lower_corners(box_of(body, world.states()[at(c.top)]));
  const double near = tolerance::corner_support * body.size.minCoeff();
  for (std::size_t k = 0; k < 4; ++k)
    if ((corners[k] - c.xz).norm() <= near)
      corners_[at(c.top)] = static_cast<std::uint8_t>(corners_[at(c.top)] | 1U << k);
}

// Whether the hull of the points on stable bodies covers the outline of a body.
bool GeometricStability::covered(const World& world, int body) {
  points_.clear();
  for (std::size_t i = 0; i < sorted_.size(); ++i)
    if (sorted_[i].top == body && holds_[i] != 0) points_.push_back(sorted_[i].xz);
  convex_hull(points_, hull_);
  const Box box = box_of(world.bodies()[at(body)], world.states()[at(body)]);
  const double near = tolerance::corner_support * world.bodies()[at(body)].size.minCoeff();
  const std::array<Vec3, 8> outline = corners_of(box);
  return std::all_of(outline.begin(), outline.end(), [&](const Vec3& corner_w) {
    return hull_contains(hull_, Vec2(corner_w.x(), corner_w.z()), near);
  });
}

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

bool hull_contains(std::span<const Vec2> hull, const Vec2& point, double margin) {
  if (hull.empty()) return false;
  bool inside = hull.size() >= 3;
  double nearest = (hull[0] - point).norm();
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Vec2& a = hull[i];
    const Vec2 edge = hull[(i + 1) % hull.size()] - a;
    if (hull.size() >= 3 && cross(edge, point - a) < 0.0) inside = false;
    const double square = edge.squaredNorm();
    const double along = square > 0.0 ? std::clamp(edge.dot(point - a) / square, 0.0, 1.0) : 0.0;
    nearest = std::min(nearest, (a + along * edge - point).norm());
  }
  return inside || nearest <= margin;
}

}  // namespace tumble
