/// \file
/// \brief Bodies of a step that is solved by impulses.
#include "tumble/impulse_damped/impulse_bodies.hpp"

#include "tumble/base/index.hpp"
#include "tumble/contact/impulse_work.hpp"
#include "tumble/impulse_damped/tolerances.hpp"

namespace tumble {

bool ImpulseBodies::moves(const World& world, std::size_t k) const {
  return world.bodies()[k].movable() && !world.sleep_states()[k].asleep;
}

void ImpulseBodies::begin(const World& world, double dt, RotationRule rule,
                          std::span<const PushedPair> pushed) {
  dt_ = dt;
  rule_ = rule;
  ahead_w_ = dt * world.gravity_w;
  predictions_ = 0;
  load_moving_bodies(world, moving_);
  predicted_.assign(world.states().begin(), world.states().end());
  version_.assign(moving_.size(), 0);
  for (int k = 0; k < world.count(); ++k)
    if (!moves(world, idx(k))) freeze(k);
  carried_.find(world.bodies(), moving_, pushed, RigidAt::end);
  for (int k = 0; k < world.count(); ++k)
    if (moves(world, idx(k))) predict(world, k);
}

void ImpulseBodies::predict(const World& world, int body) {
  const std::size_t k = idx(body);
  if (!moves(world, k)) return;
  const BodyProperties& constant = world.bodies()[k];
  MovingBody& moving = moving_[k];
  BodyState& state = predicted_[k];
  state = world.states()[k];
  if (moving.changed)
    state.angular_momentum_w =
        angular_momentum(constant, state.orientation_wb, moving.angular_velocity_w);
  state.linear_momentum_w = constant.mass * (moving.velocity_w + ahead_w_);
  if (carried_.carries(body)) {
    carried_.set_velocity(body, moving);
    state.position_w += dt_ * (constant.inverse_mass * state.linear_momentum_w);
    carried_.carry(body, dt_, state);
  } else {
    advance_pose(constant, state, dt_, rule_);
  }
  moving.position_w = state.position_w;
  ++version_[k];
  ++predictions_;
}

void ImpulseBodies::carry(const World& world) {
  if (carried_.bodies().empty()) return;
  carried_.set_velocities(moving_);
  for (const int body : carried_.bodies()) {
    const Vec3 straight_w =
        world.states()[idx(body)].position_w + dt_ * (moving_[idx(body)].velocity_w + ahead_w_);
    const Vec3 now_w = straight_w + carried_.offset_w(body, dt_);
    const double size = world.bodies()[idx(body)].size.minCoeff();
    if ((now_w - moving_[idx(body)].position_w).norm() > tolerance::carried_again * size)
      predict(world, body);
  }
}

void ImpulseBodies::add_gravity(World& world) {
  collided_w_.resize(moving_.size());
  // A body without an impulse keeps the bits of its angular momentum, so `changed` is left alone.
  for (std::size_t k = 0; k < moving_.size(); ++k) {
    collided_w_[k] = moving_[k].velocity_w;
    if (!moves(world, k)) continue;
    world.states()[k].linear_momentum_w += world.bodies()[k].mass * ahead_w_;
    moving_[k].velocity_w += ahead_w_;
  }
  ahead_w_.setZero();
}

double ImpulseBodies::moved_against_gravity(const World& world) const {
  const Vec3 gained_w = dt_ * world.gravity_w;
  double work = 0.0;
  for (std::size_t k = 0; k < moving_.size(); ++k) {
    const Vec3& ended_w = moving_[k].velocity_w;
    if (!moves(world, k) || ended_w == collided_w_[k] + gained_w) continue;  // it stays, or flies
    const double mass = world.bodies()[k].mass;
    work += lift_at_end_velocity(world.gravity_w, dt_, mass * collided_w_[k], mass * ended_w);
  }
  return work;
}

void ImpulseBodies::freeze(int body) {
  moving_[idx(body)].inverse_mass.setZero();
  moving_[idx(body)].inverse_inertia_w.setZero();
}

void ImpulseBodies::thaw(const World& world) {
  for (std::size_t k = 0; k < moving_.size(); ++k) {
    if (!moves(world, k)) continue;
    moving_[k].inverse_mass.setConstant(world.bodies()[k].inverse_mass);
    moving_[k].inverse_inertia_w =
        inverse_inertia_w(world.bodies()[k], world.states()[k].orientation_wb);
  }
}

int ImpulseBodies::move(World& world, double& energy) {
  store_moving_bodies(moving_, world);
  carried_.set_velocities(moving_);
  int moved = 0;
  for (std::size_t k = 0; k < moving_.size(); ++k) {
    if (!moves(world, k)) continue;
    if (carried_.carries(static_cast<int>(k))) {
      energy += carried_.move(static_cast<int>(k), dt_, world);
    } else {
      advance_pose(world.bodies()[k], world.states()[k], dt_, rule_);
    }
    ++moved;
  }
  return moved;
}

}  // namespace tumble
