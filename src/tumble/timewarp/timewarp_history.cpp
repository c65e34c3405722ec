/// \file
/// \brief Mirtich's timewarp: rollback, and the end of a step (thesis 2.4.3).
#include "tumble/base/index.hpp"
#include "tumble/contact/parts_of_turn.hpp"
#include "tumble/timewarp/timewarp_full.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace tumble {

// Integrating a brick's rotation has an error that grows with the step: a long flight takes several.
Milestone TimewarpFull::milestone(int body, double time, const BodyState& state,
                                  std::int64_t collision) const {
  const BodyProperties& properties = scratch_.bodies()[idx(body)];
  if (turns_evenly(properties, state, options_.rotation)) return {time, state, collision};
  const double part = std::min(dt_, micro_step_of(properties, state, options_.rotation, dt_));
  return {time, state, collision,
          std::max(part, longest_flight() / TimewarpFullOptions::kMostMicroSteps)};
}

BodyState TimewarpFull::flown(int body, const Milestone& from, double time) const {
  BodyState state = from.state;
  fly_in_micro_steps(scratch_.bodies()[idx(body)], state, scratch_.gravity_w, time - from.time,
                     options_.rotation, from.micro_step);
  return state;
}

bool TimewarpFull::movable(int body) const { return scratch_.bodies()[idx(body)].movable(); }

// Starts a new history; bodies that have collided with this one since that time are rolled back.
void TimewarpFull::begin_anew(int body, double time, const BodyState& state) {
  BodyHistory& history = histories_[idx(body)];
  if (!history.milestones().empty()) roll_back(body, time, true);
  history.begin(milestone(body, time, state, Milestone::kNoCollision));
  if (!movable(body)) history.end_at(std::numeric_limits<double>::infinity());
  history.measure(scratch_.bodies()[idx(body)], scratch_.gravity_w);
  wait_for_turn(body);
}

void TimewarpFull::wait_for_turn(int body) {
  if (!movable(body)) return;
  turns_.push_back({histories_[idx(body)].known_until(), body});
  std::push_heap(turns_.begin(), turns_.end(), later);
}

// [S2.4.3:take_back]
// Rolls a body back. Each collision of its future is cancelled; the partner goes back to just before
// it, which may cancel others, and so on.
void TimewarpFull::roll_back(int body, double time, bool also_at_it) {
  if (!movable(body)) return;
  BodyHistory& history = histories_[idx(body)];
  const auto undone = [&](double when) { return also_at_it ? when >= time : when > time; };
  while (history.milestones().size() > 1 && undone(history.milestones().back().time)) {
    undone_.push_back(history.milestones().back().collision);
    history.remove_last();
  }
  if (history.known_until() > time) {
    // Ends of frames that are computed in different ways differ by rounding.
    if (history.known_until() - time > options_.resolution) {
      ++work_.rolled_back;
      ++report_.rewinds;
    }
    history.end_at(time);
    drop_holds_of(body);
  }
  history.measure(scratch_.bodies()[idx(body)], scratch_.gravity_w);
  wait_for_turn(body);
  while (!undone_.empty()) {
    const std::int64_t number = undone_.back();
    undone_.pop_back();
    if (number != Milestone::kNoCollision) undo(number);
  }
}

void TimewarpFull::undo(std::int64_t number) {
  Resolved& collision = resolved(number);
  if (collision.cancelled) return;
  collision.cancelled = true;
  ++work_.cancelled;
  for (const int body : {collision.pair.first, collision.pair.second}) {
    BodyHistory& history = histories_[idx(body)];
    const auto is_it = [&](const Milestone& m) { return m.collision == number; };
    const std::span<const Milestone> way = history.milestones();
    if (std::none_of(way.begin(), way.end(), is_it)) continue;  // the body that was rolled back
    std::int64_t last = Milestone::kNoCollision;
    do {
      last = history.milestones().back().collision;
      if (last != number) undone_.push_back(last);
      history.remove_last();
    } while (last != number);
    history.end_at(std::min(history.known_until(), collision.time));
    drop_holds_of(body);
    history.measure(scratch_.bodies()[idx(body)], scratch_.gravity_w);
    ++work_.rolled_back;
    ++report_.rewinds;
    wait_for_turn(body);
  }
  for (Hold& hold : holds_)
    if (hold.ended_by == number) hold.until = std::numeric_limits<double>::infinity();
  std::erase_if(holds_, [&](const Hold& hold) { return hold.made_by == number; });
}
// [S2.4.3:take_back]

TimewarpFull::Resolved& TimewarpFull::resolved(std::int64_t number) {
  const auto found =
      std::lower_bound(resolved_.begin(), resolved_.end(), number,
                       [](const Resolved& r, std::int64_t n) { return r.number < n; });
  assert(found != resolved_.end() && found->number == number);
  return *found;
}

