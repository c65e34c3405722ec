/// \file
/// \brief The default technique: a step.
#include "tumble/contact_damped/contact_damped.hpp"

#include "tumble/base/error.hpp"
#include "tumble/base/index.hpp"
#include "tumble/contact/parts_of_turn.hpp"
#include "tumble/contact/tolerances.hpp"
#include "tumble/contact_damped/tolerances.hpp"
#include "tumble/dynamics/integrate.hpp"
#include "tumble/dynamics/step_report.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>

namespace tumble {
namespace {

// Into how many parts a step is divided: more than one, if allowed, where bodies that touch move far into each other, or
// edges far along each other. Then a contact found at its start does not stay where it is. On a face it does.
int parts_of_motion(std::span<const ContactPatch> patches, std::span<const MovingBody> free,
                    double dt, int allowed) {
  if (allowed == 1) return 1;
  double most = 0.0;  // [-] way of a point in the step, as a share of the shortest edge
  for (const ContactPatch& patch : patches) {
    Six u = motion_of(patch, free[idx(patch.first)], free[idx(patch.second)]);
    if (patch.axis < 6) u[0] = u[1] = u[5] = 0.0;  // a face, or the ground
    for (const ContactPatchPoint& p : patch.used()) {
      const Vec3 way = dt * velocity_at(p.along, p.across, u);
      if (-way.z() > p.gap) most = std::max(most, way.norm() / patch.size);
    }
  }
  return static_cast<int>(
      std::clamp(std::ceil(most / tolerance::way_at_once), 1.0, static_cast<double>(allowed)));
}

// The farthest turn of a body that may touch another [rad]: its contacts of the start of the step are elsewhere at its end.
double farthest_turn(std::span<const ContactPatch> patches, std::span<const MovingBody> bodies,
                     double dt) {
  double square = 0.0;
  for (const ContactPatch& patch : patches)
    for (const int body : {patch.first, patch.second})
      square = std::max(square, bodies[idx(body)].angular_velocity_w.squaredNorm());
  return dt * std::sqrt(square);
}

}  // namespace

ContactDamped::ContactDamped(const ContactDampedOptions& options) : options_(options) {
  for (const auto& [count, least, name] :
       {std::tuple{options.sweeps, 1, "sweeps"},
        std::tuple{options.admm_iterations, 0, "admm_iterations"},
        std::tuple{options.budget, 1, "budget"}, std::tuple{options.parts, 1, "parts"},
        std::tuple{options.correction_sweeps, 1, "correction_sweeps"}})
    require::that(count >= least, std::string(name) + " = " + std::to_string(count) +
                                      ": expected " + std::to_string(least) + " or more");
}

std::unique_ptr<Technique> ContactDamped::clone() const {
  return std::make_unique<ContactDamped>(*this);
}

StepReport ContactDamped::step(World& world, double dt) {
  require::positive(dt, "dt");
  StepReport report;
  SleepingRule& sleeping = memory_.sleeping;
  contact_time_ = world.time();
  recorded_ = false;
  if (!options_.sleeping)  // wakes bodies that another technique has put to sleep
    for (SleepState& rest : world.sleep_states()) rest.asleep = false;
  if (options_.sleeping) {
    const int woken = sleeping.wake_disturbed(world);
    if (woken == 0 && sleeping.nobody_awake()) {
      world.finish_step(dt);
      return report;
    }
  }
  // [S6.3.1:step]
  // Where bodies move far along each other, or into each other, the step
  // may be divided into parts; where one turns by more than a radian it is.
  load(world, dt);
  find_patches(world, dt, report);
  const std::span<const ContactPatch> patches = memory_.manifolds.patches();
  storage_.parts = std::max(parts_of_motion(patches, velocities_.free, dt, options_.parts),
                            parts_of_turn(farthest_turn(patches, velocities_.start, dt)));
  if (storage_.parts > 1) memory_.last_dt = dt;  // of the impulses found just now
  const double part = dt / storage_.parts;
  for (int k = 0; k < storage_.parts; ++k) {
    contact_time_ = world.time() + k * part;
    const StepReport done = step_part(world, part);
    add_report(done, report);
    report.contacts = done.contacts;
  }
  // [S6.3.1:step]
  // 7. Bodies at rest fall asleep.
  if (options_.sleeping) {
    const Islands& islands = memory_.order.islands();
    report.energy.damping +=
        sleeping.update_with_pairs(world, storage_.touching, islands, dt, slow_bodies()).energy;
  }
  world.finish_step(dt);
  return report;
}

StepReport ContactDamped::step_part(World& world, double dt) {
  StepReport report;
  // [S6.3.1:part]
  // 1. Gravity, and
  // 2. contact patches, where bodies touch or will within the part, by islands
  // of bodies that touch each other. If the step has one part, they are there.
  if (storage_.parts > 1) {
    load(world, dt);
    find_patches(world, dt, report);
  }
  // 3. Impulses that stop all approach, and sliding as far as friction can.
  storage_.in_flight.assign(velocities_.end.size(), 1);
  for (int k = 0; k < memory_.order.islands().count(); ++k)
    solve_island(view_of_island(world, k, dt), report);
  // Where they send a body into one that was out of reach, with that one.
  solve_missed(world, dt, report);
  // 4. Bodies move with these velocities.
  move(world, dt, report);
  // 5. Fast impacts bounce from there.
  bounce(world, dt, report);
  account(world, report);
  // 6. Overlap is corrected; no body gains kinetic energy.
  correct_overlaps(world, dt, report);
  // [S6.3.1:part]
  memory_.last_dt = dt;
  return report;
}

// Velocities before gravity, with it, and (to be changed) at the end. Sleeping bodies are immovable.
void ContactDamped::load(const World& world, double dt) {
  auto& [start, free, end, before_bounce] = velocities_;
  load_moving_bodies(world, start);
  for (std::size_t k = 0; k < start.size(); ++k) {
    if (!world.sleep_states()[k].asleep) continue;
    start[k].inverse_mass.setZero();
    start[k].inverse_inertia_w.setZero();
  }
  storage_.start_wb.clear();
  for (const BodyState& state : world.states()) storage_.start_wb.push_back(state.orientation_wb);
  free = start;
  for (MovingBody& body : free)
    if (body.inverse_mass.x() > 0.0) body.velocity_w += dt * world.gravity_w;
  end = free;
  before_bounce.reserve(free.size());  // so that a first bounce or correction allocates nothing
  storage_.displacements.reserve(free.size());
}

// Pairs that may touch within the step: bounds that reach as far as the bodies move in it.
void ContactDamped::find_candidates(const World& world, std::span<const MovingBody> moves,
                                    double dt) {
  std::vector<Bounds>& bounds = storage_.bounds;
  bounds.resize(idx(world.count()));
  for (std::size_t k = 0; k < bounds.size(); ++k) {
    const BodyProperties& body = world.bodies()[k];
    const MovingBody& moving = moves[k];
    if (!body.movable()) {
      bounds[k] = bounds_of(body, world.states()[k]);
      continue;
    }
    const double turn = 0.5 * body.size.norm() * moving.angular_velocity_w.norm();
    bounds[k] = bounds_of(body, world.states()[k],
                          dt * turn + tolerance::kept_margin * body.size.minCoeff());
    const Vec3 way_w = dt * moving.velocity_w;
    bounds[k].low += way_w.cwiseMin(0.0);
    bounds[k].high += way_w.cwiseMax(0.0);
  }
  memory_.broad_phase.find_pairs(bounds, storage_.candidates);
  if (!options_.sleeping) return;
  std::erase_if(storage_.candidates, [&](const IndexPair& pair) {
    return !memory_.sleeping.needs_test(pair.first, pair.second);
  });
}

void ContactDamped::find_patches(World& world, double dt, StepReport& report) {
  PersistentManifolds& manifolds = memory_.manifolds;
  double impulse_ratio = memory_.last_dt > 0.0 ? dt / memory_.last_dt : 1.0;
  for (;;) {
    find_candidates(world, velocities_.free, dt);
    const ManifoldsFound found =
        manifolds.find(world, velocities_.free, storage_.candidates, dt, impulse_ratio);
    report.pair_tests += found.pair_tests;
    report.deepest_overlap = std::max(report.deepest_overlap, found.deepest_overlap);
    storage_.touching.clear();
    for (const ContactPatch& patch : manifolds.patches())
      storage_.touching.push_back({patch.first, patch.second});
    if (!options_.sleeping || memory_.sleeping.wake_touched_pairs(world, storage_.touching) == 0)
      break;
    // Bodies that are touched wake up, and their neighbours have to be found as well.
    load(world, dt);
    impulse_ratio = 1.0;  // impulses have been scaled already
  }
  memory_.order.update(world, manifolds.patches(), storage_.touching);
}

// A view of one island of the step.
Island ContactDamped::view_of_island(const World& world, int k, double dt) {
  const Islands& islands = memory_.order.islands();
  return {world,
          dt,
          islands.bodies(k),
          islands.contacts(k),
          memory_.order.upward(k),
          memory_.manifolds.patches(),
          storage_.start_wb,
          velocities_.start,
          velocities_.free,
          velocities_.end};
}

// Which bodies turn about which: patches push at their centre of pressure. A patch whose friction is below its bound
// holds, and what it slips is the error of the solver. One at its bound stays `unknown`: whether it slips
// the pivot update finds out by itself. Where nothing turns, every body can be moved by itself.
void ContactDamped::find_pivots(const World& world, double dt) {
  storage_.pushed.clear();
  storage_.pivots.clear();
  const auto turns = [dt](const MovingBody& body) {
    return dt * body.angular_velocity_w.norm() > tolerance::least_turn;
  };
  if (std::none_of(velocities_.end.begin(), velocities_.end.end(), turns)) return;
  for (const ContactPatch& patch : memory_.manifolds.patches()) {
    PushedPair pair{patch.first, patch.second, Vec3::Zero(), patch.frame_w.col(2)};
    const Six all = impulse_of(patch);
    const double limit = (1.0 - tolerance::friction_limit) * patch.friction * all[six::normal];
    if (std::sqrt(all[0] * all[0] + all[1] * all[1]) < limit) pair.state = PushedState::held;
    for (const ContactPatchPoint& p : patch.used()) {
      if (p.impulse > 0.0 && std::abs(p.gap) > tolerance::contact_damped_slop * patch.size)
        pair.state = PushedState::unknown;  // it closes a gap, or there is overlap
      pair.point_w += p.impulse * position_of(patch, velocities_.start[idx(patch.first)], p);
    }
    if (!(all[six::normal] > 0.0)) continue;
    pair.point_w /= all[six::normal];
    storage_.pushed.push_back(pair);
  }
  storage_.pivots.find(world.bodies(), velocities_.end, storage_.pushed);
}

// Bodies with an impulse move with their velocity at the end of the step, which meets the targets of contacts;
// the others fly their parabola.
void ContactDamped::move(World& world, double dt, StepReport& report) {
  const std::vector<MovingBody>& end = velocities_.end;
  store_moving_bodies(end, world);
  if (options_.pose == PoseUpdate::exponential) find_pivots(world, dt);
  for (std::size_t k = 0; k < end.size(); ++k) {
    const BodyProperties& body = world.bodies()[k];
    if (end[k].inverse_mass.x() == 0.0) continue;
    BodyState& state = world.states()[k];
    // [S6.3.1:move]
    // No rule of rotation keeps the energy of a body that turns by radians at once.
    const int parts = parts_of_turn(dt * end[k].angular_velocity_w.norm(), tolerance::turn_at_once);
    const double part = dt / parts;
    if (storage_.in_flight[k] != 0) {
      for (int n = 0; n < parts; ++n) fly(body, state, world.gravity_w, part, options_.rotation);
    } else {
      state.linear_momentum_w = body.mass * end[k].velocity_w;
      if (storage_.pivots.carries(static_cast<int>(k))) {
        report.energy.repair += storage_.pivots.move(static_cast<int>(k), dt, world);
      } else {
        for (int n = 0; n < parts; ++n) advance_pose(body, state, part, options_.rotation);
      }
    }
    report.integrations += parts;
    // [S6.3.1:move]
  }
}

}  // namespace tumble
