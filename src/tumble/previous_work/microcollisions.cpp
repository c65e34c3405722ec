/// \file
/// \brief Everything is a collision: Mirtich's impulses as a technique.
#include "tumble/previous_work/microcollisions.hpp"

#include "tumble/base/error.hpp"
#include "tumble/base/index.hpp"
#include "tumble/contact/contact_records.hpp"
#include "tumble/contact/gather.hpp"
#include "tumble/contact/movable_edge.hpp"
#include "tumble/contact/parts_of_turn.hpp"
#include "tumble/timewarp/near_pairs.hpp"
#include "tumble/timewarp/timewarp_frame.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace tumble {
namespace {

constexpr double kResolution = tolerance::event_resolution;
constexpr int kLooks = 64;  // in a step, at bodies that overlap and part

// [m/s] Speed at which a body may hop in place of resting. Without gravity nothing rests.
double speed_scale(const World& world, const IndexPair& pair) {
  return std::sqrt(world.gravity_w.norm() *
                   movable_edge(world.bodies()[idx(pair.first)], world.bodies()[idx(pair.second)]));
}

}  // namespace

Microcollisions::Microcollisions(const MicrocollisionsOptions& options)
    : options_(options), broad_phase_(make_broad_phase(options.broad_phase)) {
  require::within(options.rebound, 0.0, 1.0, "rebound");
  require::that(options.event_cap >= 1,
                "event_cap = " + std::to_string(options.event_cap) + ": expected 1 or more");
}

Microcollisions::Microcollisions(const Microcollisions& other)
    : Cloned(other),
      options_(other.options_),
      broad_phase_(other.broad_phase_->clone()),
      records_(other.records_) {}

StepReport Microcollisions::step(World& world, double dt) {
  require_step(dt, {.resolution = kResolution});
  require_finite_states(world);
  records_.clear();
  left_ = options_.event_cap;
  return step_in_parts(world, dt, [&](World& w, double part, int) { return step_part(w, part); });
}

// [S2.5.2:queue]
// The earliest collision of the queue, again and again. A body is flown when its turn comes, and to the end of the
// step at last.
StepReport Microcollisions::step_part(World& world, double dt) {
  Part part{world, dt, {}};
  begin(part);
  while (!queue_.empty() && left_ > 0) meet(part, queue_.remove_first());
  if (!queue_.empty()) part.report.status = StepStatus::event_cap;
  finish(part);
  return part.report;
}

// All points that approach, the fastest first. What a push does to the others is seen at once.
void Microcollisions::meet(Part& part, const ForeseenCollision& met) {
  const bool overlap = find_points(part, met);
  bool pushed = false;
  for (; left_ > 0; --left_) {
    const Approach at = fastest_approach();
    if (!at.found) break;
    collide(part, at, met.time);
    pushed = true;
  }
  // Bodies that overlap and part are left to do so for a while.
  const double pause = overlap ? part.dt / kLooks : kResolution;
  if (!pushed) {
    --left_;
    return search(part, met.pair, met.time + pause);
  }
  store(part, met.pair);
  for (const int body : movable_) {
    queue_.forget(body);
    bounds_[idx(body)] = bounds_until_end(part, body);
  }
  for_each_near_pair(
      movable_, [&](int body) { return part.world.bodies()[idx(body)].movable(); }, bounds_,
      [&](const IndexPair& pair) {
        search(part, pair, met.time + (overlap && pair == met.pair ? pause : 0.0));
      });
}
// [S2.5.2:queue]

void Microcollisions::begin(Part& part) {
  const auto count = part.world.bodies().size();
  valid_times_.assign(count, 0.0);
  moving_.resize(count);
  bounds_.clear();
  for (std::size_t k = 0; k < count; ++k)
    bounds_.push_back(bounds_until_end(part, static_cast<int>(k)));
  broad_phase_->find_pairs(bounds_, pairs_);
  queue_.reset(part.world.count());
  for (const IndexPair& pair : pairs_) search(part, pair, 0.0);
}

Bounds Microcollisions::bounds_until_end(const Part& part, int body) const {
  const BodyProperties& properties = part.world.bodies()[idx(body)];
  return bounds_of_flight(properties, part.world.states()[idx(body)], part.world.gravity_w,
                          part.dt - valid_times_[idx(body)], 0.5 * properties.size.norm());
}

void Microcollisions::fly_to(Part& part, int body, double time) {
  const BodyProperties& properties = part.world.bodies()[idx(body)];
  if (!properties.movable()) return;
  fly(properties, part.world.states()[idx(body)], part.world.gravity_w,
      time - valid_times_[idx(body)], options_.rotation);
  valid_times_[idx(body)] = time;
  ++part.report.integrations;
}

// When two bodies meet next. Bodies that overlap are looked at when the search begins.
void Microcollisions::search(Part& part, const IndexPair& pair, double start) {
  const World& world = part.world;
  if (!(start < part.dt)) return;
  if (!world.bodies()[idx(pair.first)].movable() && !world.bodies()[idx(pair.second)].movable())
    return;
  const Flight flight{.bodies = world.bodies(),
                      .states = world.states(),
                      .valid_times = valid_times_,
                      .gravity_w = world.gravity_w,
                      .rule = options_.rotation};
  ++part.report.pair_tests;
  const double size =
      movable_edge(world.bodies()[idx(pair.first)], world.bodies()[idx(pair.second)]);
  if (gap_at(flight, pair, start).distance < -tolerance::rounding_overlap * size)
    return queue_.insert({start, pair});
  const SearchOptions how{.method = SearchMethod::conservative,
                          .resolution = std::min(kResolution, part.dt - start)};
  const PairCollision found = advance_to_collision(flight, pair, start, part.dt, how);
  part.report.pair_tests += found.evaluations;
  part.report.searches += found.evaluations;
  if (found.status != CollisionStatus::none) queue_.insert({found.time, pair});
}