// A pair held because its search reached the cap is searched again if one of the two is rolled back.
void TimewarpFull::drop_holds_of(int body) {
  const double until = histories_[idx(body)].known_until();
  std::erase_if(holds_, [&](const Hold& hold) {
    const bool among = hold.pair.first == body || hold.pair.second == body;
    return among && hold.made_by == Milestone::kNoCollision && hold.since > until;
  });
}

bool TimewarpFull::held(const IndexPair& pair, double time) const {
  return std::any_of(holds_.begin(), holds_.end(), [&](const Hold& hold) {
    return hold.pair == pair && hold.since <= time && time < hold.until;
  });
}

// Whether a body is in a deferred pair, so that it must not pass the end of the frame.
bool TimewarpFull::waits_for_frame(int body) const {
  return std::any_of(holds_.begin(), holds_.end(), [&](const Hold& hold) {
    return (hold.pair.first == body || hold.pair.second == body) && std::isinf(hold.until);
  });
}

void TimewarpFull::finish(World& world) {
  show(world);
  report_final();
  settle(world);
  ++frames_;
  const bool synchronised = options_.synchronise_every > 0 && frames_ >= options_.synchronise_every;
  if (synchronised) frames_ = 0;
  for (int body = 0; body < world.count(); ++body) {
    const BodyState& state = world.states()[idx(body)];
    if (movable(body) && (synchronised || !(state == shown_[idx(body)])))
      begin_anew(body, dt_, state);
  }
  shown_.assign(world.states().begin(), world.states().end());
  forget_past(dt_);
  world.finish_step(dt_);
  scratch_.finish_step(dt_);
  count_from_here();
}

// Puts all bodies into their states at the end of the step.
void TimewarpFull::show(World& world) {
  for (int body = 0; body < world.count(); ++body) {
    if (!movable(body)) continue;
    world.states()[idx(body)] = flown(body, histories_[idx(body)].before(dt_), dt_);
  }
  shown_.assign(world.states().begin(), world.states().end());
}

// Reports the collisions of this step in order of time; they cannot be cancelled any more.
void TimewarpFull::report_final() {
  std::stable_sort(resolved_.begin(), resolved_.end(), [](const Resolved& a, const Resolved& b) {
    return a.time != b.time ? a.time < b.time : a.number < b.number;
  });
  for (const Resolved& collision : resolved_) {
    if (collision.cancelled || !(collision.time < dt_)) continue;
    report_.status = std::max(report_.status, collision.booked.status);
    report_.energy.restitution += collision.booked.energy.restitution;
    report_.energy.friction += collision.booked.energy.friction;
    report_.events += static_cast<std::int64_t>(collision.events.size());
    records_.insert(records_.end(), collision.records.begin(), collision.records.end());
    for (const Event& event : collision.events)
      if (observer() != nullptr) observer()->on_event(event);
  }
  std::erase_if(resolved_, [&](const Resolved& r) { return r.cancelled || r.time < dt_; });
  std::sort(resolved_.begin(), resolved_.end(),
            [](const Resolved& a, const Resolved& b) { return a.number < b.number; });
}

// Resolves deferred pairs and repairs overlap.
void TimewarpFull::settle(World& world) {
  resting_.clear();
  for (const Hold& hold : holds_)
    if (hold.since < dt_ && std::isinf(hold.until)) resting_.push_back(hold.pair);
  report_.fallbacks += std::count_if(holds_.begin(), holds_.end(),
                                     [&](const Hold& hold) { return hold.since < dt_; });
  std::erase_if(holds_, [&](const Hold& hold) { return hold.since < dt_; });
  std::sort(resting_.begin(), resting_.end());
  resting_.erase(std::unique(resting_.begin(), resting_.end()), resting_.end());
  end_.settle(world, dt_, options_.resolution, resting_, report_, records_);
  report_.contacts = static_cast<std::int64_t>(records_.size());
}

// [S2.4.3:forget]
// Drops milestones that no rollback can reach, except the last before `time`.
void TimewarpFull::forget_past(double time) {
  flights_since_forgetting_ = 0;
  std::int64_t kept = 0;
  for (int body = 0; body < scratch_.count(); ++body) {
    BodyHistory& history = histories_[idx(body)];
    kept += static_cast<std::int64_t>(history.milestones().size());
    if (history.milestones().size() == 1) continue;
    history.forget_before(time);
    history.measure(scratch_.bodies()[idx(body)], scratch_.gravity_w);
  }
  work_.most_milestones = std::max(work_.most_milestones, kept);
}
// [S2.4.3:forget]

// Times are counted from the start of the next step: near 0 they have the most digits.
void TimewarpFull::count_from_here() {
  turns_.clear();
  for (int body = 0; body < scratch_.count(); ++body) {
    histories_[idx(body)].shift(dt_);
    wait_for_turn(body);
  }
  for (Resolved& collision : resolved_) collision.time -= dt_;
  for (Hold& hold : holds_) {
    hold.since -= dt_;
    hold.until -= dt_;
  }
}

}  // namespace tumble
