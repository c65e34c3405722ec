/// \file
/// \brief Springs and dampers where bodies overlap.
#include "cushion.hpp"

#include <algorithm>
#include <tumble/base/error.hpp>
#include <tumble/base/index.hpp>
#include <tumble/base/number_text.hpp>
#include <tumble/contact/contact_records.hpp>
#include <tumble/contact/effective_mass.hpp>
#include <tumble/dynamics/advance_pose.hpp>

namespace example {
using namespace tumble;

// [refused]
Cushion::Cushion(const CushionOptions& options) : options_(options) {
  require::positive(options.spring, "spring");
  require::not_negative(options.damper, "damper");
  const double sum = options.spring + 2.0 * options.damper;
  require::that(sum < 4.0, "spring + 2 damper = " + shortest_text(sum) + ": expected below 4");
  require::that(options.substeps >= 1,
                "substeps = " + std::to_string(options.substeps) + ": expected 1 or more");
}
// [refused]

std::unique_ptr<Technique> Cushion::clone() const { return std::make_unique<Cushion>(*this); }

std::vector<std::string> Cushion::ignores(const World& world) const {
  for (const BodyProperties& body : world.bodies())
    if (body.restitution > 0.0) return {"restitution"};
  return {};
}

// [step]
StepReport Cushion::step(World& world, double dt) {
  require::positive(dt, "dt");
  StepReport report;
  for (int k = 0; k < options_.substeps; ++k) substep(world, dt / options_.substeps, report);
  for (ContactRecord& record : records_)  // of the last substep
    record.time = world.time() + dt - dt / options_.substeps;
  world.finish_step(dt);
  return report;
}

void Cushion::substep(World& world, double h, StepReport& report) {
  load_moving_bodies(world, start_);
  for (std::size_t k = 0; k < start_.size(); ++k)  // gravity
    if (world.bodies()[k].movable())
      world.states()[k].linear_momentum_w += world.bodies()[k].mass * h * world.gravity_w;
  load_moving_bodies(world, moving_);

  find_contacts(world, report);
  push(h);
  rub();
  record(h, report);

  store_moving_bodies(moving_, world);
  for (std::size_t k = 0; k < start_.size(); ++k) {
    if (!world.bodies()[k].movable()) continue;
    advance_pose(world.bodies()[k], world.states()[k], h, RotationRule::splitting);
    ++report.integrations;
  }
}
// [step]

// [contacts]
void Cushion::find_contacts(const World& world, StepReport& report) {
  bounds_.clear();
  for (std::size_t k = 0; k < start_.size(); ++k)
    bounds_.push_back(bounds_of(world.bodies()[k], world.states()[k]));
  near_.find_pairs(bounds_, pairs_);
  const auto found = gather_contacts(world, moving_, pairs_, 0.0, {}, contacts_);
  report.pair_tests += found.pair_tests;
  report.deepest_overlap = std::max(report.deepest_overlap, found.deepest_overlap);
}
// [contacts]

// [split]
// A body with five contacts counts in each of them as a fifth of it.
void Cushion::split_bodies() {
  split_ = moving_;
  for (MovingBody& body : split_) {
    body.inverse_mass.setZero();
    body.inverse_inertia_w.setZero();
  }
  for (const Contact& contact : contacts_) {
    for (const int k : {contact.first, contact.second}) {
      split_[idx(k)].inverse_mass += moving_[idx(k)].inverse_mass;
      split_[idx(k)].inverse_inertia_w += moving_[idx(k)].inverse_inertia_w;
    }
  }
}
// [split]

// [push]
// The spring and the damper of each point, before any of them has pushed.
void Cushion::push(double h) {
  split_bodies();
  for (Contact& c : contacts_) {
    const MovingBody& a = split_[idx(c.first)];
    const MovingBody& b = split_[idx(c.second)];
    for (int k = 0; k < c.count; ++k) {
      ContactPoint& p = c.points[idx(k)];
      const double mass = effective_mass(a, b, p.position_w, c.normal_w) / c.count;
      const double approach = -c.normal_w.dot(relative_velocity(a, b, p.position_w));
      const double speed = options_.spring * -p.distance / h + options_.damper * approach;
      p.normal_impulse = std::max(0.0, mass * speed);
      apply_impulse(moving_[idx(c.first)], moving_[idx(c.second)], p.position_w,
                    p.normal_impulse * c.normal_w);
    }
  }
}
// [push]

// [rub]
// Friction: a damper across the normal, up to Coulomb's limit.
void Cushion::rub() {
  split_bodies();
  for (Contact& c : contacts_) {
    const MovingBody& a = split_[idx(c.first)];
    const MovingBody& b = split_[idx(c.second)];
    for (int k = 0; k < c.count; ++k) {
      ContactPoint& p = c.points[idx(k)];
      Vec3 slip_w = relative_velocity(a, b, p.position_w);
      slip_w -= c.normal_w.dot(slip_w) * c.normal_w;
      const double speed = slip_w.norm();
      if (!(speed > 0.0)) continue;
      const double mass = effective_mass(a, b, p.position_w, slip_w / speed) / c.count;
      const double impulse = std::min(c.friction * p.normal_impulse, mass * speed);
      p.friction_impulse_w = -impulse / speed * slip_w;
      apply_impulse(moving_[idx(c.first)], moving_[idx(c.second)], p.position_w,
                    p.friction_impulse_w);
    }
  }
}
// [rub]

// [record]
// Work is an impulse times the mean of the velocities before and after; users get forces.
void Cushion::record(double h, StepReport& report) {
  records_.clear();
  for (const Contact& c : contacts_) {
    for (int k = 0; k < c.count; ++k) {
      const ContactPoint& p = c.points[idx(k)];
      const auto slip_w = [&](const std::vector<MovingBody>& bodies) {
        return relative_velocity(bodies[idx(c.first)], bodies[idx(c.second)], p.position_w);
      };
      const Vec3 mean_w = 0.5 * (slip_w(start_) + slip_w(moving_));
      report.energy.restitution += p.normal_impulse * c.normal_w.dot(mean_w);
      report.energy.friction += p.friction_impulse_w.dot(mean_w);
      report.impulses += p.normal_impulse > 0.0 ? 1 : 0;
      records_.push_back(record_of(c, k, 0.0));
      records_.back().push_w /= h;
      records_.back().is_impulse = false;
    }
  }
  report.contacts = static_cast<std::int64_t>(records_.size());
}
// [record]

}  // namespace example
