/// \file
/// \brief Animation by optimisation.
#include "tumble/previous_work/optimised.hpp"

#include "tumble/base/error.hpp"
#include "tumble/base/index.hpp"
#include "tumble/contact/contact_records.hpp"
#include "tumble/contact/effective_mass.hpp"
#include "tumble/contact/impulse_work.hpp"
#include "tumble/contact/movable_edge.hpp"
#include "tumble/contact/parts_of_turn.hpp"
#include "tumble/dynamics/energy.hpp"
#include "tumble/dynamics/integrate.hpp"
#include "tumble/math/rotation.hpp"
#include "tumble/previous_work/tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace tumble {
namespace {

constexpr int kShareOfLast =
    10;  // one round in ten is kept for bodies that overlap where they stop

}  // namespace

Optimised::Optimised(const OptimisedOptions& options) : options_(options) {
  require::positive(options.reach, "reach");
  require::that(options.rounds >= 1,
                "rounds = " + std::to_string(options.rounds) + ": expected 1 or more");
  require::that(options.budget >= 1,
                "budget = " + std::to_string(options.budget) + ": expected 1 or more");
}

StepReport Optimised::step(World& world, double dt) {
  require::positive(dt, "dt");
  StepReport report;
  load_moving_bodies(world, before_);
  // [S2.7.2:step]
  // Where would all bodies fly?
  targets_.assign(world.states().begin(), world.states().end());
  for (std::size_t k = 0; k < targets_.size(); ++k)
    fly_in_micro_steps(world.bodies()[k], targets_[k], world.gravity_w, dt, options_.rotation,
                       micro_step_of(world.bodies()[k], targets_[k], options_.rotation, dt));
  // As near to there as they can get, and then as fast as they may be.
  find_poses(world, dt, report);
  find_momenta(world, dt, report);
  // [S2.7.2:step]
  last_dt_ = dt;
  world.finish_step(dt);
  return report;
}

// --- poses ----------------------------------------------------------------------------------------

void Optimised::find_poses(World& world, double dt, StepReport& report) {
  const double edge = movable_edge(world);
  pushed_.assign(world.bodies().size(), 0);
  near_.scale_impulses(last_dt_ > 0.0 ? (dt * dt) / (last_dt_ * last_dt_) : 0.0);
  // [S2.7.2:poses]
  // Round by round, until nothing moves any more. Once all have come as far as they can, half spaces are nearly right, and each
  // round may move half as far as the one before.
  // Where the rounds end before the way does, bodies stop, and the last rounds end overlap only.
  double reach = options_.reach * edge, moved = 0.0;
  bool there = false;
  const int last = options_.rounds - options_.rounds / kShareOfLast;
  for (int round = 0; round < options_.rounds; ++round) {
    if (round == last && !there) report.status = StepStatus::event_cap;
    moved = go_on(world, report.status == StepStatus::done, reach, report);
    if (moved <= tolerance::optimised_still * edge) break;
    there = there || moved < reach;
    if (there) reach *= 0.5;
  }
  // [S2.7.2:poses]
  if (moved > tolerance::optimised_still * edge) report.status = StepStatus::event_cap;
  for (std::size_t k = 0; k < targets_.size(); ++k) {
    if (!world.bodies()[k].movable() || report.status != StepStatus::done) continue;
    if (pushed_[k] == 0) {  // it flies, to the last bit
      world.states()[k].position_w = targets_[k].position_w;
      world.states()[k].orientation_wb = targets_[k].orientation_wb;
    }
    ++report.integrations;
  }
}

