/// \file
/// \brief Faure's energy method as a technique.
#include "tumble/previous_work/faure.hpp"

#include "tumble/base/error.hpp"
#include "tumble/base/index.hpp"
#include "tumble/contact/contact_records.hpp"
#include "tumble/contact/impulse_work.hpp"
#include "tumble/contact/movable_edge.hpp"
#include "tumble/contact/parts_of_turn.hpp"
#include "tumble/previous_work/near_points.hpp"

#include <algorithm>
#include <string>
#include <utility>

namespace tumble {
namespace {

// [m/s] The normal motion of a point at the end of the step is at least this: it may close its gap, or it bounces.
double least_motion(const ContactPoint& point, double dt, double restitution) {
  const double gap = std::max(point.distance, 0.0);
  const double approach = -point.approach_speed;
  if (restitution > 0.0 && approach > 0.0 && gap <= dt * approach) return restitution * approach;
  return -gap / dt;
}

}  // namespace

Faure::Faure(const FaureOptions& options) : options_(options) {
  require::that(options.budget >= 0,
                "budget = " + std::to_string(options.budget) + ": expected 0 or more");
  require::not_negative(options.wanted, "wanted");
}

std::unique_ptr<Technique> Faure::clone() const {
  auto copy = std::make_unique<Faure>(options_);
  copy->contacts_ = contacts_;
  copy->records_ = records_;
  copy->descent_ = descent_;
  copy->last_dt_ = last_dt_;
  copy->observe(observer());
  return copy;
}

StepReport Faure::step(World& world, double dt) {
  return step_in_parts(world, dt, [&](World& w, double part, int) { return step_part(w, part); });
}

StepReport Faure::step_part(World& world, double dt) {
  StepReport report;
  load_moving_bodies(world, start_);
  find_contacts(world, dt, report);

  // [S2.6.4:technique]
  // Impulses of all contacts at once.
  const bool bounces = push(world, dt, true, report);
  if (bounces &&
      gains(report)) {  // by bounces that contradict one another: nothing bounces in this step
    push(world, dt, false, report);
    ++report.fallbacks;
  }

  // All bodies move with the velocities of the end.
  store_moving_bodies(moving_, world);
  for (std::size_t k = 0; k < moving_.size(); ++k) {
    const BodyProperties& body = world.bodies()[k];
    BodyState& state = world.states()[k];
    if (!body.movable()) continue;
    if (!moving_[k].changed) state.linear_momentum_w += body.mass * dt * world.gravity_w;
    if (moving_[k].changed)
      report.energy.restitution += lift_at_end_velocity(
          world.gravity_w, dt, body.mass * start_[k].velocity_w, state.linear_momentum_w);
    advance_pose(body, state, dt, options_.rotation);
    ++report.integrations;
  }
  // [S2.6.4:technique]

  repair_bounds(world, 0.0, bounds_);
  broad_phase_.find_pairs(bounds_, pairs_);
  book(repair_.run(world, pairs_), report);
  report.contacts = static_cast<std::int64_t>(records_.size());
  last_dt_ = dt;
  return report;
}

// Those that may close their gap within the step, with the impulses that they had.
void Faure::find_contacts(const World& world, double dt, StepReport& report) {
  const double margin = meeting_margin(world, start_, dt);
  std::swap(previous_, contacts_);
  repair_bounds(world, margin, bounds_);
  broad_phase_.find_pairs(bounds_, pairs_);
  const GatherReport found = gather_contacts(world, start_, pairs_, margin, previous_, contacts_);
  report.pair_tests += found.pair_tests;
  report.deepest_overlap = found.deepest_overlap;
  if (!options_.warm || !(last_dt_ > 0.0)) return;
  carry_over_impulses(previous_, contacts_);
  scale_impulses(dt / last_dt_, contacts_);
}

// Whether the impulses add energy.
bool Faure::gains(const StepReport& report) const {
  return report.energy.restitution + report.energy.friction >
         tolerance::faure_gain * pushed_energy(contacts_);
}

// Returns whether a point bounces.
bool Faure::find_least_motions(const World& world, double dt, bool bounce) {
  bool bounces = false;
  least_.clear();
  for (const Contact& contact : contacts_) {
    const StickyScale scale{
        world.gravity_w.norm(),
        movable_edge(world.bodies()[idx(contact.first)], world.bodies()[idx(contact.second)]), dt};
    for (int k = 0; k < contact.count; ++k) {
      const ContactPoint& p = contact.points[idx(k)];
      const double e =
          sticky_restitution(contact.restitution, p.approach_speed, scale, options_.sticky);
      least_.push_back(least_motion(p, dt, bounce ? e : 0.0));
      bounces = bounces || least_.back() > 0.0;
    }
  }
  return bounces;
}

// How all bodies move without contacts, and with the impulses that are found. Work is an impulse times the mean of the velocities before and after.
// Returns whether a point bounces.
bool Faure::push(const World& world, double dt, bool bounce, StepReport& report) {
  moving_ = start_;
  for (std::size_t k = 0; k < moving_.size(); ++k)
    if (world.bodies()[k].movable()) moving_[k].velocity_w += dt * world.gravity_w;
  const bool bounces = find_least_motions(world, dt, bounce);
  rows_.take(moving_, contacts_, least_);
  rows_.require_no_energy();
  descent_ = iteration_.solve(rows_, rows_.impulses(), options_.wanted * rows_.first_step(),
                              options_.budget);
  rows_.push(contacts_, moving_);
  report.iterations += descent_.iterations;
  report.impulses = 0;
  report.energy = {};
  records_.clear();
  for (const Contact& contact : contacts_) {
    for (int k = 0; k < contact.count; ++k) {
      if (!(contact.points[idx(k)].normal_impulse > 0.0)) continue;
      ++report.impulses;
      records_.push_back(record_of(contact, k, world.time()));
    }
  }
  book_impulses(contacts_, start_, moving_, report.energy);
  return bounces;
}

}  // namespace tumble
