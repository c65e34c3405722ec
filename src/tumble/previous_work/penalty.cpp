/// \file
/// \brief Springs and dampers where bodies overlap.
#include "tumble/previous_work/penalty.hpp"

#include "tumble/base/error.hpp"
#include "tumble/base/index.hpp"
#include "tumble/base/number_text.hpp"
#include "tumble/contact/contact_records.hpp"
#include "tumble/contact/effective_mass.hpp"
#include "tumble/contact/impulse_work.hpp"
#include "tumble/contact/movable_edge.hpp"
#include "tumble/contact/parts_of_turn.hpp"
#include "tumble/dynamics/step_mistakes.hpp"
#include "tumble/previous_work/tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace tumble {
namespace {

constexpr double kCorners = 4.0;  // that share the stiffness

// Masses of the bodies at a contact: of the lighter and of both together.
struct PenaltyPair {
  double lighter = std::numeric_limits<double>::infinity();  // [kg]
  double reduced = 0.0;                                      // [kg] 1/(1/m + 1/m')
};

PenaltyPair penalty_pair(const World& world, const Contact& contact) {
  PenaltyPair pair;
  double inverse = 0.0;
  for (const int k : {contact.first, contact.second}) {
    const BodyProperties& body = world.bodies()[idx(k)];
    if (!body.movable()) continue;
    pair.lighter = std::min(pair.lighter, body.mass);
    inverse += body.inverse_mass;
  }
  pair.reduced = 1.0 / inverse;
  return pair;
}

}  // namespace

Penalty::Penalty(const PenaltyOptions& options) : options_(options) {
  require::not_negative(options.stiffness, "stiffness");
  require::within(options.damping, -1.0, 1e3, "damping");
  require::that(options.substeps >= 1,
                "substeps = " + std::to_string(options.substeps) + ": expected 1 or more");
}

std::vector<std::string> Penalty::ignores(const World& world) const {
  std::vector<double> all;
  for (const BodyProperties& body : world.bodies()) all.push_back(body.restitution);
  std::sort(all.begin(), all.end());
  // Each but the smallest is the larger one of some pair.
  for (std::size_t k = 1; k < all.size(); ++k) {
    const double kept = penalty_restitution(damping_of(all[k]), options_.pull);
    if (std::abs(kept - all[k]) <= tolerance::penalty_bounce) continue;
    return {"a restitution of " + shortest_text(all[k]) + ": contacts keep " +
            rounded_text(kept, 2) + " of the approach"};
  }
  return {};
}

StepReport Penalty::step(World& world, double dt) {
  require::positive(dt, "dt");
  if (!options_.unstable) require_stable(world, dt / options_.substeps);
  return step_in_parts(world, dt, [&](World& w, double part, int) {
    StepReport report;
    const double h = part / options_.substeps;
    for (int k = 0; k < options_.substeps; ++k) substep(w, h, report);
    for (ContactRecord& record : records_)
      record.time = w.time() + part - h;  // of the last substep
    return report;
  });
}

// [-] of a contact with this restitution
double Penalty::damping_of(double restitution) const {
  if (options_.damping >= 0.0) return options_.damping;
  return penalty_damping_for(restitution, options_.pull);
}

// One box on four corners must not gain energy, whatever it meets.
void Penalty::require_stable(const World& world, double h) const {
  const bool explicit_euler = options_.scheme == PenaltyScheme::explicit_euler;
  if (options_.stiffness == 0.0 && !explicit_euler) return;
  double restitution = 0.0;
  for (const BodyProperties& body : world.bodies())
    restitution = std::max(restitution, body.restitution);
  const double zeta = damping_of(restitution);
  if (explicit_euler && !(zeta > 0.0))
    refuse_step("scheme = explicit: nothing damps a bounce with a restitution of " +
                shortest_text(restitution) +
                ", so that it gains energy at any step: expected damping above 0, or scheme = "
                "semi_implicit");
  if (options_.stiffness == 0.0) return;
  for (std::size_t k = 0; k < world.bodies().size(); ++k) {
    const BodyProperties& body = world.bodies()[k];
    if (!body.movable()) continue;
    const double limit =
        stable_step(options_.scheme, {std::sqrt(options_.stiffness / body.mass), zeta});
    if (h < limit) continue;
    const double substeps = std::floor(h * options_.substeps / limit) + 1.0;
    refuse_step("stiffness = " + shortest_text(options_.stiffness) + " N/m under " +
                world.name(static_cast<int>(k)) + " of " + shortest_text(body.mass) +
                " kg: substeps of " + rounded_text(h, 4) + " s gain energy: expected below " +
                rounded_text(limit, 4) + " s, as with substeps = " + shortest_text(substeps) +
                " or more");
  }
}

void Penalty::substep(World& world, double h, StepReport& report) {
  load_moving_bodies(world, start_);
  moving_ = start_;
  for (std::size_t k = 0; k < start_.size(); ++k)
    if (world.bodies()[k].movable()) moving_[k].velocity_w += h * world.gravity_w;
  // [S2.5.1:step]
  // Forces are those where the substep begins.
  find_contacts(world, report);
  split_bodies();
  push(world, h);
  record(h, report);

  // Semi-implicit: bodies move with the new velocities. Explicit: with those of before.
  old_.assign(world.states().begin(), world.states().end());
  store_moving_bodies(moving_, world);
  for (std::size_t k = 0; k < start_.size(); ++k) {
    if (!world.bodies()[k].movable()) continue;
    BodyState& state = world.states()[k];
    if (!moving_[k].changed)
      state.linear_momentum_w += world.bodies()[k].mass * h * world.gravity_w;
    const bool with_new = options_.scheme == PenaltyScheme::semi_implicit;
    const double lift = lift_at_end_velocity(world.gravity_w, h, old_[k].linear_momentum_w,
                                             state.linear_momentum_w);
    if (moving_[k].changed) report.energy.restitution += with_new ? lift : -lift;
    BodyState moved = with_new ? state : old_[k];
    advance_pose(world.bodies()[k], moved, h, options_.rotation);
    state.position_w = moved.position_w;
    state.orientation_wb = moved.orientation_wb;
    ++report.integrations;
  }
  // [S2.5.1:step]
}

