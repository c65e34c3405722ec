/// \file
/// \brief From pairs of bodies that are near each other to the contacts of a step (thesis 3.2).
#include "tumble/contact/gather.hpp"

#include "tumble/base/error.hpp"
#include "tumble/base/index.hpp"
#include "tumble/base/tolerances.hpp"
#include "tumble/contact/effective_mass.hpp"
#include "tumble/geometry/ground.hpp"

#include <algorithm>
#include <cmath>

namespace tumble {
namespace {

bool before(const Contact& a, const Contact& b) {
  return a.first_id != b.first_id ? a.first_id < b.first_id : a.second_id < b.second_id;
}

// Walks through contacts that are sorted by id, alongside others that are sorted too.
class Earlier {
 public:
  explicit Earlier(std::span<const Contact> contacts) : contacts_(contacts) {}

  // The contact of the same pair, or nullptr. Pairs have to be asked for in ascending order.
  const Contact* find(const Contact& contact) {
    while (next_ < contacts_.size() && before(contacts_[next_], contact)) ++next_;
    const bool found = next_ < contacts_.size() && !before(contact, contacts_[next_]);
    return found ? &contacts_[next_] : nullptr;
  }

 private:
  std::span<const Contact> contacts_;
  std::size_t next_ = 0;
};

void stamp(std::span<const MovingBody> bodies, Contact& contact) {
  const MovingBody& first = bodies[static_cast<std::size_t>(contact.first)];
  const MovingBody& second = bodies[static_cast<std::size_t>(contact.second)];
  for (int i = 0; i < contact.count; ++i) {
    ContactPoint& point = contact.points[static_cast<std::size_t>(i)];
    point.approach_speed = contact.normal_w.dot(relative_velocity(first, second, point.position_w));
  }
}

// Refuses candidates that a BroadPhase would not give.
void check_pairs(std::span<const IndexPair> pairs, int count) {
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const IndexPair& pair = pairs[i];
    require::that(pair.first >= 0 && pair.first < pair.second && pair.second < count,
                  "candidates: indices of two bodies are needed, the smaller one first");
    require::that(i == 0 || pairs[i - 1] < pair,
                  "candidates: every pair once and in ascending order is needed");
  }
}

}  // namespace

bool touch_pair(const World& world, const IndexPair& pair, const Box& first, const Box& second,
                double margin, AxisIndex remembered, Manifold& out) {
  if (world.bodies()[idx(pair.first)].shape == Shape::ground)
    return collide_with_ground(second, margin, out);
  if (world.bodies()[idx(pair.second)].shape != Shape::ground)
    return collide(first, second, margin, remembered, out);
  const bool found = collide_with_ground(first, margin, out);
  flip(out);
  return found;
}

bool touch_pair(const World& world, std::span<const BodyState> states, const IndexPair& pair,
                double margin, AxisIndex remembered, Manifold& out) {
  const auto box = [&](int k) {
    const BodyProperties& body = world.bodies()[idx(k)];
    return body.shape == Shape::ground ? Box{} : box_of(body, states[idx(k)]);
  };
  return touch_pair(world, pair, box(pair.first), box(pair.second), margin, remembered, out);
}

void set_pair(const World& world, const IndexPair& pair, Contact& contact) {
  const BodyProperties& a = world.bodies()[idx(pair.first)];
  const BodyProperties& b = world.bodies()[idx(pair.second)];
  contact.first = pair.first;
  contact.second = pair.second;
  contact.first_id = world.ids()[idx(pair.first)];
  contact.second_id = world.ids()[idx(pair.second)];
  contact.friction = std::sqrt(a.friction * b.friction);
  contact.restitution = std::max(a.restitution, b.restitution);
}

Contact contact_of(const World& world, const IndexPair& pair) {
  Contact contact;
  set_pair(world, pair, contact);
  return contact;
}

void set_points(const Manifold& manifold, Contact& contact) {
  contact.normal_w = manifold.normal_w;
  contact.count = manifold.count;
  for (std::size_t i = 0; i < idx(manifold.count); ++i) {
    contact.points[i].position_w = manifold.points[i].position_w;
    contact.points[i].distance = manifold.points[i].distance;
    contact.points[i].feature = manifold.points[i].feature;
  }
}