// One round, to the targets or only out of overlap. Returns how far a corner moved at most [m].
double Optimised::go_on(World& world, bool fly_on, double& reach, StepReport& report) {
  // [S2.7.2:round]
  // From here to the targets, unless something is in the way; but not farther than the reach.
  load_moving_bodies(world, moving_);
  for (std::size_t k = 0; k < moving_.size(); ++k) {
    moving_[k].velocity_w.setZero();
    moving_[k].angular_velocity_w.setZero();
    if (!world.bodies()[k].movable() || !fly_on) continue;
    const BodyState& state = world.states()[k];
    moving_[k].velocity_w = targets_[k].position_w - state.position_w;
    moving_[k].angular_velocity_w =
        rotation_vector(targets_[k].orientation_wb * state.orientation_wb.conjugate());
  }
  if (fly_on) reach = std::min(reach, farthest_move(world, moving_));
  near_.find(world, moving_, 2.0 * reach, report);
  least_.clear();
  for (const double gap : near_.gaps()) least_.push_back(-gap);
  rows_.take(moving_, near_.contacts(), least_);
  work_.poses += solve(report);
  rows_.push(near_.contacts(), moving_);
  const double farthest = farthest_move(world, moving_);
  const double share = farthest > reach ? reach / farthest : 1.0;
  move_bodies(moving_, share, world);
  // [S2.7.2:round]
  for (std::size_t k = 0; k < moving_.size(); ++k)
    if (moving_[k].changed) pushed_[k] = 1;
  return share < 1.0 ? reach : farthest;
}

// Returns multiplications.
std::int64_t Optimised::solve(StepReport& report) {
  rows_.require_no_energy();
  const DescentReport found = descent_.solve(
      rows_, rows_.impulses(), tolerance::optimised_step * rows_.first_step(), options_.budget);
  report.iterations += found.iterations;
  return static_cast<std::int64_t>(found.products) *
         static_cast<std::int64_t>(rows_.size() * rows_.size());
}

// --- momenta --------------------------------------------------------------------------------------

void Optimised::find_momenta(World& world, double dt, StepReport& report) {
  load_moving_bodies(world, free_);
  end_spin_up(world);
  // What is missing to the target is energy that moving bodies there adds; and so is what the same angular momentum has at
  // another orientation.
  double lifted = 0.0, turned = 0.0;
  for (std::size_t k = 0; k < targets_.size(); ++k) {
    if (!world.bodies()[k].movable() || pushed_[k] == 0) continue;
    const BodyState& state = world.states()[k];
    lifted +=
        world.bodies()[k].mass * world.gravity_w.dot(targets_[k].position_w - state.position_w);
    turned += 0.5 * state.angular_momentum_w.dot(free_[k].angular_velocity_w -
                                                 before_[k].angular_velocity_w);
  }

  // [S2.7.2:momenta]
  // The momenta of free flight, and impulses at the points that touch.
  touching_.scale_impulses(last_dt_ > 0.0 ? dt / last_dt_ : 0.0);
  for (std::size_t k = 0; k < before_.size(); ++k) before_[k].position_w = free_[k].position_w;
  touching_.find(world, before_, tolerance::optimised_touch * movable_edge(world), report);
  for (std::size_t k = 0; k < free_.size(); ++k)
    if (world.bodies()[k].movable()) free_[k].velocity_w += dt * world.gravity_w;
  const bool bounces = push(world, dt, true, report);
  const double exact = tolerance::faure_gain * pushed_energy(touching_.contacts());
  if (bounces && report.energy.total() + lifted > exact) {  // nothing bounces in this step
    push(world, dt, false, report);
    ++report.fallbacks;
  }
  if (report.energy.total() > 0.0) weaken(world, report);
  // [S2.7.2:momenta]
  report.energy.repair = lifted;
  take_gain(report.energy.total(), report);
  report.energy.repair += turned;
  store_moving_bodies(moving_, world);
  for (std::size_t k = 0; k < moving_.size(); ++k)
    if (world.bodies()[k].movable() && !moving_[k].changed)
      world.states()[k].linear_momentum_w = targets_[k].linear_momentum_w;
}

// A long body that is turned aside far would spin about its short axis with an angular momentum across it, with many times its energy.
// No impulse shows where that momentum goes, so it is the energy that it keeps. So does a rod that flies and spins about its length too
// fast for its turns to be followed.
void Optimised::end_spin_up(World& world) {
  for (std::size_t k = 0; k < targets_.size(); ++k) {
    if (!world.bodies()[k].movable()) continue;
    Vec3& momentum_w = world.states()[k].angular_momentum_w;
    const double before = momentum_w.dot(before_[k].angular_velocity_w);  // [J] twice the energy
    const double now = momentum_w.dot(free_[k].angular_velocity_w);
    const double most =
        pushed_[k] != 0 ? tolerance::optimised_spin_up : tolerance::optimised_flight;
    if (!(now > (1.0 + most) * before)) continue;
    const double share = std::sqrt(before / now);
    momentum_w *= share;
    free_[k].angular_velocity_w *= share;
  }
}

