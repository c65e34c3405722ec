/// \file
/// \brief Contacts of bodies in joints.
#include "tumble/exterior_rotation/joint_contacts.hpp"

#include "tumble/base/index.hpp"
#include "tumble/contact/gather.hpp"
#include "tumble/contact/impulse_work.hpp"
#include "tumble/contact/movable_edge.hpp"
#include "tumble/contact/repair.hpp"
#include "tumble/contact/sticky.hpp"
#include "tumble/exterior_rotation/tolerances.hpp"
#include "tumble/previous_work/near_points.hpp"
#include "tumble/previous_work/tolerances.hpp"

#include <algorithm>

namespace tumble {
namespace {

bool any_row(std::span<const Joint> joints) {
  return std::any_of(joints.begin(), joints.end(),
                     [](const Joint& joint) { return joint.hold != JointHold::nothing; });
}

void without_impulses(ContactList& contacts) {
  for (Contact& contact : contacts)
    for (ContactPoint& point : contact.points) {
      point.normal_impulse = 0.0;
      point.friction_impulse_w.setZero();
    }
}

}  // namespace

void HeldPoints::yield(std::span<Vec3> linear_w, std::span<Vec3> angular_w) {
  parts_.resize(linear_w.size());
  for (std::size_t k = 0; k < parts_.size(); ++k) parts_[k] << linear_w[k], angular_w[k];
  forces_->respond(parts_);
  for (std::size_t k = 0; k < parts_.size(); ++k) {
    linear_w[k] = parts_[k].head<3>();
    angular_w[k] = parts_[k].tail<3>();
  }
}

double JointContacts::step(const ButcherTable& table, double dt, std::span<const Joint> joints,
                           JointForces& forces, World& world, StepReport& report) {
  find(world, dt, report);
  impacts_.clear();
  pushes_.clear();
  // [S2.6.5:contacts]
  if (!contacts_.empty()) {
    bounce(dt, joints, forces, world, report);
    press(dt, joints, forces, world, report);
  }
  const double error = runge_kutta_.step(table, dt, joints, forces, world, pushes_);
  // [S2.6.5:contacts]
  if (!contacts_.empty()) {
    load_moving_bodies(world, moving_);
    book_impulses(contacts_, before_, moving_, report.energy);
  }
  last_dt_ = dt;
  return error;
}

// Points that may meet within the step, with the impulses that they had.
void JointContacts::find(const World& world, double dt, StepReport& report) {
  load_moving_bodies(world, moving_);
  const double margin = meeting_margin(world, moving_, dt);
  std::swap(previous_, contacts_);
  repair_bounds(world, margin, bounds_);
  near_.find_pairs(bounds_, pairs_);
  leave_out_joined(world, pairs_);
  const GatherReport found = gather_contacts(world, moving_, pairs_, margin, previous_, contacts_);
  report.pair_tests += found.pair_tests;
  report.deepest_overlap = std::max(report.deepest_overlap, found.deepest_overlap);
  if (!(last_dt_ > 0.0)) return;
  carry_over_impulses(previous_, contacts_);
  scale_impulses(dt / last_dt_, contacts_);
}

// Impulses after which all points move as `least_` asks for.
void JointContacts::solve(std::span<const MovingBody> bodies, std::span<const Contact> contacts,
                          JointForces& forces, StepReport& report) {
  points_.hold(forces);
  points_.take(bodies, contacts, least_);
  points_.require_no_energy();
  report.iterations += iteration_
                           .solve(points_, points_.impulses(),
                                  tolerance::faure_small * points_.first_step(), kBudget)
                           .iterations;
}

// Impacts: all velocities change at once.
void JointContacts::bounce(double dt, std::span<const Joint> joints, JointForces& forces,
                           World& world, StepReport& report) {
  load_moving_bodies(world, before_);
  const auto take_least = [&](bool bounces) {
    bool meet = false;
    least_.clear();
    for (const Contact& contact : contacts_) {
      const StickyScale scale{
          world.gravity_w.norm(),
          movable_edge(world.bodies()[idx(contact.first)], world.bodies()[idx(contact.second)]),
          dt};
      for (int k = 0; k < contact.count; ++k) {
        const ContactPoint& p = contact.points[idx(k)];
        const double gap = std::max(p.distance, 0.0);
        const bool meets = gap < -dt * p.approach_speed;
        const double e = bounces && meets
                             ? sticky_restitution(contact.restitution, p.approach_speed, scale, {})
                             : 0.0;
        least_.push_back(e > 0.0 ? -e * p.approach_speed : -gap / dt);
        meet = meet || meets;
      }
    }
    return meet;
  };
  if (!take_least(true)) return;
  forces.take(before_, joints, world.states());
  impacts_ = contacts_;
  for (const bool bounces : {true, false}) {
    take_least(bounces);
    without_impulses(impacts_);
    solve(before_, impacts_, forces, report);
    moving_ = before_;
    points_.push(impacts_, moving_);
    if (any_row(joints)) forces.project(moving_, joints, world.states());
    BookedEnergy booked;
    book_impulses(impacts_, before_, moving_, booked);
    if (bounces && booked.restitution + booked.friction > 0.0) {
      ++report.fallbacks;
      continue;
    }
    report.energy.restitution += booked.restitution;
    report.energy.friction += booked.friction;
    break;
  }
  store_moving_bodies(moving_, world);
}

// Forces: what the velocities at the end of the step lack.
void JointContacts::press(double dt, std::span<const Joint> joints, JointForces& forces,
                          const World& world, StepReport& report) {
  load_moving_bodies(world, before_);
  forces.hold(world, before_, joints, rates_);
  moving_ = before_;
  for (std::size_t k = 0; k < moving_.size(); ++k) {
    if (!world.bodies()[k].movable()) continue;
    MovingBody& m = moving_[k];
    const Vec3& spin_w = world.states()[k].angular_momentum_w;
    m.velocity_w += dt * m.inverse_mass.cwiseProduct(rates_[k].force_w);
    m.angular_velocity_w +=
        dt * (m.inverse_inertia_w * (rates_[k].torque_w - m.angular_velocity_w.cross(spin_w)));
  }
  least_.clear();
  for (const Contact& contact : contacts_)
    for (int k = 0; k < contact.count; ++k) {
      const double distance = contact.points[idx(k)].distance;
      least_.push_back(distance < 0.0 ? -tolerance::pushed_out * distance / dt : -distance / dt);
    }
  forces.take(moving_, joints, world.states());
  solve(moving_, contacts_, forces, report);
  points_.push(contacts_, moving_);
  pushes_.assign(moving_.size(), Wrench{});
  for (const Contact& contact : contacts_)
    for (int k = 0; k < contact.count; ++k) {
      const ContactPoint& p = contact.points[idx(k)];
      if (!(p.normal_impulse > 0.0)) continue;
      ++report.impulses;
      const Vec3 force_w = (p.normal_impulse * contact.normal_w + p.friction_impulse_w) / dt;
      for (const auto& [body, sign] :
           {std::pair{contact.first, -1.0}, std::pair{contact.second, 1.0}}) {
        Wrench& push = pushes_[idx(body)];
        push.force_w += sign * force_w;
        push.torque_w += sign * (p.position_w - before_[idx(body)].position_w).cross(force_w);
      }
    }
}

}  // namespace tumble
