/// \file
/// \brief Damped integration: the listing DAMPEDINTEGRATION.
#include "tumble/impulse_damped/damped.hpp"

#include "tumble/base/error.hpp"
#include "tumble/contact/contact_records.hpp"
#include "tumble/contact/impulse_work.hpp"
#include "tumble/contact/parts_of_turn.hpp"
#include "tumble/contact/tolerances.hpp"

#include <algorithm>

namespace tumble {

Damped::Damped(const DampedOptions& options)
    : options_(options),
      gatherer_(options.normals, options.points),
      areas_(NormalRule::separation, PointRule::area),
      margins_(NormalRule::separation, PointRule::area) {
  require::not_negative(options.collision_passes, "collision_passes");
  require::not_negative(options.contact_passes, "contact_passes");
  require::not_negative(options.noise.speed, "noise.speed");
  require::not_negative(options.noise.normal, "noise.normal");
  require::not_negative(options.noise.restitution, "noise.restitution");
  check(options.numbers);
}

std::vector<std::string> Damped::ignores(const World& world) const {
  const auto rubs = [](const BodyProperties& body) { return body.friction > 0.0; };
  if (std::none_of(world.bodies().begin(), world.bodies().end(), rubs)) return {};
  return {"friction"};
}

StepReport Damped::step(World& world, double dt) {
  return step_in_parts(world, dt,
                       [&](World& w, double part, int k) { return step_part(w, part, k); });
}

StepReport Damped::step_part(World& world, double dt, int part) {
  StepReport report;
  begin(world, dt, report);
  DampedStage stage{world,   dt,        options_.rotation, options_.sleeping ? &sleeping_ : nullptr,
                    bodies_, gatherer_, collide_,          collisions_,
                    pushed_, report};
  Random random = Random(options_.seed).fork(static_cast<std::uint64_t>(world.steps() - part));
  if (part > 0) random = random.fork(static_cast<std::uint64_t>(part));

  // [DAMPEDINTEGRATION:1-2]
  // Impulses: what is about to meet collides, and what gravity
  // presses together is stopped.
  resolve_collisions(stage, options_.collision_passes, options_.noise, random);
  report_collisions(world, dt, report);
  collided_ = bodies_.moving;
  resolve_contacts(stage, options_.contact_passes);
  // [DAMPEDINTEGRATION:1-2]
  if (options_.shock == ShockRule::velocity) shock_.run(stage, options_.contact_passes);
  store_moving_bodies(bodies_.moving, world);

  // [DAMPEDINTEGRATION:3-4]
  // Gravity, then damping, within which all bodies move.
  integrate_object_velocities(world, dt);
  started_w_.clear();
  for (const BodyState& state : world.states()) started_w_.push_back(state.linear_momentum_w);
  const DampingReport damped = damping_.run(world, bodies_.touched, options_.numbers,
                                            options_.damping, dt, options_.rotation);
  // [DAMPEDINTEGRATION:3-4]
  report.energy.damping += damped.energy;
  report.integrations += damped.moved;
  report.energy.restitution += moved_against_gravity(world, dt);

  // [DAMPEDINTEGRATION:5]
  // What overlaps where the bodies are now is pushed apart.
  const SleepingRule* sleeping = options_.sleeping ? &sleeping_ : nullptr;
  const PairReport overlaps =
      areas_.gather(world, world.states(), world.states(), sleeping, 0.0, collisions_);
  report.pair_tests += overlaps.pair_tests;
  report.deepest_overlap = std::max(report.deepest_overlap, overlaps.deepest_overlap);
  if (options_.shock == ShockRule::position) {
    const FixReport fixed = fix_.run(world, collisions_, options_.numbers, dt);
    report.pair_tests += fixed.pair_tests;
    report.energy.repair += fixed.energy;
  }
  // [DAMPEDINTEGRATION:5]
  end(world, dt, report);
  // [DAMPEDINTEGRATION:7]
  return report;
  // [DAMPEDINTEGRATION:7]
}

// Impulses of contacts are booked at velocities of half a step of gravity earlier, and bodies move with those that damping
// has left: what this lifts those that were pushed or damped by. What merely flies has the error of the rule.
double Damped::moved_against_gravity(const World& world, double dt) const {
  double work = 0.0;
  for (std::size_t k = 0; k < started_w_.size(); ++k) {
    const BodyProperties& body = world.bodies()[k];
    if (!body.movable() || world.sleep_states()[k].asleep) continue;
    if (bodies_.touched[k] == 0 && stable_[k] == 0) continue;
    for (const Vec3& before_w : {Vec3(body.mass * collided_[k].velocity_w), started_w_[k]})
      work +=
          lift_at_end_velocity(world.gravity_w, dt, before_w, world.states()[k].linear_momentum_w);
  }
  return work;
}

// Wakes bodies that are touched, and reads velocities and marks.
void Damped::begin(World& world, double dt, StepReport& report) {
  pushed_.clear();
  if (options_.sleeping) {
    sleeping_.wake_disturbed(world);
  } else {  // bodies that another technique has put to sleep
    for (SleepState& rest : world.sleep_states()) rest.asleep = false;
  }
  stable_.assign(world.bodies().size(), 0);
  for (std::size_t k = 0; k < stable_.size(); ++k)
    stable_[k] = !world.bodies()[k].movable() || keeps_mark(world, k) ? 1 : 0;
  for (bool woken = options_.sleeping; woken;) {
    bodies_.load(world, stable_);
    report.integrations += bodies_.predict(world, dt, options_.rotation);
    const PairReport found =
        gatherer_.gather(world, world.states(), bodies_.predicted, &sleeping_, 0.0, collisions_);
    report.pair_tests += found.pair_tests;
    woken = sleeping_.wake_touched(world, collisions_) > 0;
  }
  bodies_.load(world, stable_);
}

// Whether a body was marked, and nothing has been done to it since.
bool Damped::keeps_mark(const World& world, std::size_t body) const {
  const auto found = std::lower_bound(stable_ids_.begin(), stable_ids_.end(), world.ids()[body]);
  if (found == stable_ids_.end() || *found != world.ids()[body]) return false;
  const BodyState& now = world.states()[body];
  const BodyState& left = stable_left_[static_cast<std::size_t>(found - stable_ids_.begin())];
  return world.gravity_w == stable_under_w_ && now.position_w == left.position_w &&
         now.orientation_wb.coeffs() == left.orientation_wb.coeffs() &&
         now.linear_momentum_w == left.linear_momentum_w &&
         now.angular_momentum_w == left.angular_momentum_w;
}

// Line 3: gravity for all bodies that can fall. Stable ones have been stopped with it in mind.
void Damped::integrate_object_velocities(World& world, double dt) const {
  for (std::size_t k = 0; k < world.bodies().size(); ++k) {
    if (!world.bodies()[k].movable() || world.sleep_states()[k].asleep) continue;
    world.states()[k].linear_momentum_w += dt * world.bodies()[k].mass * world.gravity_w;
  }
}

// Marks of bodies that stand firm, sleep, and the records of the step.
void Damped::end(World& world, double dt, StepReport& report) {
  double margin = 0.0;  // [m] of the largest body
  for (const BodyProperties& body : world.bodies())
    if (body.movable())
      margin = std::max(margin, tolerance::stability_margin * body.size.minCoeff());
  const SleepingRule* sleeping = options_.sleeping ? &sleeping_ : nullptr;
  const PairReport near =
      margins_.gather(world, world.states(), world.states(), sleeping, margin, collisions_);
  report.pair_tests += near.pair_tests;
  // [DAMPEDINTEGRATION:6]
  stability_.run(world, collisions_, options_.stable_boxes, options_.numbers.eps9, stable_);
  // [DAMPEDINTEGRATION:6]
  if (options_.sleeping) {
    islands_.build(world.bodies(), collisions_);
    report.energy.damping +=
        sleeping_.update(world, collisions_, islands_, dt, slow_bodies()).energy;
  }
  stable_ids_.clear();
  stable_left_.clear();
  for (std::size_t k = 0; k < stable_.size(); ++k) {
    if (stable_[k] == 0 || !world.bodies()[k].movable()) continue;
    stable_ids_.push_back(world.ids()[k]);
    stable_left_.push_back(world.states()[k]);
  }
  stable_under_w_ = world.gravity_w;
  record(world, dt, report);
}

// Collisions of the first stage, for observers.
void Damped::report_collisions(const World& world, double dt, StepReport& report) {
  Event moment{.time = world.time() + dt};
  report.events += static_cast<std::int64_t>(pushed_.count());
  for (std::size_t k = 0; k < pushed_.count(); ++k)
    report_collision(pushed_[k], moment, observer());
}

// The points of this step with their impulses, at the predicted poses where they were found.
void Damped::record(const World& world, double dt, StepReport& report) {
  records_.clear();
  for (std::size_t k = 0; k < pushed_.count(); ++k)
    add_records({&pushed_[k], 1}, world.time() + dt, records_);
  report.contacts = static_cast<std::int64_t>(records_.size());
}

}  // namespace tumble
