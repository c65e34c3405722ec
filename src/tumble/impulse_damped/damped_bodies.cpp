/// \file
/// \brief Velocities, predicted poses and marks of damped integration's bodies.
#include "tumble/impulse_damped/damped_bodies.hpp"

#include "tumble/base/index.hpp"
#include "tumble/base/state_hash.hpp"
#include "tumble/contact/tolerances.hpp"

#include <cmath>

namespace tumble {

void DampedBodies::load(const World& world, std::span<const char> firmly) {
  load_moving_bodies(world, moving);
  predicted.assign(world.states().begin(), world.states().end());
  moved_with_.assign(moving.size(), Motion{});
  axes_w.clear();
  for (const BodyState& state : predicted)
    axes_w.push_back(state.orientation_wb.toRotationMatrix());
  stable.assign(firmly.begin(), firmly.end());
  touched.assign(moving.size(), 0);
  for (std::size_t k = 0; k < moving.size(); ++k) set_ease(world, static_cast<int>(k));
}

bool DampedBodies::Motion::same_bits(const Motion& other) const {
  return any == other.any && changed == other.changed && dt == other.dt && rule == other.rule &&
         tumble::same_bits(velocity_w, other.velocity_w) &&
         tumble::same_bits(angular_velocity_w, other.angular_velocity_w);
}

int DampedBodies::predict(const World& world, double dt, RotationRule rule) {
  int advanced = 0;
  for (std::size_t k = 0; k < moving.size(); ++k) {
    const BodyProperties& body = world.bodies()[k];
    if (!body.movable() || world.sleep_states()[k].asleep) continue;
    ++advanced;
    const Motion with{.any = true,
                      .changed = moving[k].changed,
                      .dt = dt,
                      .velocity_w = moving[k].velocity_w,
                      .angular_velocity_w = moving[k].angular_velocity_w,
                      .rule = rule};
    if (with.same_bits(moved_with_[k])) continue;
    moved_with_[k] = with;
    BodyState& state = predicted[k];
    state = world.states()[k];
    if (moving[k].changed) {
      state.linear_momentum_w = body.mass * moving[k].velocity_w;
      state.angular_momentum_w = angular_momentum(body, axes_w[k], moving[k].angular_velocity_w);
    }
    state.linear_momentum_w += dt * body.mass * world.gravity_w;
    advance_pose(body, state, dt, rule);
    moving[k].position_w = state.position_w;
  }
  return advanced;
}

void DampedBodies::clear_tilted(const World& world, std::span<const Contact> collisions) {
  for (const Contact& contact : collisions) {
    const double x = contact.normal_w.x();
    const double z = contact.normal_w.z();
    if (std::sqrt(x * x + z * z) <= tolerance::vertical_normal) continue;
    for (const int body : {contact.first, contact.second}) {
      if (stable[idx(body)] == 0 || !world.bodies()[idx(body)].movable()) continue;
      stable[idx(body)] = 0;
      set_ease(world, body);
    }
  }
}

bool DampedBodies::holds_firm(const World& world, const Contact& contact) const {
  for (const int body : {contact.first, contact.second})
    if (stable[idx(body)] != 0 && world.bodies()[idx(body)].movable()) return true;
  return false;
}

void DampedBodies::set_ease(const World& world, int body) {
  const BodyProperties& properties = world.bodies()[idx(body)];
  MovingBody& m = moving[idx(body)];
  m.inverse_mass.setZero();
  m.inverse_inertia_w.setZero();
  if (!properties.movable() || world.sleep_states()[idx(body)].asleep) return;
  m.inverse_mass.setConstant(properties.inverse_mass);
  m.inverse_inertia_w = inverse_inertia_w(properties, world.states()[idx(body)].orientation_wb);
  if (stable[idx(body)] == 0) return;
  const double about_y = m.inverse_inertia_w(1, 1);
  m.inverse_mass.y() = 0.0;
  m.inverse_inertia_w.setZero();
  m.inverse_inertia_w(1, 1) = about_y;
}

double kinetic_energy_of(const BodyProperties& body, const Mat3& axes_w, const MovingBody& moving) {
  if (!body.movable()) return 0.0;
  const Vec3 momentum_w = angular_momentum(body, axes_w, moving.angular_velocity_w);
  return 0.5 * body.mass * moving.velocity_w.squaredNorm() +
         0.5 * moving.angular_velocity_w.dot(momentum_w);
}

}  // namespace tumble
