/// \file
/// \brief The technique of Stewart and Trinkle, and of Anitescu and Potra.
#include "tumble/analytic_lcp/time_stepping.hpp"

#include "tumble/analytic_lcp/tolerances.hpp"
#include "tumble/analytic_lcp/unsolved.hpp"
#include "tumble/base/error.hpp"
#include "tumble/base/index.hpp"
#include "tumble/contact/contact_records.hpp"
#include "tumble/contact/flush_edges.hpp"
#include "tumble/contact/gather.hpp"
#include "tumble/contact/impulse_work.hpp"
#include "tumble/contact/parts_of_turn.hpp"
#include "tumble/contact/tolerances.hpp"

#include <algorithm>
#include <optional>
#include <string>

namespace tumble {

TimeStepping::TimeStepping(const TimeSteppingOptions& options) : options_(options) {
  const int directions = options.velocities.directions;
  require::that(directions == 4 || directions == 8,
                "directions = " + std::to_string(directions) + ": expected 4 or 8");
}

std::vector<Diagnostic> TimeStepping::diagnostics() const {
  return diagnostics_of(unsolved_problem());
}

StepReport TimeStepping::step(World& world, double dt) {
  return step_in_parts(world, dt, [&](World& w, double part, int) { return step_part(w, part); });
}

StepReport TimeStepping::step_part(World& world, double dt) {
  StepReport report;
  records_.clear();
  load_moving_bodies(world, moving_);
  gather(world, dt, report);

  // [S2.6.3]
  // The velocities at the end of the step: what gravity and all contacts, old and new, leave.
  // An angular momentum changes by impulses only, so that free bodies tumble as they should.
  free_.assign(moving_.size(), Acceleration{});
  for (std::size_t k = 0; k < free_.size(); ++k)
    if (world.bodies()[k].movable()) free_[k].linear_w = world.gravity_w;
  before_ = moving_;
  velocities_ = velocity_step_.solve(world, free_, contacts_, dt, options_.velocities, moving_);
  report.pivots = velocities_.pivots;
  if (!velocities_.solved) {
    report.status = StepStatus::unsolved;
    world.finish_step(0.0);  // no time has passed
    return report;
  }

  // Then all bodies move with these.
  start_.assign(world.states().begin(), world.states().end());
  move(world, dt, report);
  for (int k = 0; k < tolerance::most_missed && solve_missed(world, dt, report); ++k) continue;
  // [S2.6.3]

  record(world);
  find_pairs(world, 0.0);
  book(repair_.run(world, pairs_), report);
  report.energy.restitution += velocities_.restitution_energy;
  report.energy.friction = velocities_.friction_energy;
  report.impulses = velocities_.impulses;
  report.fallbacks = velocities_.fallbacks;
  report.contacts = static_cast<std::int64_t>(records_.size());
  return report;
}

// Bodies that nothing is near. The others move as the problem has assumed, whether they are pushed or not.
void TimeStepping::find_flying(const World& world) {
  flying_.assign(world.bodies().size(), 1);
  for (const Contact& contact : contacts_)
    flying_[idx(contact.first)] = flying_[idx(contact.second)] = 0;
}

// [J] Bodies near others move with the velocity of the step's end instead of the mean of both: what this lifts them by.
double TimeStepping::moved_against_gravity(const World& world, double dt) const {
  double work = 0.0;
  for (std::size_t k = 0; k < moving_.size(); ++k) {
    const BodyProperties& body = world.bodies()[k];
    if (!body.movable() || flying_[k] != 0) continue;
    work += lift_at_end_velocity(world.gravity_w, dt, world.states()[k].linear_momentum_w,
                                 body.mass * moving_[k].velocity_w);
  }
  return work;
}

// Where bodies end up in each other although none of their points was to: back to the start, and again with the points of
// the overlap. Returns whether it was done. If the new problem has no answer, or sweeps one that adds more energy, the step
// stays as it is.
bool TimeStepping::solve_missed(World& world, double dt, StepReport& report) {
  if (options_.velocities.form != SteppingForm::stewart_trinkle) return false;
  if (!passing_.find_missed(world, start_, before_, moving_, dt, contacts_, more_, report))
    return false;
  again_ = before_;
  ended_.assign(world.states().begin(), world.states().end());
  std::copy(start_.begin(), start_.end(), world.states().begin());
  const VelocityStepResult result =
      velocity_step_.solve(world, free_, more_, dt, options_.velocities, again_);
  report.pivots += result.pivots;
  const auto gain = [](const VelocityStepResult& of) {
    return of.restitution_energy + of.friction_energy;
  };
  // Contacts that carry what would fall gain as much as that without being wrong, see VelocityStep.
  double falls = 0.0;  // [J]
  for (const BodyProperties& body : world.bodies())
    if (body.movable()) falls += 0.5 * body.mass * world.gravity_w.squaredNorm() * dt * dt;
  if (!result.solved || gain(result) > std::max(gain(velocities_), 0.0) + falls) {
    std::copy(ended_.begin(), ended_.end(), world.states().begin());
    return false;
  }
  velocities_ = result;
  moving_.swap(again_);
  contacts_.swap(more_);
  move(world, dt, report);
  return true;
}

// Each by itself, on its parabola if nothing is near, or about what it stands on.
void TimeStepping::move(World& world, double dt, StepReport& report) {
  find_flying(world);
  report.energy.repair = 0.0;
  report.energy.restitution = moved_against_gravity(world, dt);
  store_moving_bodies(moving_, world);
  pushed_.clear();
  if (options_.pose == PoseUpdate::exponential)
    for (const Contact& contact : contacts_)
      if (const std::optional<PushedPair> pair = pushed_pair(contact)) pushed_.push_back(*pair);
  carried_.find(world.bodies(), moving_, pushed_);
  for (int b = 0; b < world.count(); ++b) {
    if (!world.bodies()[idx(b)].movable()) continue;
    if (carried_.carries(b)) {
      report.energy.repair += carried_.move(b, dt, world);
    } else {
      BodyState& state = world.states()[idx(b)];
      advance_pose(world.bodies()[idx(b)], state, dt, options_.rotation);
      if (flying_[idx(b)] != 0) state.position_w -= 0.5 * dt * dt * world.gravity_w;  // a parabola
    }
    ++report.integrations;
  }
}

// Contacts of all bodies that can meet in this step: up to as far apart as the two fastest come.
void TimeStepping::gather(const World& world, double dt, StepReport& report) {
  double fastest = 0.0;
  double second = 0.0;
  double largest = 0.0;
  for (std::size_t k = 0; k < moving_.size(); ++k) {
    const BodyProperties& body = world.bodies()[k];
    if (!body.movable()) continue;
    const double speed = moving_[k].velocity_w.norm() + dt * world.gravity_w.norm() +
                         0.5 * body.size.norm() * moving_[k].angular_velocity_w.norm();
    second = std::max(second, std::min(fastest, speed));
    fastest = std::max(fastest, speed);
    largest = std::max(largest, body.size.minCoeff());
  }
  const double margin = tolerance::repair_slop * largest + dt * (fastest + second);
  find_pairs(world, margin);
  const GatherReport gathered = gather_contacts(world, moving_, pairs_, margin, {}, contacts_);
  report.pair_tests += gathered.pair_tests;
  report.deepest_overlap = gathered.deepest_overlap;
  if (options_.velocities.form == SteppingForm::stewart_trinkle)
    passing_.add(world, moving_, pairs_, dt, options_.rotation, contacts_, report);
  drop_flush_edges(world, contacts_);
}

// Pairs of bodies up to a margin apart.
void TimeStepping::find_pairs(const World& world, double margin) {
  repair_bounds(world, margin, bounds_);
  broad_phase_.find_pairs(bounds_, pairs_);
}

// What touches or pushes, at the poses of the step's start. Points that are merely near say nothing.
void TimeStepping::record(const World& world) {
  for (const Contact& contact : contacts_) {
    for (int p = 0; p < contact.count; ++p) {
      const ContactPoint& point = contact.points[idx(p)];
      if (point.distance > 0.0 && !(point.normal_impulse > 0.0)) continue;
      records_.push_back(record_of(contact, p, world.time()));
    }
  }
}

}  // namespace tumble
