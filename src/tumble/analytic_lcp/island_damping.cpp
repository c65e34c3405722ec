/// \file
/// \brief Damping in place of friction.
#include "tumble/analytic_lcp/island_damping.hpp"

#include "tumble/base/index.hpp"
#include "tumble/contact/tolerances.hpp"
#include "tumble/geometric_stability/upright.hpp"
#include "tumble/math/elementary.hpp"

#include <algorithm>

namespace tumble {
namespace {

bool pushes(const Contact& contact) {
  const auto end = contact.points.begin() + contact.count;
  return std::any_of(contact.points.begin(), end,
                     [](const ContactPoint& point) { return point.normal_impulse > 0.0; });
}

}  // namespace

double IslandDamping::run(std::span<const Contact> contacts, const HeldBodies& held,
                          const DampingShares& shares, double dt, World& world) {
  constexpr double kStepsPerSecond = 60.0;  // of the thesis's constants
  const double k1 = elementary::pow(shares.velocity, kStepsPerSecond * dt);
  const double k2 = elementary::pow(shares.spin, kStepsPerSecond * dt);
  pushing_.clear();
  // Of two bodies that are held the upper one presses on the lower, with a force that is not known.
  const auto stand = [&](const Contact& contact) {
    const int upper = contact.normal_w.y() > 0.0 ? contact.second : contact.first;
    return held.both(contact) && world.bodies()[idx(upper)].movable() &&
           is_vertical(contact.normal_w, tolerance::exact_vertical);
  };
  for (const Contact& contact : contacts)
    if (pushes(contact) || stand(contact)) pushing_.push_back(contact);
  islands_.build(world.bodies(), pushing_);

  double added = 0.0;
  for (int i = 0; i < islands_.count(); ++i) {
    const std::span<const int> which = islands_.contacts(i);
    if (which.empty()) continue;
    const bool anchored = std::any_of(which.begin(), which.end(), [&](int c) {
      const Contact& contact = pushing_[idx(c)];
      return !world.bodies()[idx(contact.first)].movable() ||
             !world.bodies()[idx(contact.second)].movable();
    });
    // [S5.3:damping]
    // What the group moves along with is not damped: its scenery, or
    // its own centre of mass.
    Vec3 drift_w = Vec3::Zero();  // [m/s]
    double mass = 0.0;
    for (const int b : islands_.bodies(i)) {
      mass += world.bodies()[idx(b)].mass;
      drift_w += world.states()[idx(b)].linear_momentum_w;
    }
    drift_w = anchored ? Vec3::Zero() : Vec3(drift_w / mass);
    for (const int b : islands_.bodies(i)) {
      const BodyProperties& body = world.bodies()[idx(b)];
      BodyState& state = world.states()[idx(b)];
      const double before = kinetic_energy(body, state);
      const Vec3 along_w = body.mass * drift_w;
      state.linear_momentum_w = along_w + k1 * (state.linear_momentum_w - along_w);
      state.angular_momentum_w *= k2;
      added += kinetic_energy(body, state) - before;
    }
    // [S5.3:damping]
  }
  return added;
}

}  // namespace tumble
