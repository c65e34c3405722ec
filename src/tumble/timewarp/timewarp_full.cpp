/// \file
/// \brief Timewarp as Mirtich made it: flights and collisions (thesis 2.4.3).
#include "tumble/timewarp/timewarp_full.hpp"

#include "tumble/base/error.hpp"
#include "tumble/base/index.hpp"
#include "tumble/base/number_text.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace tumble {
namespace {

bool same_bodies(const World& a, const World& b) {
  return a.time() == b.time() && a.steps() == b.steps() && a.gravity_w == b.gravity_w &&
         std::equal(a.ids().begin(), a.ids().end(), b.ids().begin(), b.ids().end()) &&
         std::equal(a.bodies().begin(), a.bodies().end(), b.bodies().begin(), b.bodies().end());
}

}  // namespace

TimewarpFull::TimewarpFull(const TimewarpFullOptions& options) : options_(options) {
  static_cast<void>(ContactStage({options.resolution, options.pair_events}));  // checks them
  const bool good =
      options.stride == 0.0 || (options.stride >= TimewarpFullOptions::kShortestStride &&
                                options.stride <= TimewarpFullOptions::kLongestStride);
  require::that(good, "stride = " + shortest_text(options.stride) + ": expected 0, or from " +
                          shortest_text(TimewarpFullOptions::kShortestStride) + " to " +
                          shortest_text(TimewarpFullOptions::kLongestStride) + " steps");
  require::that(
      options.synchronise_every >= 0,
      "synchronise_every = " + std::to_string(options.synchronise_every) + ": expected 0 or more");
}

StepReport TimewarpFull::step(World& world, double dt) {
  require_step(dt, options_, std::max({options_.stride, 1.0 * options_.synchronise_every, 1.0}));
  require_finite_states(world);
  begin(world, dt);

  // [S2.4.3:loop]
  // The body furthest behind flies on, until no body is behind the end of the step.
  for (int body = next_body(); body >= 0; body = next_body()) {
    advance(body);
    // No body will be rolled back beyond the smallest local time.
    if (++flights_since_forgetting_ >= world.count()) forget_past(known_by_all_);
  }
  // [S2.4.3:loop]

  finish(world);
  whole_ = true;
  return report_;
}

// Adopts changes made since the last step.
void TimewarpFull::begin(const World& world, double dt) {
  dt_ = dt;
  report_ = {};
  records_.clear();
  horizon_ = options_.synchronise_every > 0 ? dt * (options_.synchronise_every - frames_)
                                            : std::numeric_limits<double>::infinity();
  const auto changed = [&](int body) { return !(world.states()[idx(body)] == shown_[idx(body)]); };
  // All histories restart after an incomplete step, with other bodies, and if an immovable body has
  // been moved: all tests were made against its old place.
  bool anew = !whole_ || !same_bodies(world, scratch_);
  for (int body = 0; body < world.count() && !anew; ++body) anew = !movable(body) && changed(body);
  whole_ = false;
  if (!anew) {
    for (int body = 0; body < world.count(); ++body)
      if (changed(body)) begin_anew(body, 0.0, world.states()[idx(body)]);
    return;
  }
  scratch_ = world;
  histories_.assign(idx(world.count()), {});
  resolved_.clear();
  holds_.clear();
  turns_.clear();
  frames_ = 0;
  for (int body = 0; body < world.count(); ++body) begin_anew(body, 0.0, world.states()[idx(body)]);
}

// The body with the smallest local time; none if that is the end of the step or later.
int TimewarpFull::next_body() {
  while (!turns_.empty()) {
    const Turn turn = turns_.front();
    const bool valid = histories_[idx(turn.body)].known_until() == turn.time;
    if (valid && !(turn.time < dt_)) return -1;
    std::pop_heap(turns_.begin(), turns_.end(), later);
    turns_.pop_back();
    if (!valid) continue;
    known_by_all_ = turn.time;
    return turn.body;
  }
  return -1;
}