// Returns whether a point bounces.
bool Optimised::push(const World& world, double dt, bool bounce, StepReport& report) {
  bool bounces = false;
  least_.clear();
  for (const Contact& contact : std::as_const(touching_).contacts()) {
    const StickyScale scale{
        world.gravity_w.norm(),
        movable_edge(world.bodies()[idx(contact.first)], world.bodies()[idx(contact.second)]), dt};
    for (int k = 0; k < contact.count; ++k) {
      const ContactPoint& p = contact.points[idx(k)];
      const double e =
          bounce ? sticky_restitution(contact.restitution, p.approach_speed, scale, options_.sticky)
                 : 0.0;
      const bool back = e > 0.0 && p.approach_speed < 0.0;
      least_.push_back(back ? -e * p.approach_speed : -std::max(p.distance, 0.0) / dt);
      bounces = bounces || back;
    }
  }
  rows_.take(free_, touching_.contacts(), least_);
  work_.momenta += solve(report);
  if (rows_.lifts(tolerance::optimised_lift)) {  // pushes first, then friction that goes with them
    for (const bool rubs : {false, true}) {
      rows_.fix_limits(rubs);
      work_.momenta += solve(report);
    }
    rows_.end_limits();
    ++report.fallbacks;
  }
  give_pushes(world, report);
  return bounces;
}

void Optimised::give_pushes(const World& world, StepReport& report) {
  moving_ = free_;
  rows_.push(touching_.contacts(), moving_);
  report.energy = {};
  report.impulses = 0;
  records_.clear();
  for (const Contact& contact : std::as_const(touching_).contacts()) {
    for (int k = 0; k < contact.count; ++k) {
      if (!(contact.points[idx(k)].normal_impulse > 0.0)) continue;
      records_.push_back(record_of(contact, k, world.time()));
      ++report.impulses;
    }
  }
  report.contacts = static_cast<std::int64_t>(records_.size());
  book_impulses(touching_.contacts(), free_, moving_, report.energy);
}

// Pushes may add energy: those of an elastic bounce by rounding, and with friction those of an iteration that ends at its budget. A share s
// of them adds s p·u + s² p A p / 2, nothing at the share below. Taken from pushes and not from speeds it keeps the momentum.
void Optimised::weaken(const World& world, StepReport& report) {
  double curvature = 0.0;  // [J] p A p
  for (const Contact& contact : std::as_const(touching_).contacts()) {
    const MovingBody &a = moving_[idx(contact.first)], &b = moving_[idx(contact.second)];
    const MovingBody &a0 = free_[idx(contact.first)], &b0 = free_[idx(contact.second)];
    for (int k = 0; k < contact.count; ++k) {
      const ContactPoint& p = contact.points[idx(k)];
      if (!(p.normal_impulse > 0.0)) continue;
      const Vec3 push_w = p.normal_impulse * contact.normal_w + p.friction_impulse_w;
      curvature += push_w.dot(relative_velocity(a, b, p.position_w) -
                              relative_velocity(a0, b0, p.position_w));
    }
  }
  const double share = std::max(0.0, 1.0 - 2.0 * report.energy.total() / curvature);
  for (double& impulse : rows_.impulses()) impulse *= share;
  give_pushes(world, report);
}

// What is too much is taken from the speed of what touches.
void Optimised::take_gain(double gain, StepReport& report) {
  if (!(gain > 0.0)) return;
  double kinetic = 0.0;  // [J]
  for (const MovingBody& body : moving_) {
    if (!body.changed || !(body.inverse_mass.x() > 0.0)) continue;
    kinetic += 0.5 * body.velocity_w.squaredNorm() / body.inverse_mass.x() +
               0.5 * body.angular_velocity_w.dot(body.inverse_inertia_w.inverse() *
                                                 body.angular_velocity_w);
  }
  if (!(kinetic > 0.0)) return;
  // [S2.7.2:gain]
  const double left = std::max(0.0, 1.0 - gain / kinetic);
  for (MovingBody& body : moving_) {
    if (!body.changed) continue;
    body.velocity_w *= std::sqrt(left);
    body.angular_velocity_w *= std::sqrt(left);
  }
  report.energy.damping -= (1.0 - left) * kinetic;
  // [S2.7.2:gain]
}

}  // namespace tumble
