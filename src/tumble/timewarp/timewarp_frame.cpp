/// \file
/// \brief Functions that the listings of the synchronised timewarp call (thesis 5.1, A.1).
#include "tumble/timewarp/timewarp_frame.hpp"

#include "tumble/base/error.hpp"
#include "tumble/base/index.hpp"
#include "tumble/contact/contact_records.hpp"
#include "tumble/contact/parts_of_turn.hpp"
#include "tumble/dynamics/flight.hpp"
#include "tumble/dynamics/step_mistakes.hpp"
#include "tumble/timewarp/near_pairs.hpp"

#include <algorithm>

namespace tumble {

void require_step(double dt, const TimewarpOptions& options, double steps) {
  require::positive(dt, "dt");
  require_resolved(steps * dt, options.resolution);
}

void require_finite_states(const World& world) {
  for (int body = 0; body < world.count(); ++body) {
    if (!is_finite(world.states()[idx(body)]))
      refuse("state of " + world.name(body) +
             " is not finite: expected numbers for place, orientation and momenta");
  }
}

TimewarpFrame::TimewarpFrame(const TimewarpOptions& options, SearchMethod method)
    : options_(options), method_(method), stage_({options.resolution, options.pair_events}) {}

void TimewarpFrame::begin(World& world, double dt, Observer* observer) {
  require_step(dt, options_);
  require_finite_states(world);
  world_ = &world;
  dt_ = dt;
  observer_ = observer;
  report = {};
  records_.clear();
  stage_.begin();
  test.resize(idx(world.count()));
  valid_times.resize(idx(world.count()));
  before_.resize(idx(world.count()));
  micro_steps_.resize(idx(world.count()));
}

void TimewarpFrame::integrate_forward(BodyState& state, int body, double time) {
  if (!movable(body)) return;
  const BodyProperties& properties = world_->bodies()[idx(body)];
  fly_in_micro_steps(properties, state, world_->gravity_w, time, options_.rotation,
                     micro_step_of(properties, state, options_.rotation, dt_));
  ++report.integrations;
}

bool TimewarpFrame::movable(int body) const { return world_->bodies()[idx(body)].movable(); }

// The pair's flight, each body as integrate_forward() flies it.
Flight TimewarpFrame::flight(const IndexPair& pair) {
  for (const int body : {pair.first, pair.second})
    micro_steps_[idx(body)] = micro_step_of(world_->bodies()[idx(body)],
                                            world_->states()[idx(body)], options_.rotation, dt_);
  return Flight{.bodies = world_->bodies(),
                .states = world_->states(),
                .valid_times = valid_times,
                .gravity_w = world_->gravity_w,
                .rule = options_.rotation,
                .micro_steps = micro_steps_};
}

// Bounds that must overlap for a pair to be searched: of the test state, or of the trajectory to it.
Bounds TimewarpFrame::bounds_of_body(int body) const {
  const BodyProperties& properties = world_->bodies()[idx(body)];
  if (method_ == SearchMethod::discrete) return bounds_of(properties, test[idx(body)]);
  return bounds_of_flight(properties, world_->states()[idx(body)], world_->gravity_w,
                          dt_ - valid_times[idx(body)], 0.5 * properties.size.norm());
}

void TimewarpFrame::find_all_collisions(CollisionHeap& heap) {
  bounds_.resize(test.size());
  for (int body = 0; body < world_->count(); ++body) bounds_[idx(body)] = bounds_of_body(body);
  broad_phase_.find_pairs(bounds_, candidates_);
  for (const IndexPair& pair : candidates_) search(pair, heap);
}

void TimewarpFrame::add_collisions_of(std::span<const int> bodies, CollisionHeap& heap) {
  for (const int body : bodies) bounds_[idx(body)] = bounds_of_body(body);
  for_each_near_pair(
      bodies, [&](int body) { return movable(body); }, bounds_,
      [&](const IndexPair& pair) { search(pair, heap); });
}

void TimewarpFrame::search(const IndexPair& pair, CollisionHeap& heap) {
  if (!(movable(pair.first) || movable(pair.second)) || stage_.holds(pair)) return;
  if (const std::optional<double> time = first_collision(pair, dt_)) heap.insert({*time, pair});
}

// The time of a pair's first collision before `end`, each body flown from its valid state.
std::optional<double> TimewarpFrame::first_collision(const IndexPair& pair, double end) {
  const Flight all = flight(pair);
  const double start = std::max(valid_times[idx(pair.first)], valid_times[idx(pair.second)]);
  if (!(start < end)) return std::nullopt;
  const auto gap = [&](double time) {
    ++report.pair_tests;
    return gap_at(all, pair, time).distance;
  };
  if (method_ == SearchMethod::discrete && gap(end) >= 0.0) return std::nullopt;
  const SearchOptions how{.method = method_,
                          .resolution = std::min(options_.resolution, end - start),
                          .cap = TimewarpOptions::kMostSeparations};
  const double gap_at_start = gap(start);
  if (gap_at_start < 0.0) {
    const bool deepening = gap(start + how.resolution) < gap_at_start;
    return deepening ? std::optional(start) : std::nullopt;
  }
  const PairCollision found = method_ == SearchMethod::discrete
                                  ? bisect_collision(all, pair, {start, end}, how)
                                  : advance_to_collision(all, pair, start, end, how);
  report.pair_tests += found.evaluations;
  report.searches += found.evaluations;
  if (found.status == CollisionStatus::cap_reached) stage_.defer(pair);
  if (found.status != CollisionStatus::found) return std::nullopt;
  return found.time;
}

std::span<const int> TimewarpFrame::find_near(const ForeseenCollision& collision) {
  const auto swept = [&](int body) {
    const BodyProperties& properties = world_->bodies()[idx(body)];
    return bounds_of_flight(properties, world_->states()[idx(body)], world_->gravity_w,
                            collision.time - valid_times[idx(body)], 0.5 * properties.size.norm());
  };
  const Bounds first = swept(collision.pair.first);
  const Bounds second = swept(collision.pair.second);
  near_.clear();
  for (int body = 0; body < world_->count(); ++body) {
    // A body that is valid at a later time has no trajectory until then.
    if (valid_times[idx(body)] > collision.time) continue;
    const Bounds own = swept(body);
    if (overlap(own, first) || overlap(own, second)) near_.push_back(body);
  }
  return near_;
}

std::optional<ForeseenCollision> TimewarpFrame::first_of_group(std::span<const int> group,
                                                               const ForeseenCollision& other) {
  std::optional<ForeseenCollision> earliest;
  const double before = other.time - options_.resolution;
  for (std::size_t i = 0; i < group.size(); ++i) {
    for (std::size_t j = i + 1; j < group.size(); ++j) {
      const IndexPair pair{group[i], group[j]};
      if (pair == other.pair || !(movable(pair.first) || movable(pair.second))) continue;
      if (stage_.holds(pair)) continue;
      const Bounds first = bounds_of(world_->bodies()[idx(pair.first)], test[idx(pair.first)]);
      const Bounds second = bounds_of(world_->bodies()[idx(pair.second)], test[idx(pair.second)]);
      if (!overlap(first, second)) continue;
      const std::optional<double> time = first_collision(pair, other.time);
      if (!time || !(*time < before)) continue;
      if (!earliest || ForeseenCollision{*time, pair} < *earliest)
        earliest = ForeseenCollision{*time, pair};
    }
  }
  return earliest;
}

void TimewarpFrame::collide(std::span<const IndexPair> pairs, double time) {
  list_movable(*world_, pairs, pushed_);
  for (const int body : pushed_)
    before_[idx(body)] = moving_body_of(world_->bodies()[idx(body)], world_->states()[idx(body)]);

  const InstantReport impact =
      impacts_.resolve(*world_, pairs, {.resolution = options_.resolution, .dt = dt_}, report);
  if (impact.status != ImpactStatus::done)
    report.status = std::max(report.status, StepStatus::event_cap);
  const int moved = static_cast<int>(pushed_.size());
  report.rewinds += moved;
  report_collisions(impact.contacts, time, moved);
  stage_.release_pushed(*world_, pushed_, before_, dt_);
  for (const IndexPair& pair : pairs)
    stage_.count(pair, impacts_.separation_speed(*world_, pair, dt_), world_->gravity_w.norm());
}

// Reports the collisions of one instant.
void TimewarpFrame::report_collisions(std::span<const Contact> contacts, double time, int rewinds) {
  Event moment{.time = world_->time() + time, .rewinds = rewinds};
  events_.clear();
  record_impact(*world_, contacts, moment, dt_, records_, events_);
  report.events += static_cast<std::int64_t>(events_.size());
  for (const Event& event : events_)
    if (observer_ != nullptr) observer_->on_event(event);
}

void TimewarpFrame::finish() {
  end_.settle(*world_, dt_, options_.resolution, stage_.pairs(), report, records_);
  report.contacts = static_cast<std::int64_t>(records_.size());
  report.fallbacks += stage_.entered();
  world_->finish_step(dt_);
}

void TimewarpFrame::show(TimewarpWatcher* watcher, const ForeseenCollision* current,
                         const CollisionHeap& heap) const {
  if (watcher == nullptr) return;
  const std::vector<ForeseenCollision> foreseen = heap.entries();
  watcher->on_queue({current, foreseen, world_->states(), valid_times, test});
}

void FrameEnd::settle(World& world, double dt, double resolution, std::span<const IndexPair> held,
                      StepReport& report, std::vector<ContactRecord>& records) {
  const double reach = world.gravity_w.norm() * dt * resolution;
  repair_bounds(world, reach, bounds_);
  broad_phase_.find_pairs(bounds_, candidates_);
  if (!held.empty()) {
    resting_.assign(held.begin(), held.end());
    join_touching(world, reach, report);
    const InstantReport impact = impacts_.resolve(
        world, resting_, {.resolution = resolution, .bounce = false, .dt = dt, .margin = reach},
        report);
    add_records(impact.contacts, world.time() + dt, records);
  }
  book(repair_.run(world, candidates_), report);
}

// Adds the pairs in contact that are connected to the resting ones through movable bodies.
void FrameEnd::join_touching(const World& world, double reach, StepReport& report) {
  const auto movable = [&](int body) { return world.bodies()[idx(body)].movable(); };
  const auto join = [&](const IndexPair& pair) {
    for (const int body : {pair.first, pair.second}) joined_[idx(body)] = movable(body) ? 1 : 0;
  };
  joined_.assign(idx(world.count()), 0);
  for (const IndexPair& pair : resting_) join(pair);

  touching_.clear();
  for (const IndexPair& pair : candidates_) {
    if (!movable(pair.first) && !movable(pair.second)) continue;
    ++report.pair_tests;
    const Separation gap =
        gap_between(world.bodies()[idx(pair.first)], world.states()[idx(pair.first)],
                    world.bodies()[idx(pair.second)], world.states()[idx(pair.second)]);
    if (gap.distance <= reach) touching_.push_back(pair);
  }
  const auto joins = [&](const IndexPair& pair) {
    if (joined_[idx(pair.first)] == 0 && joined_[idx(pair.second)] == 0) return false;
    join(pair);
    resting_.push_back(pair);
    return true;
  };
  while (std::erase_if(touching_, joins) > 0) continue;
  std::sort(resting_.begin(), resting_.end());
  resting_.erase(std::unique(resting_.begin(), resting_.end()), resting_.end());
}

}  // namespace tumble
