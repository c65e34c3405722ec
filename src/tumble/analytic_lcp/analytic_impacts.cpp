/// \file
/// \brief Collisions of the analytic technique, and records of its contacts and of their work.
#include "tumble/analytic_lcp/analytic.hpp"
#include "tumble/analytic_lcp/touch.hpp"
#include "tumble/base/index.hpp"
#include "tumble/contact/contact_records.hpp"

#include <algorithm>

namespace tumble {
namespace {

// The fastest approach decides for the whole contact.
double fastest_point(const Contact& contact) {
  double least = contact.points[0].approach_speed;
  for (int k = 1; k < contact.count; ++k)
    least = std::min(least, contact.points[idx(k)].approach_speed);
  return least;
}

}  // namespace

// Returns whether there was a collision.
bool Analytic::collide(World& world, const Progress& progress, StepReport& report) {
  islands_.build(world.bodies(), near_);
  bool any = false;
  for (int i = 0; i < islands_.count(); ++i) {
    const std::span<const int> which = islands_.contacts(i);
    const bool collision = std::any_of(which.begin(), which.end(), [&](int c) {
      const Contact& contact = near_[idx(c)];
      const TouchScale scale = touch_scale(world, contact.first, contact.second, progress.dt);
      const auto end = contact.points.begin() + contact.count;
      return std::any_of(contact.points.begin(), end, [&](const ContactPoint& point) {
        return motion_of(point, scale) == PointMotion::collides;
      });
    });
    if (!collision) continue;
    resolve(which, world, progress, report);
    any = true;
  }
  if (!any) return false;
  store_moving_bodies(moving_, world);
  load_moving_bodies(world, moving_);
  stamp_approach_speeds(moving_, near_);
  return true;
}

// All contacts of an island together; points that are still to meet are left out.
void Analytic::resolve(std::span<const int> which, const World& world, const Progress& progress,
                       StepReport& report) {
  island_.clear();
  for (const int c : which) island_.push_back(near_[idx(c)]);
  keep_points(island_, [&](const Contact& contact, const ContactPoint& point) {
    const TouchScale scale = touch_scale(world, contact.first, contact.second, progress.dt);
    return motion_of(point, scale) != PointMotion::waits;
  });
  if (is_too_large(island_)) {
    too_large_ = true;
    return;
  }
  // [S4.3:sticky]
  // Slow ones stick. Each contact is judged by its fastest point.
  for (Contact& contact : island_) {
    const TouchScale touch = touch_scale(world, contact.first, contact.second, progress.dt);
    const StickyScale scale{world.gravity_w.norm(), touch.size, progress.dt};
    contact.restitution =
        sticky_restitution(contact.restitution, fastest_point(contact), scale, options_.sticky);
    if (options_.friction != AnalyticFriction::coulomb) contact.friction = 0.0;
  }
  // [S4.3:sticky]
  const ImpactResult impact = impacts_.resolve(island_, moving_, {.order = options_.impacts});
  const bool settled = impact.status == ImpactStatus::done;
  if (settled || !resolve_by_velocities(world, progress, report)) {
    report.events += impact.collisions;
    book(impact, report);
    if (!settled) report.status = std::max(report.status, StepStatus::event_cap);
  }
  for (const Contact& contact : island_) record_impact(contact, world.time() + progress.passed);
}

void Analytic::record_impact(const Contact& contact, double time) {
  add_records({&contact, 1}, time, records_);
  Event moment{.time = time, .rewinds = rewound_};
  // Rewinds are reported with the first of the collisions.
  if (report_collision(contact, moment, observer())) rewound_ = 0;
}

// The forces of the last flight: impulses over its length.
void Analytic::record_forces(double time, double duration, StepReport& report) {
  for (const Contact& contact : resting_) {
    if (forces_.held().both(contact)) continue;  // no force is known
    report.contacts += contact.count;
    for (int k = 0; k < contact.count; ++k) {
      ContactRecord& record = records_.emplace_back(record_of(contact, k, time));
      record.push_w /= duration;
      record.is_impulse = false;
    }
  }
}

// The work of the contact forces: impulse times mean velocity, exact where bodies do not turn.
void Analytic::book_work(const World& world, double time, StepReport& report) {
  // Points and bodies at the pose for which the forces were found; velocities from both ends.
  load_moving_bodies(world, ended_);
  const double share = time / recorded_for_;
  // A body that is held is booked as a whole, below: what holds it up is known as a sum only.
  const auto mean_velocity = [&](int body, const Vec3& point_w) -> Vec3 {
    if (forces_.held().holds(world, body)) return Vec3::Zero();
    const BodyProperties& b = world.bodies()[idx(body)];
    const BodyState& start = flight_.start()[idx(body)];
    const Vec3 turning = 0.5 * (angular_velocity(b, start) + ended_[idx(body)].angular_velocity_w);
    return 0.5 * (velocity(b, start) + ended_[idx(body)].velocity_w) +
           turning.cross(point_w - moving_[idx(body)].position_w);
  };
  for (const Contact& contact : resting_) {
    for (int k = 0; k < contact.count; ++k) {
      const ContactPoint& point = contact.points[idx(k)];
      const Vec3 slip_w = mean_velocity(contact.second, point.position_w) -
                          mean_velocity(contact.first, point.position_w);
      report.energy.restitution += share * point.normal_impulse * contact.normal_w.dot(slip_w);
      report.energy.friction += share * point.friction_impulse_w.dot(slip_w);
    }
  }
  for (int b = 0; b < world.count(); ++b) {
    report.energy.repair -=
        world.bodies()[idx(b)].movable()
            ? world.bodies()[idx(b)].mass * world.gravity_w.dot(flight_.offset_w(b, time))
            : 0.0;
    if (!forces_.held().holds(world, b)) continue;
    const BodyProperties& body = world.bodies()[idx(b)];
    const BodyState& start = flight_.start()[idx(b)];
    const MovingBody& end = ended_[idx(b)];
    const Wrench& acts = forces_.wrenches()[idx(b)];
    report.energy.restitution +=
        0.5 * time *
        (acts.force_w.dot(velocity(body, start) + end.velocity_w) +
         acts.torque_w.dot(angular_velocity(body, start) + end.angular_velocity_w));
  }
}

}  // namespace tumble
