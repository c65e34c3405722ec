/// \file
/// \brief Contacts of bodies that have no contact area until they overlap, and points that a turn brings in.
#include "tumble/analytic_lcp/passing_contacts.hpp"

#include "tumble/analytic_lcp/tolerances.hpp"
#include "tumble/analytic_lcp/touch.hpp"
#include "tumble/base/index.hpp"
#include "tumble/contact/effective_mass.hpp"
#include "tumble/contact/gather.hpp"
#include "tumble/contact/tolerances.hpp"

#include <algorithm>

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

bool PassingContacts::find_missed(const World& world, std::span<const BodyState> start,
                                  std::span<const MovingBody> before,
                                  std::span<const MovingBody> bodies, double dt,
                                  const ContactList& contacts, ContactList& out,
                                  StepReport& report) {
  bool any = false;
  Manifold manifold;
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    const IndexPair pair{contacts[c].first, contacts[c].second};
    if (c > 0 && contacts[c - 1].first == pair.first && contacts[c - 1].second == pair.second)
      continue;
    const std::size_t i = idx(pair.first), j = idx(pair.second);
    const BodyProperties& a = world.bodies()[i];
    const BodyProperties& b = world.bodies()[j];
    if (a.shape == Shape::ground || b.shape == Shape::ground)
      continue;  // has all corners as points
    const double allowed = tolerance::missed_overlap * pair_size(world, pair.first, pair.second);
    if (turning(a, bodies[i], dt) + turning(b, bodies[j], dt) <= allowed) continue;
    ++report.pair_tests;
    if (!touch_pair(world, world.states(), pair, 0.0, kNoAxis, manifold)) continue;
    double least = 0.0;
    for (int p = 0; p < manifold.count; ++p)
      least = std::min(least, manifold.points[idx(p)].distance);
    if (-least <= allowed) continue;

    Contact contact = contact_of(world, pair);
    contact.axis = manifold.axis;
    set_points(manifold, contact);
    const Vec3 middle_w =
        0.5 * (travel(start[i], world.states()[i]) + travel(start[j], world.states()[j]));
    for (int p = 0; p < contact.count; ++p) {
      ContactPoint& point = contact.points[idx(p)];
      point.position_w -= middle_w;
      point.approach_speed =
          contact.normal_w.dot(relative_velocity(before[i], before[j], point.position_w));
      const double closes =
          contact.normal_w.dot(relative_velocity(bodies[i], bodies[j], point.position_w));
      point.distance = std::max(0.0, point.distance - dt * closes);
    }
    if (!any) out = contacts;
    any = true;
    // After those of its pair: std::sort puts equals in an order that differs from library to library.
    out.insert(std::upper_bound(out.begin(), out.end(), contact, comes_before), contact);
  }
  return any;
}

}  // namespace tumble
