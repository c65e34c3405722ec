/// \file
/// \brief The part common to all filters.
#include "tumble/filtering/pose_filter.hpp"

#include "tumble/base/error.hpp"
#include "tumble/base/number_text.hpp"
#include "tumble/base/tolerances.hpp"

#include <cmath>

namespace tumble {

namespace {

bool in_order(const BodyState& state) {
  const double length = state.orientation_wb.norm();
  return state.position_w.allFinite() && std::abs(length - 1.0) <= tolerance::unit_length;
}

}  // namespace

std::string PoseFilter::where(const Frame& frame) const {
  return "frame " + std::to_string(taken_) + " at " + shortest_text(frame.time) + " s";
}

void PoseFilter::add(const Frame& frame, const FrameSink& show) {
  require::finite(frame.time, "time of a frame");
  if (taken_ > 0 && !(frame.time > last_time_))
    refuse(where(frame) + ": expected a time after " + shortest_text(last_time_) +
           " s, that of the frame before");
  if (frame.ids.size() != frame.states.size())
    refuse(where(frame) + ": " + std::to_string(frame.ids.size()) + " ids and " +
           std::to_string(frame.states.size()) + " states: expected as many");
  for (std::size_t k = 0; k < frame.states.size(); ++k) {
    const auto body = [&] {
      return where(frame) + ", body with id " + std::to_string(number_of(frame.ids[k]));
    };
    if (k > 0 && !(frame.ids[k - 1] < frame.ids[k])) refuse(body() + ": expected ids that ascend");
    if (!in_order(frame.states[k]))
      refuse(body() +
             ": its position is not finite, or its orientation not of length 1. "
             "Filter the frames before it");
  }
  take(frame, show);
  ++taken_;
  last_time_ = frame.time;
}

void PoseFilter::finish(const FrameSink& show) {
  end(show);
  taken_ = 0;
}

Trajectory filtered(const Trajectory& run, const PoseFilter& filter) {
  Trajectory shown;
  const FrameSink show = [&](const Frame& frame) { shown.record(frame); };
  const std::unique_ptr<PoseFilter> own = filter.clone();
  own->finish([](const Frame&) {});  // clears frames of another run
  for (int k = 0; k < run.count(); ++k) own->add(run.frame(k), show);
  own->finish(show);
  return shown;
}

FilteringObserver::FilteringObserver(const World& world, const PoseFilter& filter, int every)
    : filter_(filter.clone()), every_(every) {
  require::that(every >= 1, "every = " + std::to_string(every) + ": expected at least 1");
  filter_->finish([](const Frame&) {});
  take_in(world);
}

void FilteringObserver::on_step(const World& world, const StepReport& report) {
  (void)report;
  if (++since_last_ < every_) return;
  since_last_ = 0;
  take_in(world);
}

void FilteringObserver::finish() {
  filter_->finish([&](const Frame& frame) { shown_.record(frame); });
}

void FilteringObserver::take_in(const World& world) {
  filter_->add(frame_of(world), [&](const Frame& frame) { shown_.record(frame); });
}

void FollowingFilter::take(const Frame& frame, const FrameSink& show) {
  const double dt = frame.time - last_time_;
  next_.clear();
  states_.clear();
  auto known = bodies_.begin();  // sorted by id, as the frame's bodies are
  for (std::size_t k = 0; k < frame.ids.size(); ++k) {
    const BodyState& now = frame.states[k];
    while (known != bodies_.end() && known->id < frame.ids[k]) ++known;
    if (known == bodies_.end() || known->id != frame.ids[k]) {
      next_.push_back({frame.ids[k], now, now});
    } else {
      next_.push_back(*known);
      follow(now, dt, next_.back());
      next_.back().computed = now;
    }
    states_.push_back(now);
    states_.back().position_w = next_.back().shown.position_w;
    states_.back().orientation_wb = next_.back().shown.orientation_wb;
  }
  bodies_.swap(next_);
  last_time_ = frame.time;
  show(Frame{frame.time, frame.step, frame.ids, states_});
}

void FollowingFilter::end(const FrameSink& show) {
  (void)show;  // nothing is held back
  bodies_.clear();
}

}  // namespace tumble