double least_normal_speed(const Contact& contact, std::span<const MovingBody> bodies) {
  double least = 0.0;
  for (int k = 0; k < contact.count; ++k) {
    const Vec3 u_w = relative_velocity(bodies[idx(contact.first)], bodies[idx(contact.second)],
                                       contact.points[idx(k)].position_w);
    const double speed = contact.normal_w.dot(u_w);
    least = k == 0 ? speed : std::min(least, speed);
  }
  return least;
}

GatherReport gather_contacts(const World& world, std::span<const MovingBody> bodies,
                             std::span<const IndexPair> candidates, double margin,
                             std::span<const Contact> previous, ContactList& out) {
  require::that(bodies.size() == world.bodies().size(),
                "bodies: one entry for each body of the world is needed");
  require::not_negative(margin, "margin");
  check_pairs(candidates, world.count());

  out.clear();
  GatherReport report;
  Earlier earlier(previous);
  Manifold manifold;
  for (const IndexPair& pair : candidates) {
    if (!world.bodies()[idx(pair.first)].movable() && !world.bodies()[idx(pair.second)].movable())
      continue;

    // Indices and ids are in the same order, so the smaller index has the smaller id, and the list
    // becomes sorted by id.
    Contact contact = contact_of(world, pair);
    const Contact* then = earlier.find(contact);
    const AxisIndex remembered = then != nullptr ? then->axis : kNoAxis;
    ++report.pair_tests;
    if (!touch_pair(world, world.states(), pair, margin, remembered, manifold)) continue;

    contact.axis = manifold.axis;
    set_points(manifold, contact);
    for (int i = 0; i < manifold.count; ++i)
      report.deepest_overlap = std::max(report.deepest_overlap, -manifold.points[idx(i)].distance);
    stamp(bodies, contact);
    report.points += contact.count;
    out.push_back(contact);
  }
  return report;
}

double search_margin(const World& world, std::span<const MovingBody> bodies,
                     std::span<const IndexPair> pairs, double resolution) {
  double margin = 0.0;
  for (const IndexPair& pair : pairs) {
    for (const int index : {pair.first, pair.second}) {
      const auto body = static_cast<std::size_t>(index);
      const MovingBody& m = bodies[body];
      const double size = world.bodies()[body].movable() ? world.bodies()[body].size.norm() : 0.0;
      const double speed = m.velocity_w.norm() + 0.5 * size * m.angular_velocity_w.norm();
      margin = std::max(margin, 2.0 * resolution * speed + tolerance::contact_gap * size);
    }
  }
  return margin;
}

int carry_over_impulses(std::span<const Contact> previous, std::span<Contact> contacts) {
  int found = 0;
  Earlier earlier(previous);
  for (Contact& contact : contacts) {
    const Contact* then = earlier.find(contact);
    if (then == nullptr) continue;
    const auto end = then->points.begin() + then->count;
    for (int i = 0; i < contact.count; ++i) {
      ContactPoint& point = contact.points[static_cast<std::size_t>(i)];
      const auto same = std::find_if(then->points.begin(), end, [&](const ContactPoint& p) {
        return p.feature == point.feature;
      });
      if (same == end) continue;
      const Vec3& n = contact.normal_w;
      point.normal_impulse = same->normal_impulse;
      point.friction_impulse_w = same->friction_impulse_w - n.dot(same->friction_impulse_w) * n;
      ++found;
    }
  }
  return found;
}

void scale_impulses(double factor, std::span<Contact> contacts) {
  for (Contact& contact : contacts)
    for (int k = 0; k < contact.count; ++k) {
      contact.points[idx(k)].normal_impulse *= factor;
      contact.points[idx(k)].friction_impulse_w *= factor;
    }
}

void stamp_approach_speeds(std::span<const MovingBody> bodies, std::span<Contact> contacts) {
  for (Contact& contact : contacts) stamp(bodies, contact);
}

}  // namespace tumble
