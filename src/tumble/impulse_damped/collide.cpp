/// \file
/// \brief The listing COLLIDE.
#include "tumble/impulse_damped/collide.hpp"

#include "tumble/base/index.hpp"
#include "tumble/base/tolerances.hpp"
#include "tumble/contact/gather.hpp"

#include <algorithm>
#include <array>

namespace tumble {
namespace {

// Kinetic energy for the books. The work of an impulse is that times the mean of the velocities before
// and after, when gravity has acted for half of the step: half of what is ahead does not count.
double booked_energy_of(const World& world, int body, const DampedBodies& bodies,
                        const Vec3& ahead_w) {
  MovingBody moving = bodies.moving[idx(body)];
  moving.velocity_w -= 0.5 * ahead_w;
  return kinetic_energy_of(world.bodies()[idx(body)], bodies.axes_w[idx(body)], moving);
}

// [m/s] What falls beside each other in flight may approach by so much and does not touch.
double rounding_of_speeds(const std::array<int, 2>& pair, const DampedBodies& bodies) {
  double speed = 0.0;
  for (const int body : pair) speed += bodies.moving[idx(body)].velocity_w.norm();
  return tolerance::rounding * speed;
}

}  // namespace

CollideResult Collide::run(const World& world, Contact& collision, double restitution,
                           TemporaryGravity gravity, double dt, DampedBodies& bodies) {
  // [COLLIDE:1-6]
  // In a contact the bodies meet with the velocities that they
  // are about to have: gravity's share of this step comes with
  // it. Immovable bodies do not fall.
  const bool plus_gravity = gravity == TemporaryGravity::velocity_plus_gravity;
  const Vec3 delta_velocity_w = plus_gravity ? Vec3(dt * world.gravity_w) : Vec3::Zero();
  const std::array<int, 2> pair{collision.first, collision.second};
  const auto falls = [&](int body) {
    return world.bodies()[idx(body)].movable() && !world.sleep_states()[idx(body)].asleep;
  };
  for (const int body : pair)
    if (falls(body)) bodies.moving[idx(body)].velocity_w += delta_velocity_w;
  // [COLLIDE:1-6]

  // [COLLIDE:7-8]
  // The point was found with the pair (PairGatherer). A caller that
  // parts already gets no impulse.
  CollideResult result;
  const double approach = -least_normal_speed(collision, bodies.moving);
  const bool touches = plus_gravity && approach > rounding_of_speeds(pair, bodies);
  if (approach > 0.0)
    result = apply_newtonian_impulse(world, collision, restitution, delta_velocity_w, bodies);
  if (touches)
    for (const int body : pair) bodies.touched[idx(body)] = 1;
  // [COLLIDE:7-8]

  // [COLLIDE:9-14]
  // A stable body neither sinks nor tips. Its support stops it while
  // gravity is still in its velocity, so that it stays so when
  // gravity comes. Then the temporary gravity is taken back.
  for (const int body : pair) {
    if (!falls(body)) continue;
    MovingBody& moving = bodies.moving[idx(body)];
    if (bodies.stable[idx(body)] != 0) {
      const double before = booked_energy_of(world, body, bodies, delta_velocity_w);
      moving.velocity_w.y() = 0.0;
      moving.angular_velocity_w.x() = 0.0;
      moving.angular_velocity_w.z() = 0.0;
      moving.changed = true;
      result.restitution += booked_energy_of(world, body, bodies, delta_velocity_w) - before;
    }
    moving.velocity_w -= delta_velocity_w;
  }
  // [COLLIDE:9-14]
  // [COLLIDE:15]
  return result;
  // [COLLIDE:15]
}

// j = -(1 + e) v_n / (n·K n) along the normal at the point.
CollideResult Collide::apply_newtonian_impulse(const World& world, Contact& collision,
                                               double restitution, const Vec3& ahead_w,
                                               DampedBodies& bodies) {
  MovingBody& first = bodies.moving[idx(collision.first)];
  MovingBody& second = bodies.moving[idx(collision.second)];
  const double before = booked_energy_of(world, collision.first, bodies, ahead_w) +
                        booked_energy_of(world, collision.second, bodies, ahead_w);
  CollideResult result;
  if (collision.count == 1) {
    ContactPoint& point = collision.points[0];
    const Vec3& n_w = collision.normal_w;
    const double yield = n_w.dot(inverse_mass_at(first, second, point.position_w) * n_w);
    if (!(yield > 0.0)) return result;  // two bodies that nothing moves along the normal
    const double approach = n_w.dot(relative_velocity(first, second, point.position_w));
    result.impulse = -(1.0 + restitution) * approach / yield;
    apply_impulse(first, second, point.position_w, result.impulse * n_w);
    point.normal_impulse += result.impulse;
  } else {
    const double loaded = [&] {
      double sum = 0.0;
      for (int p = 0; p < collision.count; ++p) sum -= collision.points[idx(p)].normal_impulse;
      return sum;
    }();
    result.pivots = area_impulse(collision, restitution, bodies);
    result.impulse = loaded;
    for (int p = 0; p < collision.count; ++p)
      result.impulse += collision.points[idx(p)].normal_impulse;
  }
  result.pushed = result.impulse > 0.0;
  result.restitution = booked_energy_of(world, collision.first, bodies, ahead_w) +
                       booked_energy_of(world, collision.second, bodies, ahead_w) - before;
  return result;
}

// All points of a contact area at once. With e below 0 the share 1 + e of the impulse that ends the
// approach: velocities are linear in it.
int Collide::area_impulse(Contact& collision, double restitution, DampedBodies& bodies) {
  work_ = collision;
  work_.friction = 0.0;
  work_.restitution = std::max(0.0, restitution);
  for (int p = 0; p < work_.count; ++p) work_.points[idx(p)].normal_impulse = 0.0;
  stamp_approach_speeds(bodies.moving, {&work_, 1});
  const std::array<MovingBody, 2> before{bodies.moving[idx(work_.first)],
                                         bodies.moving[idx(work_.second)]};
  const SimultaneousResult solved = block_.solve({&work_, 1}, bodies.moving);
  const double share = std::min(1.0, 1.0 + restitution);
  const std::array<int, 2> pair{work_.first, work_.second};
  for (std::size_t i = 0; i < 2; ++i) {
    MovingBody& body = bodies.moving[idx(pair[i])];
    const Vec3 spin_w = before[i].angular_velocity_w;
    body.velocity_w = before[i].velocity_w + share * (body.velocity_w - before[i].velocity_w);
    body.angular_velocity_w = spin_w + share * (body.angular_velocity_w - spin_w);
  }
  for (int p = 0; p < collision.count; ++p)
    collision.points[idx(p)].normal_impulse += share * work_.points[idx(p)].normal_impulse;
  return solved.pivots;
}

}  // namespace tumble
