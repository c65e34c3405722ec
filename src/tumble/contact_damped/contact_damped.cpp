/// \file
/// \brief The default technique: a step.
#include "tumble/contact_damped/contact_damped.hpp"

#include "tumble/base/error.hpp"
#include "tumble/base/index.hpp"
#include "tumble/contact/parts_of_turn.hpp"
#include "tumble/contact/tolerances.hpp"
#include "tumble/contact_damped/bounce_order.hpp"
#include "tumble/contact_damped/step_parts.hpp"
#include "tumble/contact_patches/tolerances.hpp"
#include "tumble/dynamics/step_report.hpp"

#include <algorithm>
#include <string>
#include <tuple>

namespace tumble {
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
      forget_removed_bodies(world);
      world.finish_step(dt);
      return report;
    }
  }
  // [S6.3.1:step]
  // A step is divided where bodies that move by half an edge or more meet, where one that may touch
  // another turns by more than a radian, where an impact makes one turn so far that it would sink into another, where a
  // bounce sends a body on into another, and, if allowed, where bodies that touch move far.
  storage_.step = dt;
  storage_.work = 0;
  double left = dt;
  for (int k = 0; left > 0.0; ++k) {
    contact_time_ = world.time() + (dt - left);
    load(world, left);
    StepReport done;
    find_patches(world, left, done);
    storage_.parts = parts_of_step(left, k);
    const double part = length_of_part(world, left, k);
    if (part < left) shorten(left, part, world);
    const double made = step_part(world, part, k, done);
    add_report(done, report);
    report.contacts = done.contacts;
    left = made < left ? left - made : 0.0;
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

// Where all sleep, contacts stay those of the last step that was made, but for bodies that there are no more.
void ContactDamped::forget_removed_bodies(const World& world) {
  if (world.bodies().size() == velocities_.start.size() || contacts().empty()) return;
  std::erase_if(records_, [&](const ContactRecord& contact) {
    return !world.find(contact.first) || !world.find(contact.second);
  });
}

// Into how many parts a step is divided, now that some time is left for its k-th part and those after it.
int ContactDamped::parts_of_step(double left, int k) const {
  const std::span<const ContactPatch> patches = memory_.manifolds.patches();
  const int parts =
      k == 0 ? parts_of_motion(patches, velocities_.free, left, options_.parts) : storage_.parts;
  if (k >= kMostPartsOfTurn) return parts;
  return k + std::max(parts - k, parts_of_turn(farthest_turn(patches, velocities_.start, left)));
}

// The length of the k-th part.
double ContactDamped::length_of_part(const World& world, double left, int k) const {
  if (k >= kMostPartsOfTurn) return left;
  const double part = left / (storage_.parts - k);
  if (k >= kMostMeetings) return part;
  return time_to_fast_meeting(world, velocities_.start, storage_.candidates, options_.rotation,
                              part);
}

// Makes the k-th part of a step, or less of it where a bounce sends a body on into another. Returns how long it was [s].
double ContactDamped::step_part(World& world, double dt, int k, StepReport& report) {
  // [S6.3.1:part]
  // 1. Gravity has been added, and
  // 2. patches have been found where bodies touch or will within the part,
  // by islands of bodies that touch each other.
  // 3. Impulses that stop all approach, and sliding as far as friction can.
  solve(world, dt, report);
  // Where bodies of a small island sink into each other all the same, as they turn, in half of the time.
  const auto may_divide = [&] { return k < kMostBounces && !costs_too_much(); };
  for (int n = 0; n < kMostHalvings && storage_.small_sinks && may_divide(); ++n) {
    shorten(dt, 0.5 * dt, world);
    dt *= 0.5;
    solve(world, dt, report);
  }
  if (const FirstBounce first = may_divide() ? first_bounce(world, dt) : FirstBounce{dt, -1};
      first.time < dt) {
    shorten(dt, first.time, world);
    dt = first.time;
    release_open_patches(view_of_island(world, first.island, dt), dt);
    solve(world, dt, report);
  }
  // 4. Bodies move with these velocities.
  move(world, dt, report);
  // 5. Fast impacts bounce from there.
  bounce(world, dt, report);
  account(world, report);
  // 6. Overlap is corrected; no body gains kinetic energy.
  correct_overlaps(world, dt, report);
  // [S6.3.1:part]
  memory_.last_dt = dt;
  return dt;
}

// The impulses of all islands.
void ContactDamped::solve(World& world, double dt, StepReport& report) {
  storage_.in_flight.assign(velocities_.end.size(), 1);
  storage_.crowded = is_crowded(world, dt);
  for (int k = 0; k < memory_.order.islands().count(); ++k)
    solve_island(view_of_island(world, k, dt), report);
  // Where they send a body into one that was out of reach, with that one.
  solve_missed(world, dt, report);
  // Where they turn so far that they sink into each other on the way, with targets that allow for it.
  solve_turning(world, dt, report);
}

// When a bounce sends a body on into another [s], and in which island; or dt. In a heap that bounces one does all the time: it is
// for small islands.
ContactDamped::FirstBounce ContactDamped::first_bounce(const World& world, double dt) {
  FirstBounce first{dt, -1};
  for (int k = 0; k < memory_.order.islands().count() && !storage_.crowded; ++k) {
    const Island island = view_of_island(world, k, dt);
    if (!is_small(island)) continue;
    const double time = time_to_first_bounce(island, storage_.step);
    if (time < first.time) first = {time, k};
  }
  return first;
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

// Goes back to what holds for a part of a step for which patches were found.
void ContactDamped::shorten(double dt, double part, const World& world) {
  load(world, part);
  memory_.manifolds.shorten(velocities_.free, part, part / dt);
}

void ContactDamped::find_patches(World& world, double dt, StepReport& report) {
  PersistentManifolds& manifolds = memory_.manifolds;
  forget_bounces();
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

// Whether small islands that move are too many to solve each as well as if it was by itself, or have cost too much in this step.
bool ContactDamped::is_crowded(const World& world, double dt) {
  if (costs_too_much()) return true;
  const auto all = static_cast<std::int64_t>(memory_.manifolds.patches().size());
  if (!are_too_many(all, effort())) return false;
  std::int64_t moving = 0;
  for (int k = 0; k < memory_.order.islands().count(); ++k) {
    const Island island = view_of_island(world, k, dt);
    if (is_small(island)) moving += moving_patches(island);
  }
  return are_too_many(moving, effort());
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
          velocities_.end,
          memory_.order.levels(k)};
}

}  // namespace tumble