// Flies two bodies to where they meet, and finds their contact there. Returns whether they overlap.
bool Microcollisions::find_points(Part& part, const ForeseenCollision& met) {
  const World& world = part.world;
  movable_.clear();
  for (const int body : {met.pair.first, met.pair.second}) {
    fly_to(part, body, met.time);
    if (world.bodies()[idx(body)].movable()) movable_.push_back(body);
    moving_[idx(body)] = moving_body_of(world.bodies()[idx(body)], world.states()[idx(body)]);
  }
  contact_ = contact_of(world, met.pair);
  const double margin = search_margin(world, moving_, {&met.pair, 1}, kResolution);
  ++part.report.pair_tests;
  Manifold manifold;
  if (!touch_pair(world, world.states(), met.pair, margin, kNoAxis, manifold)) return false;
  set_points(manifold, contact_);
  double deepest = 0.0;
  for (int k = 0; k < contact_.count; ++k)
    deepest = std::max(deepest, -contact_.points[idx(k)].distance);
  part.report.deepest_overlap = std::max(part.report.deepest_overlap, deepest);
  return deepest > margin;
}

// The point that approaches fastest. Points that move as it does are one point in their middle.
Microcollisions::Approach Microcollisions::fastest_approach() const {
  const MovingBody& a = moving_[idx(contact_.first)];
  const MovingBody& b = moving_[idx(contact_.second)];
  Approach out;
  double least = 0.0;
  for (int k = 0; k < contact_.count; ++k) {
    const Vec3 motion_w = relative_velocity(a, b, contact_.points[idx(k)].position_w);
    const double speed = contact_.normal_w.dot(motion_w);
    if (!(speed < least)) continue;
    least = speed;
    out.motion_w = motion_w;
    out.found = true;
  }
  Vec3 sum_w = Vec3::Zero();
  int count = 0;
  for (int k = 0; k < contact_.count; ++k) {
    const Vec3& point_w = contact_.points[idx(k)].position_w;
    const Vec3 other_w = relative_velocity(a, b, point_w);
    if ((other_w - out.motion_w).norm() > tolerance::same_velocity * out.motion_w.norm()) continue;
    sum_w += point_w;
    ++count;
  }
  if (out.found) out.point_w = sum_w / count;
  return out;
}

// [S2.5.2:microcollision]
// A slow approach is turned round, slip and all, if friction allows it. Everything else takes its course.
void Microcollisions::collide(Part& part, const Approach& at, double time) {
  MovingBody& a = moving_[idx(contact_.first)];
  MovingBody& b = moving_[idx(contact_.second)];
  const Vec3& n = contact_.normal_w;
  SlidingImpact impact{n, at.motion_w, inverse_mass_at(a, b, at.point_w), contact_.friction};
  impact.end = options_.end;
  impact.rebound = options_.rebound * speed_scale(part.world, {contact_.first, contact_.second});
  Vec3 impulse_w = Vec3::Zero();
  const double approach = -n.dot(at.motion_w);
  if (approach < impact.rebound) {
    const Vec3 slip_w = at.motion_w + approach * n;
    impulse_w = impact.inverse_mass_w.ldlt().solve((impact.rebound + approach) * n - 2.0 * slip_w);
  } else {
    impact.restitution = contact_.restitution;
  }
  const double push = n.dot(impulse_w);
  if (!(push > 0.0) || (impulse_w - push * n).norm() > impact.friction * push)
    impulse_w = solve_sliding_impact(impact).impulse_w;
  apply_impulse(a, b, at.point_w, impulse_w);
  book(part, at, impact.inverse_mass_w, impulse_w, time);
}
// [S2.5.2:microcollision]

// Work is an impulse times the mean of the velocities before and after.
void Microcollisions::book(Part& part, const Approach& at, const Mat3& yield_w,
                           const Vec3& impulse_w, double time) {
  const Vec3& n = contact_.normal_w;
  const Vec3 mean_w = at.motion_w + 0.5 * yield_w * impulse_w;
  const double push = n.dot(impulse_w);
  part.report.energy.restitution += push * n.dot(mean_w);
  part.report.energy.friction += (impulse_w - push * n).dot(mean_w);
  ++part.report.events;
  ++part.report.impulses;
  Contact one = contact_;
  one.count = 1;
  one.points[0].position_w = at.point_w;
  one.points[0].normal_impulse = push;
  one.points[0].friction_impulse_w = impulse_w - push * n;
  Event moment{.time = part.world.time() + time};
  add_records({&one, 1}, moment.time, records_);
  report_collision(one, moment, observer());
}

void Microcollisions::store(Part& part, const IndexPair& pair) {
  for (const int body : {pair.first, pair.second})
    store_moving_body(moving_[idx(body)], part.world.bodies()[idx(body)],
                      part.world.states()[idx(body)]);
}

// What is left of overlap (at the start, or in a step that met its cap) is repaired by moving bodies.
void Microcollisions::finish(Part& part) {
  for (int body = 0; body < part.world.count(); ++body) fly_to(part, body, part.dt);
  repair_bounds(part.world, 0.0, bounds_);
  broad_phase_->find_pairs(bounds_, pairs_);
  tumble::book(repair_.run(part.world, pairs_), part.report);
  part.report.contacts = static_cast<std::int64_t>(records_.size());
}

}  // namespace tumble
