/// \file
/// \brief Geometric stability: the listing SETGEOMETRICALLYSTABLE.
#include "tumble/geometric_stability/geometrically_stable.hpp"

#include "tumble/base/error.hpp"
#include "tumble/base/index.hpp"
#include "tumble/base/number_text.hpp"
#include "tumble/geometric_stability/upright.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

namespace tumble {
namespace {

// A coordinate for messages.
std::string coordinate(double value) { return rounded_text(value, 4); }

}  // namespace

void GeometricStability::run(const World& world, std::span<const Contact> contacts, StableRule rule,
                             double rising, std::vector<char>& stable,
                             std::span<const Outline> outlines, std::span<const char> moving) {
  const std::span<const BodyProperties> objects = world.bodies();
  if (!outlines.empty() && outlines.size() != objects.size())
    refuse("outlines: " + std::to_string(outlines.size()) + " for " +
           std::to_string(objects.size()) + " bodies: give one each, or none");
  if (!moving.empty() && moving.size() != objects.size())
    refuse("moving: " + std::to_string(moving.size()) + " for " + std::to_string(objects.size()) +
           " bodies: give one each, or none");
  outlines_.assign(outlines.begin(), outlines.end());
  rule_ = rule;
  // [SETGEOMETRICALLYSTABLE:1-5]
  // A body of infinite mass is always stable.
  stable.resize(objects.size());
  for (std::size_t o = 0; o < objects.size(); ++o) stable[o] = objects[o].movable() ? 0 : 1;
  // [SETGEOMETRICALLYSTABLE:1-5]
  if (rule == StableRule::off) return;
  find_vetoes(world, contacts, rising, moving);
  below_.assign(objects.size(), 0);
  // [SETGEOMETRICALLYSTABLE:6]
  sort_contact_points_ascending(contacts);
  // [SETGEOMETRICALLYSTABLE:6]

  // In a pile supporting bodies are lower than supported ones and are
  // decided first. Other cases need another sweep.
  held_.assign(objects.size(), 0);
  holds_.assign(sorted_.size(), 0);
  corners_.assign(objects.size(), 0);
  for (bool found = true; found;) {
    found = false;
    // [SETGEOMETRICALLYSTABLE:7-17]
    // A point on a stable body marks the corner above it. A body
    // with all corners marked, and no unstable body below it, is
    // stable.
    for (std::size_t i = 0; i < sorted_.size(); ++i) {
      const Point& c = sorted_[i];
      if (stable[idx(c.bottom)] == 0 || holds_[i] != 0) continue;
      holds_[i] = 1;
      ++held_[idx(c.top)];
      if (stable[idx(c.top)] != 0) continue;
      mark_projected_corners(world, c);
      if (vetoes_[idx(c.top)] != kNone || held_[idx(c.top)] != below_[idx(c.top)]) continue;
      const bool firm =
          rule == StableRule::corners ? corners_[idx(c.top)] == kAllCorners : covered(world, c.top);
      if (!firm) continue;
      stable[idx(c.top)] = 1;
      found = true;
    }
    // [SETGEOMETRICALLYSTABLE:7-17]
  }
  stable_ = stable;
  // [SETGEOMETRICALLYSTABLE:21]
  return;
  // [SETGEOMETRICALLYSTABLE:21]
}

void GeometricStability::find_vetoes(const World& world, std::span<const Contact> contacts,
                                     double rising, std::span<const char> moving) {
  vetoes_.assign(world.bodies().size(), kNone);
  // [SETGEOMETRICALLYSTABLE:18-20]
  // A side contact is a veto for both bodies, and nothing that
  // comes later overrules it.
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    if (contacts[c].count == 0 || is_vertical(contacts[c].normal_w, tolerances_.vertical)) continue;
    for (const int body : {contacts[c].first, contacts[c].second})
      if (vetoes_[idx(body)] == kNone) vetoes_[idx(body)] = static_cast<int>(c);
  }
  // [SETGEOMETRICALLYSTABLE:18-20]
  const double g = world.gravity_w.norm();
  for (std::size_t o = 0; o < vetoes_.size(); ++o) {
    const BodyProperties& body = world.bodies()[o];
    if (!body.movable()) continue;
    const double speed = std::sqrt(g * body.size.minCoeff());
    const BodyState& state = world.states()[o];
    const bool rises = state.linear_momentum_w.y() > rising * body.mass * speed;
    const bool steady = std::isinf(tolerances_.steady) ||  // not tested; false for NaN
                        tipping_speed(body, state) <= tolerances_.steady * speed;
    if (rises || !steady || (!moving.empty() && moving[o] != 0)) vetoes_[o] = kMoving;
  }
}