double TimewarpFull::end_of_flight(int body) const {
  const double from = histories_[idx(body)].milestones().back().time;
  double end = options_.stride > 0.0 ? from + options_.stride * dt_ : std::max(dt_, horizon_);
  if (std::isinf(end) || waits_for_frame(body)) end = std::min(end, dt_);
  return std::max(std::min(end, horizon_), histories_[idx(body)].known_until());
}

// [S2.4.3:flight]
// A body flies on by a stride, unless it collides with a known trajectory.
void TimewarpFull::advance(int body) {
  const Meeting meeting = first_meeting(body, end_of_flight(body));
  if (meeting.other >= 0) {
    collide(body, meeting);
    return;
  }
  BodyHistory& history = histories_[idx(body)];
  const BodyState state = flown(body, history.milestones().back(), meeting.time);
  const Milestone next = milestone(body, meeting.time, state, Milestone::kNoCollision);
  ++report_.integrations;
  history.add(next, scratch_.bodies()[idx(body)], scratch_.gravity_w);
  wait_for_turn(body);
}
// [S2.4.3:flight]

// The first collision of a body's flight with the known trajectories of the others.
TimewarpFull::Meeting TimewarpFull::first_meeting(int body, double target) {
  Meeting best{target, -1};
  const Bounds flight = bounds_from(histories_[idx(body)].milestones().back(), target,
                                    scratch_.bodies()[idx(body)], scratch_.gravity_w);
  for (int other = 0; other < scratch_.count(); ++other)
    if (other != body && overlap(flight, histories_[idx(other)].bounds()))
      meet(body, other, flight, best);
  return best;
}

void TimewarpFull::meet(int body, int other, const Bounds& flight, Meeting& best) {
  const BodyHistory& history = histories_[idx(other)];
  const std::span<const Milestone> way = history.milestones();
  const double from = histories_[idx(body)].known_until();
  for (std::size_t k = 0; k < way.size(); ++k) {
    const double next = k + 1 < way.size() ? way[k + 1].time : history.known_until();
    const double start = std::max(from, way[k].time);
    const double end = std::min(best.time, next);
    if (!(start < end) || held({std::min(body, other), std::max(body, other)}, start)) continue;
    if (!overlap(flight,
                 bounds_from(way[k], next, scratch_.bodies()[idx(other)], scratch_.gravity_w)))
      continue;
    if (const auto first = first_collision(body, other, way[k], start, end)) {
      best = *first;
      return;
    }
  }
}

// The time at which two bodies first collide in an interval, each flown from its milestone.
std::optional<TimewarpFull::Meeting> TimewarpFull::first_collision(int body, int other,
                                                                   const Milestone& other_from,
                                                                   double start, double end) {
  const Milestone& own_from = histories_[idx(body)].milestones().back();
  const bool own_first = body < other;
  const Milestone& a = own_first ? own_from : other_from;
  const Milestone& b = own_first ? other_from : own_from;
  const std::array<BodyProperties, 2> bodies = {scratch_.bodies()[idx(std::min(body, other))],
                                                scratch_.bodies()[idx(std::max(body, other))]};
  const std::array<BodyState, 2> states = {a.state, b.state};
  const std::array<double, 2> times = {a.time, b.time};
  const std::array<double, 2> micro_steps = {a.micro_step, b.micro_step};
  const Flight both{.bodies = bodies,
                    .states = states,
                    .valid_times = times,
                    .gravity_w = scratch_.gravity_w,
                    .rule = options_.rotation,
                    .micro_steps = micro_steps};
  const IndexPair pair{0, 1};
  const SearchOptions how{.method = SearchMethod::conservative,
                          .resolution = std::min(options_.resolution, end - start),
                          .cap = TimewarpOptions::kMostSeparations};
  const auto gap = [&](double time) {
    ++report_.pair_tests;
    return gap_at(both, pair, time).distance;
  };
  // Overlapping bodies that separate are tested again a frame later, as in the other forms.
  double from = start;
  for (double now = gap(from); now < 0.0; now = gap(from)) {
    if (gap(from + how.resolution) < now) return Meeting{from, other};
    from += dt_;
    if (!(from < end)) return std::nullopt;
  }
  const PairCollision found = advance_to_collision(both, pair, from, end, how);
  report_.pair_tests += found.evaluations;
  report_.searches += found.evaluations;
  if (found.status == CollisionStatus::cap_reached) {
    // Known to be apart until here: the flight ends, and the pair is deferred to the end of the frame.
    holds_.push_back({{std::min(body, other), std::max(body, other)}, found.time});
    return Meeting{found.time, -1};
  }
  if (found.status != CollisionStatus::found) return std::nullopt;
  return Meeting{found.time, other};
}

