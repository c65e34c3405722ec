/// \file
/// \brief The default technique: bodies move, by themselves or carried by those on which they stand.
#include "tumble/base/index.hpp"
#include "tumble/base/tolerances.hpp"
#include "tumble/contact/parts_of_turn.hpp"
#include "tumble/contact/tolerances.hpp"
#include "tumble/contact_damped/body_motion.hpp"
#include "tumble/contact_damped/contact_damped.hpp"
#include "tumble/contact_damped/tolerances.hpp"
#include "tumble/contact_patches/tolerances.hpp"
#include "tumble/dynamics/energy.hpp"
#include "tumble/dynamics/flight.hpp"
#include "tumble/dynamics/integrate.hpp"

#include <algorithm>
#include <cmath>

namespace tumble {
namespace {

// A body in flight gets its share of gravity on the way: takes it from the momentum that impulses have left at the end of the step.
void take_gravity(const BodyMotion& motion, int k, const MovingBody& end, const World& world,
                  BodyState& state) {
  if (motion.in_flight[idx(k)] != 0 && end.changed)
    state.linear_momentum_w -= motion.dt * world.bodies()[idx(k)].mass * world.gravity_w;
}

}  // namespace

void decide_flight(const Island& island, std::span<char> in_flight) {
  double fastest = 0.0;  // [m/s]
  for (const int k : island.bodies) {
    const MovingBody& free = island.free[idx(k)];
    fastest = std::max(fastest, fastest_point_speed(island.world.bodies()[idx(k)], free.velocity_w,
                                                    free.angular_velocity_w));
  }
  const double none = tolerance::rounding * fastest;
  for (const int k : island.bodies) {
    MovingBody& now = island.now[idx(k)];
    const MovingBody& free = island.free[idx(k)];
    if (fastest_point_change(island.world.bodies()[idx(k)], free, now) <= none) now = free;
  }
  const auto is_held = [&](int k) {
    return in_flight[idx(k)] == 0 || island.now[idx(k)].inverse_mass.x() == 0.0;
  };
  for (bool more = true; more;) {
    more = false;
    for (const int contact : island.upward) {
      const ContactPatch& patch = island.all_patches[idx(contact)];
      if (is_held(patch.first) == is_held(patch.second)) continue;
      if (!(impulse_of(patch)[six::normal] * patch.inverse_mass[2][2] > none)) continue;
      in_flight[idx(patch.first)] = in_flight[idx(patch.second)] = 0;
      more = true;
    }
  }
}

int move_by_itself(const BodyMotion& motion, int k, double turn, const World& world,
                   BodyState& state) {
  const BodyProperties& body = world.bodies()[idx(k)];
  // [S6.3.1:move]
  // No rule of rotation keeps the energy of a body that turns by radians at once.
  const int parts = parts_of_turn(turn, tolerance::turn_at_once);
  for (int n = 0; n < parts; ++n) {
    if (motion.in_flight[idx(k)] != 0)
      fly(body, state, world.gravity_w, motion.dt / parts, motion.rotation);
    else
      advance_pose(body, state, motion.dt / parts, motion.rotation);
  }
  // [S6.3.1:move]
  return parts;
}

BodyState state_after(const BodyMotion& motion, int k, const MovingBody& end, const World& world) {
  BodyState state = world.states()[idx(k)];
  if (end.inverse_mass.x() == 0.0) return state;
  store_moving_body(end, world.bodies()[idx(k)], state);
  take_gravity(motion, k, end, world, state);
  move_by_itself(motion, k, motion.dt * end.angular_velocity_w.norm(), world, state);
  return state;
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
      if (p.impulse > 0.0 && std::abs(p.gap) > tolerance::contact_slop * patch.size)
        pair.state = PushedState::unknown;  // it closes a gap, or there is overlap
      pair.point_w += p.impulse * position_of(patch, velocities_.start[idx(patch.first)], p);
    }
    if (!(all[six::normal] > 0.0)) continue;
    pair.point_w /= all[six::normal];
    storage_.pushed.push_back(pair);
  }
  do {
    storage_.pivots.find(world.bodies(), velocities_.end, storage_.pushed);
  } while (drop_sinking_pivots(world, dt));
}

