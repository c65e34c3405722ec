/// \file
/// \brief Two bodies that touch, as the solvers see them.
#pragma once

#include "tumble/contact/moving_body.hpp"
#include "tumble/contact/tolerances.hpp"
#include "tumble/dynamics/body.hpp"
#include "tumble/dynamics/event_log.hpp"
#include "tumble/geometry/manifold.hpp"

#include <array>
#include <vector>

namespace tumble {

/// One point of a contact, with the data that are kept from step to step.
struct ContactPoint {
  Vec3 position_w = Vec3::Zero();  ///< [m] world frame, halfway between the two surfaces
  double distance = 0.0;           ///< [m] along the normal; below 0 the surfaces overlap
  FeatureId feature = 0;           ///< its name over time
  /// [m/s] n·(v_second - v_first) when the contact was gathered; below 0 the bodies approach.
  /// Newton's restitution uses this one for the whole event, not the one that is left after other
  /// impulses.
  double approach_speed = 0.0;
  double normal_impulse = 0.0;             ///< [N s] accumulated, at least 0, on the second body
  Vec3 friction_impulse_w = Vec3::Zero();  ///< [N s] accumulated, across the normal, ditto
};

/// Two bodies that touch: at most eight points with one normal.
struct Contact {
  BodyId first_id{};              ///< the body with the smaller id
  BodyId second_id{};             ///< the other one
  int first = 0;                  ///< index of the first body in this step
  int second = 0;                 ///< index of the second body in this step
  Vec3 normal_w = Vec3::UnitY();  ///< [-] from the first body to the second, world frame
  AxisIndex axis = kNoAxis;       ///< remembered for the next step
  double friction = 0.0;          ///< [-] geometric mean of the two bodies' coefficients
  double restitution = 0.0;       ///< [-] the larger of the two bodies' coefficients
  int count = 0;                  ///< how many points are used
  std::array<ContactPoint, Manifold::kMostPoints> points;  ///< the first `count`
};

/// The contacts of a step, sorted by the ids of their bodies. Callers keep it: its capacity is
/// used again.
using ContactList = std::vector<Contact>;

/// State of a contact point, by its impulses.
/// \return open without a normal impulse; slip if friction has reached its limit; else stick
inline ContactState state_of(const Contact& contact, int point) {
  const ContactPoint& p = contact.points[static_cast<std::size_t>(point)];
  if (!(p.normal_impulse > 0.0)) return ContactState::open;
  const double limit = contact.friction * p.normal_impulse;
  return p.friction_impulse_w.norm() < (1.0 - tolerance::friction_limit) * limit
             ? ContactState::stick
             : ContactState::slip;
}

}  // namespace tumble