// [S2.4.3:collide]
// The other body is rolled back to the time of the collision. Then both are at that time, and collide.
void TimewarpFull::collide(int body, const Meeting& meeting) {
  roll_back(meeting.other, meeting.time, false);
  Resolved collision{.number = next_number_++,
                     .time = meeting.time,
                     .pair = {std::min(body, meeting.other), std::max(body, meeting.other)}};
  const std::array<int, 2> both = {collision.pair.first, collision.pair.second};
  std::array<MovingBody, 2> old;
  for (std::size_t k = 0; k < 2; ++k) {
    const BodyProperties& properties = scratch_.bodies()[idx(both[k])];
    BodyState& state = scratch_.states()[idx(both[k])];
    state = flown(both[k], histories_[idx(both[k])].milestones().back(), meeting.time);
    if (properties.movable()) ++report_.integrations;
    old[k] = moving_body_of(properties, state);
  }
  const InstantReport impact =
      impacts_.resolve(scratch_, {&collision.pair, 1},
                       {.resolution = options_.resolution, .dt = dt_}, collision.booked);
  // [S2.4.3:collide]

  if (impact.status != ImpactStatus::done) collision.booked.status = StepStatus::event_cap;
  report_.pair_tests += collision.booked.pair_tests;
  report_.impulses += collision.booked.impulses;
  report_.iterations += collision.booked.iterations;
  report_.pivots += collision.booked.pivots;
  Event moment{.time = scratch_.time() + meeting.time,
               .rewinds = movable(both[0]) && movable(both[1]) ? 2 : 1};
  record_impact(scratch_, impact.contacts, moment, dt_, collision.records, collision.events);
  for (std::size_t k = 0; k < 2; ++k) {
    const BodyProperties& properties = scratch_.bodies()[idx(both[k])];
    if (!properties.movable()) continue;
    const BodyState& state = scratch_.states()[idx(both[k])];
    collision.pushes[k] =
        fastest_point_change(properties, old[k], moving_body_of(properties, state));
    histories_[idx(both[k])].add(milestone(both[k], meeting.time, state, collision.number),
                                 properties, scratch_.gravity_w);
    wait_for_turn(both[k]);
  }
  hold_or_release(collision, impacts_.separation_speed(scratch_, collision.pair, dt_));
  resolved_.push_back(std::move(collision));
}

// The rule of ContactStage, applied to the collisions of the last dt. The start and the end of a hold
// belong to the collisions that caused them, and are undone with these.
void TimewarpFull::hold_or_release(const Resolved& collision, double separation_speed) {
  const auto events_of = [&](const IndexPair& pair) {
    return std::count_if(resolved_.begin(), resolved_.end(), [&](const Resolved& r) {
      return r.pair == pair && !r.cancelled && r.time > collision.time - dt_;
    });
  };
  const double gravity = scratch_.gravity_w.norm();
  const std::array<int, 2> both = {collision.pair.first, collision.pair.second};
  for (std::size_t k = 0; k < 2; ++k) {
    if (!(collision.pushes[k] > gravity * dt_)) continue;
    for (Hold& hold : holds_) {
      const bool among = hold.pair.first == both[k] || hold.pair.second == both[k];
      if (!among || !std::isinf(hold.until) || events_of(hold.pair) >= options_.pair_events)
        continue;
      hold.until = collision.time;
      hold.ended_by = collision.number;
    }
  }
  const bool at_once = 2.0 * separation_speed <= gravity * options_.resolution;
  if (at_once || events_of(collision.pair) + 1 >= options_.pair_events)
    holds_.push_back({collision.pair, collision.time, collision.number});
}

}  // namespace tumble