void Penalty::find_contacts(const World& world, StepReport& report) {
  bounds_.clear();
  for (std::size_t k = 0; k < start_.size(); ++k)
    bounds_.push_back(bounds_of(world.bodies()[k], world.states()[k]));
  near_.find_pairs(bounds_, pairs_);
  const GatherReport found = gather_contacts(world, start_, pairs_, 0.0, {}, contacts_);
  report.pair_tests += found.pair_tests;
  report.deepest_overlap = std::max(report.deepest_overlap, found.deepest_overlap);
}

// Each body is divided among its contacts: with five it is a fifth of itself in each.
void Penalty::split_bodies() {
  split_ = start_;
  for (MovingBody& body : split_) {
    body.inverse_mass.setZero();
    body.inverse_inertia_w.setZero();
  }
  for (const Contact& contact : contacts_) {
    for (const int k : {contact.first, contact.second}) {
      split_[idx(k)].inverse_mass += start_[idx(k)].inverse_mass;
      split_[idx(k)].inverse_inertia_w += start_[idx(k)].inverse_inertia_w;
    }
  }
}

// [S2.5.1:spring]
// Spring and damper of a point.
Penalty::Spring Penalty::spring_at(const World& world, const Contact& contact, int point,
                                   double zeta, double h) const {
  const PenaltyPair pair = penalty_pair(world, contact);
  Spring spring;
  if (options_.stiffness > 0.0) {
    spring.stiffness = options_.stiffness / kCorners;
    spring.damping = 2.0 * zeta * std::sqrt(spring.stiffness * pair.reduced / kCorners);
    return spring;
  }
  // As stiff as the sag asks for, and not stiffer than the step can follow.
  const double mass = effective_mass(split_[idx(contact.first)], split_[idx(contact.second)],
                                     contact.points[idx(point)].position_w, contact.normal_w) /
                      contact.count;
  double stiffest = tolerance::penalty_stiffness;
  if (options_.scheme == PenaltyScheme::explicit_euler)  // h ω < 2 ζ
    stiffest = std::min(stiffest, tolerance::penalty_explicit * zeta * zeta);
  spring.stiffness = stiffest * mass / (h * h);
  const double weight = pair.lighter * world.gravity_w.norm();
  const double edge =
      movable_edge(world.bodies()[idx(contact.first)], world.bodies()[idx(contact.second)]);
  if (weight > 0.0)
    spring.stiffness =
        std::min(spring.stiffness, weight / (tolerance::penalty_sag * edge) / kCorners);
  spring.damping = std::min(2.0 * zeta * std::sqrt(spring.stiffness * pair.reduced / kCorners),
                            tolerance::penalty_damping * mass / h);
  return spring;
}
// [S2.5.1:spring]

// [S2.5.1:push]
// Each point by itself: the spring and the damper push, friction acts against the slip.
void Penalty::push(const World& world, double h) {
  for (Contact& c : contacts_) {
    const MovingBody& a = start_[idx(c.first)];
    const MovingBody& b = start_[idx(c.second)];
    const double zeta = damping_of(c.restitution);
    for (int k = 0; k < c.count; ++k) {
      ContactPoint& p = c.points[idx(k)];
      const Spring spring = spring_at(world, c, k, zeta, h);
      const Vec3 velocity_w = relative_velocity(a, b, p.position_w);
      const double speed = c.normal_w.dot(velocity_w);
      const double depth = std::max(0.0, -p.distance);
      p.normal_impulse = h * (spring.stiffness * depth - spring.damping * speed);
      if (!options_.pull) p.normal_impulse = std::max(0.0, p.normal_impulse);

      const Vec3 slip_w = velocity_w - speed * c.normal_w;
      const double slip = slip_w.norm();
      p.friction_impulse_w.setZero();
      if (slip > 0.0 && p.normal_impulse > 0.0) {
        const double mass = effective_mass(split_[idx(c.first)], split_[idx(c.second)],
                                           p.position_w, slip_w / slip) /
                            c.count;
        const double impulse =
            std::min(c.friction * p.normal_impulse, tolerance::penalty_friction * mass * slip);
        p.friction_impulse_w = -impulse / slip * slip_w;
      }
      apply_impulse(moving_[idx(c.first)], moving_[idx(c.second)], p.position_w,
                    p.normal_impulse * c.normal_w + p.friction_impulse_w);
    }
  }
}
// [S2.5.1:push]

// Work is an impulse times the mean of the velocities before and after; users get forces. What a spring takes up is
// booked as taken away, and as added when it gives it back.
void Penalty::record(double h, StepReport& report) {
  book_impulses(contacts_, start_, moving_, report.energy);
  records_.clear();
  for (const Contact& c : contacts_) {
    for (int k = 0; k < c.count; ++k) {
      const ContactPoint& p = c.points[idx(k)];
      report.impulses += p.normal_impulse != 0.0 ? 1 : 0;
      records_.push_back(record_of(c, k, 0.0));
      records_.back().push_w /= h;
      records_.back().is_impulse = false;
    }
  }
  report.contacts = static_cast<std::int64_t>(records_.size());
}

}  // namespace tumble
