/// \file
/// \brief The default technique: bounces, repair and the books.
#include "tumble/base/index.hpp"
#include "tumble/contact/tolerances.hpp"
#include "tumble/contact_damped/contact_damped.hpp"
#include "tumble/contact_damped/patch_solver.hpp"
#include "tumble/contact_damped/tolerances.hpp"
#include "tumble/math/rotation.hpp"

#include <algorithm>
#include <cmath>

namespace tumble {
namespace {

constexpr int kBouncePasses = 10;    // over all areas
constexpr int kBounceRounds = 20;    // of friction and pressure in turn within an area
constexpr int kHurriedRepairs = 10;  // over a island that hurries
constexpr double kRepaired = 0.05;   // share of a move, of the largest one, that is none

// Approaches slower than this stick (thesis 4.3) [m/s].
double sticky_speed(double gravity, double size, double dt) {
  return gravity > 0.0 ? tolerance::sticky_speed * std::sqrt(gravity * size)
                       : tolerance::sticky_speed_weightless * size / dt;
}

// Whether an area was hit: a point of it was pushed and had approached fast.
bool was_hit(const ContactPatch& block, double gravity, double dt) {
  const double slowest = sticky_speed(gravity, block.size, dt);
  return std::any_of(
      block.points.begin(), block.points.begin() + block.count,
      [&](const ContactPatchPoint& p) { return p.impulse > 0.0 && p.approach < -slowest; });
}

}  // namespace

// Newton's restitution for impacts faster than the sticky speed (thesis 4.3), after the bodies have come
// together, island by island.
void ContactDamped::bounce(World& world, double dt, StepReport& report) {
  const double g = world.gravity_w.norm();
  bounced_ = false;
  hit_.assign(areas_.blocks().size(), 0);
  for (int island = 0; island < islands_.count(); ++island) {
    bool bounces = false;
    for (const int contact : islands_.contacts(island)) {
      const ContactPatch& block = areas_.blocks()[at(contact)];
      if (!was_hit(block, g, dt)) continue;
      hit_[at(contact)] = 1;
      ++report.events;
      bounces = bounces || block.restitution > 0.0;
    }
    if (!bounces) continue;
    if (!bounced_) moved_ = bodies_;
    bounced_ = true;
    bounce_island(world, island, dt, report);
  }
  if (bounced_) store_moving_bodies(bodies_, world);
  if (observer() == nullptr) return;
  for (std::size_t k = 0; k < hit_.size(); ++k)
    if (hit_[k] != 0) tell(areas_.blocks()[k], world.time());
}

// Points that were hit part with the speed that restitution asks for. Should friction make it raise the
// energy, the bounce is drawn back.
void ContactDamped::bounce_island(const World& world, int island, double dt, StepReport& report) {
  const double g = world.gravity_w.norm();
  const std::span<const int> contacts = islands_.contacts(island);
  for (const int contact : contacts) {
    ContactPatch& block = areas_.blocks()[at(contact)];
    require_separation(sticky_speed(g, block.size, dt), block);
  }
  for (int pass = 0; pass < kBouncePasses; ++pass) {
    double most = 0.0;
    for (const int contact : contacts) {
      ContactPatch& block = areas_.blocks()[at(contact)];
      most = std::max(most, solve_patch(block, bodies_[at(block.first)], bodies_[at(block.second)],
                                        kBounceRounds));
    }
    ++report.iterations;
    report.impulses += static_cast<std::int64_t>(contacts.size());
    if (most < tolerance::contact_settled * speed_scale(world, island, dt)) break;
  }
  guard_energy(world, island, report);
}

// Overlap beyond the slop goes by moves, from the ground up, over all areas in which some is left.
void ContactDamped::repair(World& world, double dt, StepReport& report) {
  const auto deep = [](const ContactPatch& block) {
    return std::any_of(block.points.begin(), block.points.begin() + block.count,
                       [&](const ContactPatchPoint& p) {
                         return -p.gap > tolerance::contact_damped_slop * block.size;
                       });
  };
  if (std::none_of(areas_.blocks().begin(), areas_.blocks().end(), deep)) return;
  // Moves have no momentum to keep, so all bodies weigh the same: a light box below a heavy one does
  // not need more passes than any other.
  moves_ = bodies_;
  for (MovingBody& body : moves_) {
    body.velocity_w.setZero();
    body.angular_velocity_w.setZero();
    body.changed = false;
    if (body.inverse_mass.x() == 0.0) continue;
    body.inverse_inertia_w /= body.inverse_mass.x();
    body.inverse_mass.setOnes();
  }
  for (int island = 0; island < islands_.count(); ++island) {
    const std::span<const int> contacts = ordered(island);
    if (std::none_of(contacts.begin(), contacts.end(),
                     [&](int c) { return deep(areas_.blocks()[at(c)]); }))
      continue;
    // A island that hurries makes new overlap in each step, and gets few passes.
    const int passes = hurries(world, island, dt)
                           ? std::min(options_.repair_passes, kHurriedRepairs)
                           : options_.repair_passes;
    for (const int contact : contacts) {
      ContactPatch& block = areas_.blocks()[at(contact)];
      begin_lift(moves_[at(block.first)], moves_[at(block.second)], block);
    }
    double first = 0.0;
    for (int pass = 0; pass < passes; ++pass) {
      double most = 0.0;  // [-] as a share of the size
      for (const int contact : contacts) {
        ContactPatch& block = areas_.blocks()[at(contact)];
        most = std::max(
            most, lift_patch(block, tolerance::repair_rest * block.size, tolerance::repair_share,
                             moves_[at(block.first)], moves_[at(block.second)]) /
                      block.size);
      }
      if (pass == 0) first = most;
      if (most < kRepaired * std::max(first, tolerance::contact_damped_slop)) break;
    }
  }
  for (std::size_t k = 0; k < moves_.size(); ++k) {
    if (!moves_[k].changed || moves_[k].inverse_mass.x() == 0.0) continue;
    const BodyProperties& body = world.bodies()[k];
    BodyState& state = world.states()[k];
    report.energy.repair -=
        kinetic_energy(body, state) + body.mass * world.gravity_w.dot(moves_[k].velocity_w);
    state.position_w += moves_[k].velocity_w;
    state.orientation_wb =
        (rotation_from_vector(moves_[k].angular_velocity_w) * state.orientation_wb).normalized();
    report.energy.repair += kinetic_energy(body, state);
  }
}

// The work of the impulses: each times the mean of the motions at the start, before gravity, and at the
// end. What friction does not do is restitution's. A body that bounced has its new velocity where it hit, not
// where gravity would have taken it meanwhile; that is restitution's too.
void ContactDamped::account(const World& world, double dt, StepReport& report) {
  double all = 0.0;
  for (std::size_t k = 0; k < bodies_.size(); ++k) {
    if (bodies_[k].inverse_mass.x() == 0.0 || flies_[k] != 0) continue;
    const BodyProperties& body = world.bodies()[k];
    const Vec3 change_w = bodies_[k].velocity_w - start_[k].velocity_w - dt * world.gravity_w;
    all += 0.5 * body.mass * change_w.dot(bodies_[k].velocity_w + start_[k].velocity_w);
    if (bounced_) {
      const Vec3 mean_w = 0.5 * (bodies_[k].velocity_w + start_[k].velocity_w);
      all += dt * body.mass * world.gravity_w.dot(mean_w - moved_[k].velocity_w);
    }
    // The inertia is that of the start of the step, for both.
    const Vec3 turn_w = bodies_[k].angular_velocity_w - start_[k].angular_velocity_w;
    const Mat3 inertia_w = bodies_[k].inverse_inertia_w.inverse();
    all += 0.5 *
           (inertia_w * turn_w).dot(bodies_[k].angular_velocity_w + start_[k].angular_velocity_w);
  }
  for (const ContactPatch& block : areas_.blocks()) {
    const Six u = motion_of(block, start_[at(block.first)], start_[at(block.second)]);
    const Six v = motion_of(block, bodies_[at(block.first)], bodies_[at(block.second)]);
    report.energy.friction +=
        0.5 * (block.along_impulse * (u[0] + v[0]) + block.across_impulse * (u[1] + v[1]) +
               block.twist_impulse * (u[5] + v[5]));
  }
  report.energy.restitution = all - report.energy.friction;
  for (const ContactPatch& block : areas_.blocks())
    report.contacts += std::count_if(block.points.begin(), block.points.begin() + block.count,
                                     [](const ContactPatchPoint& p) { return p.impulse > 0.0; });
  const auto finite = [](const MovingBody& body) {
    return body.velocity_w.allFinite() && body.angular_velocity_w.allFinite();
  };
  if (!std::all_of(bodies_.begin(), bodies_.end(), finite)) report.status = StepStatus::not_finite;
}

void ContactDamped::tell(const ContactPatch& block, double time) const {
  Event event;
  event.time = time;
  event.first = block.first_id;
  event.second = block.second_id;
  event.normal_w = block.frame_w.col(2);
  event.point_w = start_[at(block.first)].position_w + block.first_arm_w;
  const Six impulse = impulse_of(block);
  event.impulse_w = block.frame_w * Vec3(impulse[0], impulse[1], impulse[2]);
  observer()->on_event(event);
}

// Made when somebody asks. A point's friction is the area's, by its share of the pressure.
std::span<const ContactRecord> ContactDamped::contacts() const {
  if (recorded_) return records_;
  records_.clear();
  for (const ContactPatch& block : areas_.blocks()) {
    const Six all = impulse_of(block);
    const double friction = std::sqrt(all[0] * all[0] + all[1] * all[1]);
    const bool slips = friction >= (1.0 - tolerance::friction_limit) * block.friction * all[2];
    for (std::size_t i = 0; i < at(block.count); ++i) {
      const ContactPatchPoint& p = block.points[i];
      const double share = all[2] > 0.0 ? p.impulse / all[2] : 0.0;
      ContactRecord record;
      record.time = contact_time_;
      record.first = block.first_id;
      record.second = block.second_id;
      record.point_w = position_of(block, start_[at(block.first)], p);
      record.normal_w = block.frame_w.col(2);
      record.push_w = block.frame_w * Vec3(share * all[0], share * all[1], p.impulse);
      record.state = !(p.impulse > 0.0) ? ContactState::open
                     : slips            ? ContactState::slip
                                        : ContactState::stick;
      records_.push_back(record);
    }
  }
  recorded_ = true;
  return records_;
}

}  // namespace tumble
