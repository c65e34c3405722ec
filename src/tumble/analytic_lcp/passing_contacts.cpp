/// \file
/// \brief Contacts of bodies that have no contact area until they overlap.
#include "tumble/analytic_lcp/passing_contacts.hpp"

#include "tumble/analytic_lcp/tolerances.hpp"
#include "tumble/analytic_lcp/touch.hpp"
#include "tumble/base/index.hpp"
#include "tumble/contact/effective_mass.hpp"
#include "tumble/contact/gather.hpp"
#include "tumble/contact/tolerances.hpp"
#include "tumble/geometry/separation.hpp"

#include <algorithm>
#include <cmath>

namespace tumble {
namespace {

bool comes_before(const Contact& a, const Contact& b) {
  return IndexPair{a.first, a.second} < IndexPair{b.first, b.second};
}

// [m] of the centre.
Vec3 travel(const BodyState& before, const BodyState& after) {
  return after.position_w - before.position_w;
}

// [m] how far a turn moves a body's points, at most.
double turning(const BodyProperties& body, const MovingBody& motion, double dt) {
  return 0.5 * dt * body.size.norm() * motion.angular_velocity_w.norm();
}

// --- edges without height --------------------------------------------------------------------------

bool has_ground(const World& world, const IndexPair& pair) {
  return world.bodies()[idx(pair.first)].shape == Shape::ground ||
         world.bodies()[idx(pair.second)].shape == Shape::ground;
}

// A contact of faces has an area, one at an edge without height has none.
bool on_a_line(const Contact& contact, double height) {
  const Vec3& from_w = contact.points[0].position_w;
  Vec3 along_w = Vec3::Zero();
  const auto end = contact.points.begin() + contact.count;
  for (auto p = contact.points.begin(); p != end; ++p)
    if ((p->position_w - from_w).squaredNorm() > along_w.squaredNorm())
      along_w = p->position_w - from_w;
  if (along_w.isZero(0.0)) return true;
  along_w.normalize();
  return std::all_of(contact.points.begin(), end, [&](const ContactPoint& p) {
    return (p.position_w - from_w).cross(along_w).norm() <= height;
  });
}

// A plane in which an edge lies.
struct EdgePlane {
  Vec3 normal_w;  // [-]
  double at;      // [m] along the normal
  double height;  // [m] of the edge, at most
};

// Whether a contact holds one of two bodies in a plane.
bool holds(const Contact& contact, const IndexPair& pair, const EdgePlane& plane) {
  const auto is_of_pair = [&](int body) { return body == pair.first || body == pair.second; };
  if (is_of_pair(contact.first) == is_of_pair(contact.second)) return false;
  if (std::abs(contact.normal_w.dot(plane.normal_w)) < tolerance::flush_plane) return false;
  return std::any_of(contact.points.begin(), contact.points.begin() + contact.count,
                     [&](const ContactPoint& p) {
                       return std::abs(p.distance) < plane.height &&
                              std::abs(p.position_w.dot(plane.normal_w) - plane.at) < plane.height;
                     });
}

bool meets_flush_edge_along(const World& world, const IndexPair& pair, const Vec3& normal_w,
                            double gap, std::span<const Contact> contacts) {
  const double size = pair_size(world, pair.first, pair.second);
  const double height = tolerance::flush_height * size;
  const Box first = box_of(world.bodies()[idx(pair.first)], world.states()[idx(pair.first)]);
  Box second = box_of(world.bodies()[idx(pair.second)], world.states()[idx(pair.second)]);
  second.center_w -= (gap + tolerance::flush_overlap * size) * normal_w;
  const Separation closed = separation(first, second);
  if (std::abs(closed.distance) >= height) return false;
  const Vec3& flat_w = closed.normal_w;
  const EdgePlane plane{flat_w, flat_w.dot(first.center_w) + reach(first, flat_w), height};
  return std::any_of(contacts.begin(), contacts.end(),
                     [&](const Contact& contact) { return holds(contact, pair, plane); });
}

}  // namespace

void PassingContacts::add(const World& world, std::span<const MovingBody> bodies,
                          std::span<const IndexPair> pairs, double dt, RotationRule rotation,
                          ContactList& contacts, StepReport& report) {
  ended_.assign(world.states().begin(), world.states().end());
  const Vec3 gained_w = dt * world.gravity_w;
  for (std::size_t k = 0; k < ended_.size(); ++k) {
    const BodyProperties& body = world.bodies()[k];
    if (!body.movable()) continue;
    ended_[k].linear_momentum_w += body.mass * gained_w;
    advance_pose(body, ended_[k], dt, rotation);
  }
  const std::size_t found = contacts.size();
  std::size_t next = 0;
  Manifold manifold;
  for (const IndexPair& pair : pairs) {
    const std::size_t i = idx(pair.first), j = idx(pair.second);
    const BodyProperties& a = world.bodies()[i];
    const BodyProperties& b = world.bodies()[j];
    while (next < found && IndexPair{contacts[next].first, contacts[next].second} < pair) ++next;
    if (next < found && contacts[next].first == pair.first && contacts[next].second == pair.second)
      continue;
    if (a.shape == Shape::ground || b.shape == Shape::ground) continue;  // a plane is not passed
    if (!a.movable() && !b.movable()) continue;
    const double slop = tolerance::repair_slop * pair_size(world, pair.first, pair.second);
    const Vec3 nearer_w =
        travel(world.states()[j], ended_[j]) - travel(world.states()[i], ended_[i]);
    if (nearer_w.norm() + turning(a, bodies[i], dt) + turning(b, bodies[j], dt) <= slop) continue;
    ++report.pair_tests;
    if (!touch_pair(world, ended_, pair, 0.0, kNoAxis, manifold)) continue;

    Contact contact = contact_of(world, pair);
    contact.axis = manifold.axis;
    set_points(manifold, contact);
    const double falls = (b.movable() ? 1.0 : 0.0) - (a.movable() ? 1.0 : 0.0);
    const Vec3 middle_w =
        0.5 * (travel(world.states()[i], ended_[i]) + travel(world.states()[j], ended_[j]));
    for (int p = 0; p < contact.count; ++p) {
      ContactPoint& point = contact.points[idx(p)];
      point.position_w -= middle_w;
      const Vec3 u_w = relative_velocity(bodies[i], bodies[j], point.position_w);
      point.approach_speed = contact.normal_w.dot(u_w);
      point.distance =
          std::max(0.0, point.distance - dt * contact.normal_w.dot(u_w + falls * gained_w));
    }
    contacts.push_back(contact);
  }
  if (contacts.size() > found) std::sort(contacts.begin(), contacts.end(), comes_before);
}

bool meets_flush_edge(const World& world, const IndexPair& pair,
                      std::span<const Contact> contacts) {
  if (has_ground(world, pair)) return false;
  const Separation gap =
      separation(box_of(world.bodies()[idx(pair.first)], world.states()[idx(pair.first)]),
                 box_of(world.bodies()[idx(pair.second)], world.states()[idx(pair.second)]));
  return meets_flush_edge_along(world, pair, gap.normal_w, gap.distance, contacts);
}

void drop_flush_edges(const World& world, ContactList& contacts) {
  std::vector<std::size_t> flush;
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const Contact& contact = contacts[k];
    const IndexPair pair{contact.first, contact.second};
    if (has_ground(world, pair)) continue;
    const double size = pair_size(world, pair.first, pair.second);
    if (!on_a_line(contact, tolerance::flush_height * size)) continue;
    double gap = contact.points[0].distance;
    for (int p = 1; p < contact.count; ++p) gap = std::min(gap, contact.points[idx(p)].distance);
    if (meets_flush_edge_along(world, pair, contact.normal_w, gap, contacts)) flush.push_back(k);
  }
  for (const std::size_t k : flush) contacts[k].count = 0;
  std::erase_if(contacts, [](const Contact& contact) { return contact.count == 0; });
}

}  // namespace tumble
