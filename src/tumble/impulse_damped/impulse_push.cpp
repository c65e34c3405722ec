/// \file
/// \brief One impulse between two bodies that overlap where they are about to be.
#include "tumble/impulse_damped/impulse_push.hpp"

#include "tumble/base/index.hpp"
#include "tumble/contact/collision_law.hpp"
#include "tumble/contact/gather.hpp"
#include "tumble/impulse_damped/tolerances.hpp"

#include <algorithm>

namespace tumble {

// Copies the points without their impulses. Returns whether the pair approaches.
bool ImpulsePush::load(const ImpulsePair& pair, std::span<const MovingBody> bodies, double dt) {
  work_ = pair.contact;
  double sum = 0.0;
  for (int k = 0; k < work_.count; ++k) {
    weight_[idx(k)] =
        points_ == ImpulsePoints::area
            ? 1.0
            : std::max(0.0, -work_.points[idx(k)].distance) + tolerance::impulse_even * pair.size;
    sum += weight_[idx(k)];
  }
  center_w_.setZero();
  for (int k = 0; k < work_.count; ++k) {
    weight_[idx(k)] /= sum;
    center_w_ += weight_[idx(k)] * work_.points[idx(k)].position_w;
  }
  still_ = tolerance::impulse_approach * pair.size / dt;
  for (int k = 0; k < work_.count; ++k) {
    work_.points[idx(k)].normal_impulse = 0.0;
    work_.points[idx(k)].friction_impulse_w.setZero();
  }
  const double speed = points_ == ImpulsePoints::area
                           ? least_normal_speed(work_, bodies)
                           : work_.normal_w.dot(relative_velocity(
                                 bodies[idx(work_.first)], bodies[idx(work_.second)], center_w_));
  return speed < -still_;
}

// The impulse for work_.restitution at the approach speeds in the points. Returns the pivots.
int ImpulsePush::solve(std::span<MovingBody> bodies) {
  if (points_ == ImpulsePoints::area) {
    if (work_.restitution == 0.0 && stops_at_center(bodies)) return 0;
    return block_.solve(std::span(&work_, 1), bodies).pivots;
  }
  solve_at_center(bodies);
  return 0;
}

// A body that lies flat: one impulse at the middle, shared alike, stops all points. Pressure and
// friction then are within their cones at each, so this is an answer to the problem of the area.
// Returns whether it is one; if not, nothing has changed.
bool ImpulsePush::stops_at_center(std::span<MovingBody> bodies) {
  MovingBody& first = bodies[idx(work_.first)];
  MovingBody& second = bodies[idx(work_.second)];
  const MovingBody first_before = first;
  const MovingBody second_before = second;
  solve_at_center(bodies);
  bool still = true;
  for (int k = 0; k < work_.count && still; ++k)
    still = relative_velocity(first, second, work_.points[idx(k)].position_w).norm() <= still_;
  if (still) return true;
  first = first_before;
  second = second_before;
  for (int k = 0; k < work_.count; ++k) {
    work_.points[idx(k)].normal_impulse = 0.0;
    work_.points[idx(k)].friction_impulse_w.setZero();
  }
  return false;
}

void ImpulsePush::solve_at_center(std::span<MovingBody> bodies) {
  MovingBody& first = bodies[idx(work_.first)];
  MovingBody& second = bodies[idx(work_.second)];
  PointImpact impact;
  impact.normal_w = work_.normal_w;
  impact.velocity_w = relative_velocity(first, second, center_w_);
  impact.inverse_mass_w = inverse_mass_at(first, second, center_w_);
  impact.friction = work_.friction;
  impact.restitution = work_.restitution;
  for (int k = 0; k < work_.count; ++k)
    impact.approach_speed += weight_[idx(k)] * work_.points[idx(k)].approach_speed;
  const PointImpulse found = solve_impact(impact, RestitutionLaw::newton);
  if (found.mode == ImpactMode::none) return;
  apply_impulse(first, second, center_w_, found.impulse_w);
  const double normal = work_.normal_w.dot(found.impulse_w);
  const Vec3 across_w = found.impulse_w - normal * work_.normal_w;
  for (int k = 0; k < work_.count; ++k) {  // the same as at the centre, as a load of each point
    work_.points[idx(k)].normal_impulse = weight_[idx(k)] * normal;
    work_.points[idx(k)].friction_impulse_w = weight_[idx(k)] * across_w;
  }
}

PushResult ImpulsePush::collide(ImpulsePair& pair, std::span<MovingBody> bodies, double restitution,
                                double dt) {
  if (!load(pair, bodies, dt)) return {};
  const MovingBody& first = bodies[idx(work_.first)];
  const MovingBody& second = bodies[idx(work_.second)];
  const double approach = least_normal_speed(work_, bodies);
  if (!pair.met || approach < pair.approach) {
    pair.met = true;
    pair.approach = approach;
    pair.first_velocity_w = first.velocity_w;
    pair.first_spin_w = first.angular_velocity_w;
    pair.second_velocity_w = second.velocity_w;
    pair.second_spin_w = second.angular_velocity_w;
  }
  for (int k = 0; k < work_.count; ++k) {
    ContactPoint& point = work_.points[idx(k)];
    const Vec3 u_w =
        pair.second_velocity_w + pair.second_spin_w.cross(point.position_w - second.position_w) -
        pair.first_velocity_w - pair.first_spin_w.cross(point.position_w - first.position_w);
    point.approach_speed = work_.normal_w.dot(u_w);
  }
  work_.restitution = restitution;
  return push(pair, bodies, 1.0, Vec3::Zero());
}

PushResult ImpulsePush::hold(ImpulsePair& pair, std::span<MovingBody> bodies, double share,
                             double dt, const Vec3& ahead_w) {
  if (!load(pair, bodies, dt)) return {};
  work_.restitution = 0.0;
  for (int k = 0; k < work_.count; ++k) work_.points[idx(k)].approach_speed = 0.0;
  return push(pair, bodies, share, ahead_w);
}

// Solves and applies a share of the answer: velocities are linear in the impulse.
PushResult ImpulsePush::push(ImpulsePair& pair, std::span<MovingBody> bodies, double share,
                             const Vec3& ahead_w) {
  MovingBody& first = bodies[idx(work_.first)];
  MovingBody& second = bodies[idx(work_.second)];
  const MovingBody first_before = first;
  const MovingBody second_before = second;
  PushResult result{.pivots = solve(bodies)};
  if (share < 1.0) {
    const auto part = [share](const MovingBody& before, MovingBody& body) {
      const Vec3 spin_w = body.angular_velocity_w - before.angular_velocity_w;
      body.velocity_w = before.velocity_w + share * (body.velocity_w - before.velocity_w);
      body.angular_velocity_w = before.angular_velocity_w + share * spin_w;
    };
    part(first_before, first);
    part(second_before, second);
  }
  for (int k = 0; k < work_.count; ++k) {
    ContactPoint& point = work_.points[idx(k)];
    point.normal_impulse *= share;
    point.friction_impulse_w *= share;
    result.impulses += point.normal_impulse > 0.0 ? 1 : 0;
    pair.contact.points[idx(k)].normal_impulse += point.normal_impulse;
    pair.contact.points[idx(k)].friction_impulse_w += point.friction_impulse_w;
  }
  account(first_before, first, -1.0, ahead_w, work_, result);
  account(second_before, second, 1.0, ahead_w, work_, result);
  result.pushed = result.impulses > 0;
  return result;
}

// The work of all impulses on one body: each times the mean of the velocities before and after,
// less what these are ahead. An immovable or frozen body takes no momentum, and so no energy.
void ImpulsePush::account(const MovingBody& before, const MovingBody& after, double side,
                          const Vec3& ahead_w, const Contact& work, PushResult& result) {
  if (before.inverse_mass.isZero(0.0)) return;
  for (int k = 0; k < work.count; ++k) {
    const ContactPoint& point = work.points[idx(k)];
    const Vec3 mean_w =
        0.5 * (velocity_at(before, point.position_w) + velocity_at(after, point.position_w)) -
        ahead_w;
    result.normal_work += side * point.normal_impulse * work.normal_w.dot(mean_w);
    result.friction_work += side * point.friction_impulse_w.dot(mean_w);
  }
}

}  // namespace tumble
