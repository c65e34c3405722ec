/// \file
/// \brief Filters whose displayed pose follows the computed one (thesis 5.5).
#include "tumble/filtering/following_filter.hpp"

namespace tumble {

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