void GeometricStability::sort_contact_points_ascending(std::span<const Contact> contacts) {
  sorted_.clear();
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    const Contact& contact = contacts[c];
    if (!is_vertical(contact.normal_w, tolerances_.vertical)) continue;
    const bool second_is_top = contact.normal_w.y() > 0.0;
    for (int p = 0; p < contact.count; ++p) {
      const Vec3& position_w = contact.points[idx(p)].position_w;
      const int top = second_is_top ? contact.second : contact.first;
      const int bottom = second_is_top ? contact.first : contact.second;
      sorted_.push_back(
          {position_w.y(), top, bottom, Vec2(position_w.x(), position_w.z()), static_cast<int>(c)});
      ++below_[idx(top)];
    }
  }
  const auto key = [](const Point& c) {
    return std::tuple(c.height, c.top, c.bottom, c.xz.x(), c.xz.y());
  };
  std::sort(sorted_.begin(), sorted_.end(),
            [&](const Point& a, const Point& b) { return key(a) < key(b); });
}

void GeometricStability::mark_projected_corners(const World& world, const Point& c) {
  const BodyProperties& body = world.bodies()[idx(c.top)];
  const std::array<Vec2, 4> corners = lower_corners(box_of(body, world.states()[idx(c.top)]));
  const double near = tolerances_.corner * body.size.minCoeff();
  for (std::size_t k = 0; k < 4; ++k)
    if ((corners[k] - c.xz).norm() <= near)
      corners_[idx(c.top)] = static_cast<std::uint8_t>(corners_[idx(c.top)] | 1U << k);
}

// Builds the hull of the points on stable bodies below a body.
void GeometricStability::take_hull(int body) {
  points_.clear();
  for (std::size_t i = 0; i < sorted_.size(); ++i)
    if (sorted_[i].top == body && holds_[i] != 0) points_.push_back(sorted_[i].xz);
  convex_hull(points_, hull_);
}

// Collects the corners that need support.
void GeometricStability::take_outline(const World& world, int body) {
  if (!outlines_.empty() && !outlines_[idx(body)].empty())
    outline_.assign(outlines_[idx(body)].begin(), outlines_[idx(body)].end());
  else
    corners_from_above(box_of(world.bodies()[idx(body)], world.states()[idx(body)]), outline_);
}

// Whether that hull covers the outline of the body.
bool GeometricStability::covered(const World& world, int body) {
  take_hull(body);
  const double near = tolerances_.corner * world.bodies()[idx(body)].size.minCoeff();
  take_outline(world, body);
  return std::all_of(outline_.begin(), outline_.end(),
                     [&](const Vec2& corner) { return hull_contains(hull_, corner, near); });
}

StabilityVerdict GeometricStability::verdict(const World& world, int body) {
  require::that(
      body >= 0 && idx(body) < stable_.size(),
      "body " + std::to_string(body) + ": the last run() had " + std::to_string(stable_.size()));
  if (!world.bodies()[idx(body)].movable()) return {StabilityReason::immovable};
  if (stable_[idx(body)] != 0) return {StabilityReason::supported};
  const int veto = vetoes_[idx(body)];
  if (veto == kMoving) return {StabilityReason::moving};
  if (veto != kNone) return {StabilityReason::side_contact, veto};
  for (const Point& c : sorted_)
    if (c.top == body && stable_[idx(c.bottom)] == 0)
      return {StabilityReason::unstable_support, c.contact};

  // The remaining reason is a corner: the one farthest from its supports.
  take_hull(body);
  const BodyProperties& properties = world.bodies()[idx(body)];
  take_outline(world, body);
  if (rule_ == StableRule::corners) {
    const std::array<Vec2, 4> corners =
        lower_corners(box_of(properties, world.states()[idx(body)]));
    outline_.clear();
    for (std::size_t k = 0; k < 4; ++k)
      if ((corners_[idx(body)] & 1U << k) == 0) outline_.push_back(corners[k]);
  }
  const auto worse = [&](const Vec2& a, const Vec2& b) {
    return distance_to_hull(hull_, a) < distance_to_hull(hull_, b);
  };
  return {StabilityReason::corner, -1, *std::max_element(outline_.begin(), outline_.end(), worse)};
}

std::string explanation(const World& world, std::span<const Contact> contacts,
                        const StabilityVerdict& verdict) {
  const auto pair = [&] {
    const Contact& contact = contacts[idx(verdict.contact)];
    return world.name(contact.first) + " and " + world.name(contact.second);
  };
  switch (verdict.reason) {
    case StabilityReason::immovable: return "immovable";
    case StabilityReason::supported: return "supports any load";
    case StabilityReason::moving: return "rises, sinks or tips";
    case StabilityReason::side_contact: return "the contact of " + pair() + " is not vertical";
    case StabilityReason::unstable_support: return "of " + pair() + ", the lower one is not stable";
    case StabilityReason::corner: break;
  }
  return "the corner at x = " + coordinate(verdict.corner_xz.x()) +
         " m, z = " + coordinate(verdict.corner_xz.y()) + " m is not supported";
}

}  // namespace tumble