// Targets are such that bodies meet as each moves by itself. Where one that is carried would sink into another, and by itself
// would not as deep, its pushes carry nothing. Returns whether there is one.
bool ContactDamped::drop_sinking_pivots(const World& world, double dt) {
  const BodyMotion motion{dt, options_.rotation, storage_.in_flight};
  const PivotUpdate& pivots = storage_.pivots;
  const auto carried = [&](int k) { return pivots.carries(k) && storage_.in_flight[idx(k)] == 0; };
  const auto alone = [&](int k) { return state_after(motion, k, velocities_.end[idx(k)], world); };
  const auto together = [&](int k) {
    if (!carried(k)) return alone(k);
    BodyState state = world.states()[idx(k)];
    state.position_w += dt * velocities_.end[idx(k)].velocity_w;
    pivots.carry(k, dt, state);
    return state;
  };
  std::vector<char>& sinks = storage_.sinks;
  sinks.assign(velocities_.end.size(), 0);
  bool any = false;
  for (const ContactPatch& patch : memory_.manifolds.patches()) {
    const int first = patch.first, second = patch.second;
    const double turn = dt * std::max(velocities_.end[idx(first)].angular_velocity_w.norm(),
                                      velocities_.end[idx(second)].angular_velocity_w.norm());
    if (!(turn > tolerance::turn_that_shows) || !(carried(first) || carried(second))) continue;
    const auto apart = [&](const BodyState& a, const BodyState& b) {
      return gap_between(world.bodies()[idx(first)], a, world.bodies()[idx(second)], b).distance;
    };
    const double distance = apart(together(first), together(second));
    if (!(distance < -tolerance::sunk_by_turning * patch.size) ||
        !(distance < apart(alone(first), alone(second))))
      continue;
    any = true;
    sinks[idx(first)] = carried(first) ? 1 : 0;
    sinks[idx(second)] = carried(second) ? 1 : 0;
  }
  std::erase_if(storage_.pushed, [&](const PushedPair& pair) {
    return sinks[idx(pair.first)] != 0 || sinks[idx(pair.second)] != 0;
  });
  return any;
}

// Moves a body with those that it turns with. The exponential turns it about a fixed axis, which a thin rod would not keep:
// where that would add energy it stays where it is. Returns whether it has moved.
bool ContactDamped::carry(int k, double dt, World& world, StepReport& report) const {
  const BodyProperties& body = world.bodies()[idx(k)];
  BodyState& state = world.states()[idx(k)];
  const BodyState before = state;
  const double repair = storage_.pivots.move(k, dt, world);
  if (kinetic_energy(body, state) >
      (1.0 + tolerance::carried_gain) * kinetic_energy(body, before)) {
    state = before;
    return false;
  }
  report.energy.repair += repair;
  return true;
}

// Bodies with an impulse move with their velocity at the end of the step, which meets the targets of contacts;
// the others fly their parabola.
void ContactDamped::move(World& world, double dt, StepReport& report) {
  const std::vector<MovingBody>& end = velocities_.end;
  store_moving_bodies(end, world);
  if (options_.pose == PoseUpdate::exponential) find_pivots(world, dt);
  const BodyMotion motion{dt, options_.rotation, storage_.in_flight};
  for (std::size_t b = 0; b < end.size(); ++b) {
    if (end[b].inverse_mass.x() == 0.0) continue;
    const int k = static_cast<int>(b);
    BodyState& state = world.states()[b];
    const double turn = dt * end[b].angular_velocity_w.norm();
    take_gravity(motion, k, end[b], world, state);
    if (storage_.in_flight[b] == 0) {
      state.linear_momentum_w = world.bodies()[b].mass * end[b].velocity_w;
      if (storage_.pivots.carries(k) && carry(k, dt, world, report)) {
        report.integrations += parts_of_turn(turn, tolerance::turn_at_once);
        continue;
      }
    }
    report.integrations += move_by_itself(motion, k, turn, world, state);
  }
}

}  // namespace tumble
