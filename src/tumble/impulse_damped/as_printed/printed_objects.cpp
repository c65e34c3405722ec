/// \file
/// \brief Bodies as the listings of damped integration see them.
#include "tumble/impulse_damped/as_printed/printed_objects.hpp"

#include "tumble/base/error.hpp"

namespace tumble {

void PrintedObject::set_velocity(const Vec3& value) {
  moving.velocity_w = value;
  moving.changed = true;
  if (one_store && movable) linear_momentum_w = mass * value;
}

void PrintedObject::set_linear_momentum(int axis, double value) {
  linear_momentum_w[axis] = value;
  moving.changed = true;
  if (one_store && movable) moving.velocity_w[axis] = value / mass;
}

void PrintedObject::set_angular_momentum(int axis, double value) {
  angular_momentum_w[axis] = value;
  moving.changed = true;
  if (one_store && movable)
    moving.angular_velocity_w = moving.inverse_inertia_w * angular_momentum_w;
}

void PrintedObject::change(const Vec3& velocity_w, const Vec3& angular_velocity_w) {
  if (!movable) return;
  moving.velocity_w += velocity_w;
  moving.angular_velocity_w += angular_velocity_w;
  moving.changed = true;
  linear_momentum_w += mass * velocity_w;
  angular_momentum_w += inertia_w * angular_velocity_w;
}

double PrintedObject::kinetic_energy(const Vec3& boost_w) const {
  if (!movable) return 0.0;
  return 0.5 * mass * (linear_momentum_w / mass + boost_w).squaredNorm() +
         0.5 * angular_momentum_w.dot(moving.inverse_inertia_w * angular_momentum_w);
}

void PrintedObjects::begin(const World& world, std::span<const std::uint8_t> stable,
                           std::span<const Vec3> fixed_w, const DampedErrata& repaired) {
  require::that(stable.size() == world.states().size() && fixed_w.size() == world.states().size(),
                "stable, fixed_w: one entry for each body of the world is needed");
  whole_pose_ = repaired.has("RC4");
  const bool one_store = repaired.has("C6");
  original_.assign(world.states().begin(), world.states().end());
  objects_.resize(original_.size());
  for (std::size_t k = 0; k < objects_.size(); ++k) {
    const BodyProperties& body = world.bodies()[k];
    const BodyState& state = original_[k];
    PrintedObject& o = objects_[k];
    o = PrintedObject{};
    o.movable = body.movable();
    o.geometrically_stable = stable[k] != 0;
    o.one_store = one_store;
    o.mass = body.mass;
    o.linear_momentum_w = state.linear_momentum_w;
    o.angular_momentum_w = state.angular_momentum_w;
    o.moving = moving_body_of(body, state);
    if (!o.movable) {
      o.moving.velocity_w = fixed_w[k];
      continue;
    }
    const Mat3 axes_w = state.orientation_wb.toRotationMatrix();
    o.inertia_w = axes_w * body.inertia_b.asDiagonal() * axes_w.transpose();
  }
}

int PrintedObjects::integrate_positions(World& world, double dt, const Vec3& ahead_w,
                                        RotationRule rule) {
  int moved = 0;
  for (std::size_t k = 0; k < objects_.size(); ++k) {
    PrintedObject& o = objects_[k];
    if (!o.movable) continue;
    BodyState predicted = world.states()[k];
    predicted.linear_momentum_w = o.mass * (o.moving.velocity_w + ahead_w);
    if (o.moving.changed)  // else the momentum is there with all its bits
      predicted.angular_momentum_w = o.inertia_w * o.moving.angular_velocity_w;
    advance_pose(world.bodies()[k], predicted, dt, rule);
    world.states()[k].position_w = predicted.position_w;
    world.states()[k].orientation_wb = predicted.orientation_wb;
    o.moving.position_w = predicted.position_w;
    ++moved;
  }
  return moved;
}

void PrintedObjects::revert_to_original_positions(World& world) const {
  for (std::size_t k = 0; k < objects_.size(); ++k) {
    world.states()[k].position_w = original_[k].position_w;
    if (whole_pose_) world.states()[k].orientation_wb = original_[k].orientation_wb;
  }
}

void PrintedObjects::end(World& world) const {
  for (std::size_t k = 0; k < objects_.size(); ++k) {
    const PrintedObject& o = objects_[k];
    if (!o.movable || !o.moving.changed) continue;
    world.states()[k].linear_momentum_w = o.linear_momentum_w;
    world.states()[k].angular_momentum_w = o.angular_momentum_w;
  }
}

}  // namespace tumble
