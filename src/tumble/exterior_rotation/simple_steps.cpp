/// \file
/// \brief Steps with one evaluation of forces.
#include "tumble/exterior_rotation/simple_steps.hpp"

#include "tumble/base/index.hpp"
#include "tumble/math/rotation.hpp"

#include <algorithm>

namespace tumble {

void SimpleSteps::step(SimpleScheme scheme, PoseUpdate pose, double dt,
                       std::span<const Joint> joints, JointForces& forces, World& world) {
  find_references(joints, world);
  switch (scheme) {
    // [S6.2:simple]
    case SimpleScheme::forward_euler:  // the old velocities move the bodies
      find_rates(pose, joints, forces, world);
      move(pose, dt, world);
      kick(pose, dt, world);
      break;
    case SimpleScheme::semi_implicit:  // the new ones do
      find_rates(pose, joints, forces, world);
      kick(pose, dt, world);
      move(pose, dt, world);
      break;
    // [S6.2:simple]
    // [S6.2:impulse]
    case SimpleScheme::impulse:  // gravity; then joints remove the velocity that they forbid
      load_moving_bodies(world, moving_);
      for (std::size_t k = 0; k < moving_.size(); ++k)
        if (world.bodies()[k].movable()) moving_[k].velocity_w += dt * world.gravity_w;
      forces.project(moving_, joints, world.states());
      put_velocities(world);
      find_references(joints, world);
      before_.assign(world.states().begin(), world.states().end());
      move(pose, dt, world);
      for (std::size_t k = 0; k < before_.size(); ++k) {  // only impulses change momenta
        world.states()[k].linear_momentum_w = before_[k].linear_momentum_w;
        world.states()[k].angular_momentum_w = before_[k].angular_momentum_w;
      }
      break;
    // [S6.2:impulse]
    // [S6.2:leapfrog]
    case SimpleScheme::leapfrog:  // half a step of motion, forces there, the other half
      move(pose, 0.5 * dt, world);
      before_.assign(world.states().begin(), world.states().end());
      // The rates depend on the velocities in the middle of the kick: half a kick as a trial.
      find_rates(pose, joints, forces, world);
      kick(pose, 0.5 * dt, world);
      find_rates(pose, joints, forces, world);
      std::copy(before_.begin(), before_.end(), world.states().begin());
      for (std::size_t k = 0; k < reference_w_.size(); ++k)
        reference_w_[k] -= 0.5 * dt * reference_rate_w_[k];
      kick(pose, dt, world);
      move(pose, 0.5 * dt, world);
      break;
      // [S6.2:leapfrog]
  }
}

// The reference velocity u of each body: 0 for a group that joints connect to an immovable body, otherwise
// that of the group's centre of mass, which only gravity changes.
void SimpleSteps::find_references(std::span<const Joint> joints, const World& world) {
  pairs_.clear();
  for (const Joint& joint : joints)
    if (joint.hold != JointHold::nothing) pairs_.push_back({joint.first, joint.second});
  groups_.build_from_pairs(world.bodies(), pairs_);
  reference_w_.assign(idx(world.count()), Vec3::Zero());
  reference_rate_w_.assign(idx(world.count()), Vec3::Zero());
  for (int group = 0; group < groups_.count(); ++group) {
    const auto held = [&](int c) {
      return !world.bodies()[idx(pairs_[idx(c)].first)].movable() ||
             !world.bodies()[idx(pairs_[idx(c)].second)].movable();
    };
    const std::span<const int> contacts = groups_.contacts(group);
    if (std::any_of(contacts.begin(), contacts.end(), held)) continue;
    double mass = 0.0;
    Vec3 momentum_w = Vec3::Zero();
    for (const int b : groups_.bodies(group)) {
      mass += world.bodies()[idx(b)].mass;
      momentum_w += world.states()[idx(b)].linear_momentum_w;
    }
    for (const int b : groups_.bodies(group)) {
      reference_w_[idx(b)] = momentum_w / mass;
      reference_rate_w_[idx(b)] = world.gravity_w;
    }
  }
}

// The wrench on each body now, and the rate of its twist.
void SimpleSteps::find_rates(PoseUpdate pose, std::span<const Joint> joints, JointForces& forces,
                             const World& world) {
  load_moving_bodies(world, moving_);
  forces.hold(world, moving_, joints, wrenches_);
  if (pose == PoseUpdate::separate) return;
  rates_.assign(moving_.size(), Acceleration{});
  for (std::size_t k = 0; k < moving_.size(); ++k) {
    const MovingBody& m = moving_[k];
    if (!world.bodies()[k].movable()) continue;
    // [S6.2:twist]
    // The motion itself turns v - u with the body; forces change the rest.
    const Vec3& omega_w = m.angular_velocity_w;
    rates_[k].linear_w = m.inverse_mass.cwiseProduct(wrenches_[k].force_w) -
                         omega_w.cross(m.velocity_w - reference_w_[k]);
    rates_[k].angular_w =
        m.inverse_inertia_w *
        (wrenches_[k].torque_w - omega_w.cross(world.states()[k].angular_momentum_w));
    // [S6.2:twist]
  }
}

// Changes the velocities: the momenta by forces and torques, or the twist at the present position. Forward
// Euler has moved the body since the rates were computed, and a twist has another velocity at another
// point, relative to the reference velocity.
void SimpleSteps::kick(PoseUpdate pose, double dt, World& world) {
  if (pose == PoseUpdate::separate) {
    for (std::size_t k = 0; k < wrenches_.size(); ++k) {
      if (!world.bodies()[k].movable()) continue;
      world.states()[k].linear_momentum_w += dt * wrenches_[k].force_w;
      world.states()[k].angular_momentum_w += dt * wrenches_[k].torque_w;
    }
    return;
  }
  for (std::size_t k = 0; k < rates_.size(); ++k) {
    const Vec3 since_w = world.states()[k].position_w - moving_[k].position_w;
    moving_[k] = moving_body_of(world.bodies()[k], world.states()[k]);
    moving_[k].velocity_w += dt * (rates_[k].linear_w + rates_[k].angular_w.cross(since_w));
    moving_[k].angular_velocity_w += dt * rates_[k].angular_w;
    reference_w_[k] += dt * reference_rate_w_[k];
  }
  put_velocities(world);
}

void SimpleSteps::move(PoseUpdate pose, double dt, World& world) {
  load_moving_bodies(world, moving_);
  for (std::size_t k = 0; k < moving_.size(); ++k) {
    if (!world.bodies()[k].movable()) continue;
    BodyState& state = world.states()[k];
    MovingBody& m = moving_[k];
    // [S6.2:move]
    const Vec3 rotation_w = dt * m.angular_velocity_w;
    const Quat turn = rotation_from_vector(rotation_w);
    state.orientation_wb = normalised(turn * state.orientation_wb);
    if (pose == PoseUpdate::separate) {
      state.position_w += dt * m.velocity_w;
      continue;
    }
    const Vec3 relative_w = m.velocity_w - reference_w_[k];
    state.position_w += dt * reference_w_[k] + along_arc(rotation_w, dt * relative_w);
    m.velocity_w = reference_w_[k] + turn * relative_w;
    // [S6.2:move]
    m.position_w += dt * reference_w_[k];  // kick() measures relative to this motion
    m.changed = true;
    store_moving_body(m, world.bodies()[k], state);
  }
}

void SimpleSteps::put_velocities(World& world) {
  for (MovingBody& m : moving_) m.changed = true;
  store_moving_bodies(moving_, world);
}

}  // namespace tumble
