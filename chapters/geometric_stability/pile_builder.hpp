/// \file
/// \brief Piles that touch exactly, built box by box (thesis 5.4).
#pragma once

#include "tumble/contact/contact.hpp"
#include "tumble/geometric_stability/support_polygon.hpp"
#include "tumble/geometric_stability/upright.hpp"
#include "tumble/geometry/separation.hpp"

#include "driver/experiment.hpp"
#include "driver/touching.hpp"

namespace tumble::chapters {

// Exact distances have no more than rounding, [m]: clipping to a face widens it by 1e-12 of itself. All
// others are at least as large as the numbers after it.
inline constexpr double kPileRounding = 1e-10;
inline constexpr double kClearGap = 5e-3;     // [m]
inline constexpr double kClearCorner = 0.02;  // [-] of the shortest edge
inline constexpr double kClearLean = 0.01;    // [-] sine
inline constexpr double kNowhere = -std::numeric_limits<double>::infinity();

inline bool nearly(double distance, double near) {
  return distance > kPileRounding && distance < near;
}

// The height of a box's centre at which it comes to touch another one from above; none if it goes past
// it. Two boxes have a point in common if their shadows on each of 15 axes have: each axis allows a stretch
// of heights, and of what is common to all stretches it is the upper end.
inline double height_on(const Box& box, const Box& below) {
  double low = kNowhere;
  double high = -kNowhere;
  const Vec3 level_w(box.center_w.x() - below.center_w.x(), 0.0,
                     box.center_w.z() - below.center_w.z());
  const auto look = [&](const Vec3& axis_w) {
    const double across = Vec2(axis_w.x(), axis_w.z()).norm();
    const double reaches = reach(box, axis_w) + reach(below, axis_w);
    const double apart = level_w.dot(axis_w);
    if (std::abs(axis_w.y()) <= kPileRounding * across) {
      if (std::abs(apart) >= reaches - kPileRounding) high = kNowhere;
      return;
    }
    const double middle = -apart / axis_w.y();
    low = std::max(low, middle - reaches / std::abs(axis_w.y()));
    high = std::min(high, middle + reaches / std::abs(axis_w.y()));
  };
  for (int i = 0; i < 3; ++i) {
    look(box.axes_w.col(i));
    look(below.axes_w.col(i));
    for (int j = 0; j < 3; ++j) {
      const Vec3 axis_w = box.axes_w.col(i).cross(below.axes_w.col(j));
      // Of two upright boxes the vertical is among the faces' axes, and exact there.
      const bool vertical = is_vertical(axis_w, kPileRounding);
      if (!vertical) look(axis_w.normalized());
    }
  }
  return high - low <= kPileRounding ? kNowhere : below.center_w.y() + high;
}

inline BodyState raised(BodyState state, double height) {
  state.position_w.y() = height;
  return state;
}

// Everything that touches.
// margin: [m] surfaces up to this far apart touch
inline ContactList touching(const World& world, double margin = 1e-9) {
  return contacts_within(world, margin);
}

// Puts boxes on boxes so that they touch to rounding, and keeps clear of near misses.
//
// Whether a corner is over its support must not hang on a tolerance. So a box is refused if it
// overlaps another one, or if anything about it is neither exact nor clearly apart: a gap, the
// distance of a contact point from a corner, the width of a contact area, the lean of a normal. What
// counts as clearly apart is twice the tolerances of `damped`, and 10^4 times the exact ones.
class PileBuilder {
 public:
  // Begins with the ground.
  PileBuilder() { world_.add_ground(); }

  // Adds a box where it is.
  bool add(const BodyProperties& body, const BodyState& state) {
    if (!clear(box_of(body, state))) return false;
    const BodyId id = world_.add(body, state);
    if (contacts_are_plain()) return true;
    world_.remove(id);
    return false;
  }

  // Adds a box from above: it goes straight down until it touches something.
  bool lower(const BodyProperties& body, const BodyState& state) {
    const Box box = box_of(body, state);
    double height = reach(box, Vec3::UnitY());
    for (int k = 1; k < world_.count(); ++k)
      height = std::max(height,
                        height_on(box, box_of(world_.bodies()[idx(k)], world_.states()[idx(k)])));
    return add(body, raised(state, height));
  }

  // The pile so far.
  [[nodiscard]] const World& world() const { return world_; }

 private:
  // Whether a box is at a distance from all others that is 0 or clearly more.
  [[nodiscard]] bool clear(const Box& box) const {
    const double above_ground = box.center_w.y() - reach(box, Vec3::UnitY());
    if (above_ground < -kPileRounding || nearly(above_ground, kClearGap)) return false;
    const SeparationOptions exact{.prefer_faces = false,
                                  .enough = std::numeric_limits<double>::infinity()};
    for (int k = 1; k < world_.count(); ++k) {
      const Box other = box_of(world_.bodies()[idx(k)], world_.states()[idx(k)]);
      const double distance = separation(box, other, exact).distance;
      if (distance < -kPileRounding || nearly(distance, kClearGap)) return false;
    }
    return true;
  }
  // Whether no contact of the last body lacks a little to what it seems to be.
  [[nodiscard]] bool contacts_are_plain() const {
    for (const Contact& contact : touching(world_, kClearGap)) {
      if (contact.second != world_.count() - 1) continue;
      const double lean = Vec2(contact.normal_w.x(), contact.normal_w.z()).norm();
      if (nearly(lean, kClearLean)) return false;
      const BodyProperties& body = world_.bodies()[idx(contact.second)];
      const double near = kClearCorner * body.size.minCoeff();
      const std::array<Vec2, 4> corners =
          lower_corners(box_of(body, world_.states()[idx(contact.second)]));
      for (int p = 0; p < contact.count; ++p) {
        const ContactPoint& point = contact.points[idx(p)];
        if (nearly(std::abs(point.distance), kClearGap)) return false;
        const Vec2 xz(point.position_w.x(), point.position_w.z());
        for (const Vec2& corner : corners)
          if (nearly((corner - xz).norm(), near)) return false;
        for (int q = 0; q < p; ++q)
          if (nearly((contact.points[idx(q)].position_w - point.position_w).norm(), near))
            return false;
      }
    }
    return true;
  }

  World world_;
};

// The same bodies, added in another order; the names stay.
inline World reordered(const World& world, Random& random) {
  std::vector<std::size_t> order(world.bodies().size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (std::size_t i = order.size(); i > 1; --i)
    std::swap(order[i - 1], order[random.below(static_cast<std::uint32_t>(i))]);
  World other;
  for (const std::size_t k : order) {
    if (world.bodies()[k].shape == Shape::ground)
      other.add_ground();
    else
      other.add(world.bodies()[k], world.states()[k], world.name(static_cast<int>(k)));
  }
  return other;
}

// Brings a list into another order.
inline void shuffle(ContactList& contacts, Random& random) {
  for (std::size_t i = contacts.size(); i > 1; --i)
    std::swap(contacts[i - 1], contacts[random.below(static_cast<std::uint32_t>(i))]);
}

// The body on which a contact presses from above.
inline int upper_body(const Contact& contact) {
  return contact.normal_w.y() > 0.0 ? contact.second : contact.first;
}

// The other body of a contact.
inline int lower_body(const Contact& contact) {
  return contact.normal_w.y() > 0.0 ? contact.first : contact.second;
}

}  // namespace tumble::chapters
