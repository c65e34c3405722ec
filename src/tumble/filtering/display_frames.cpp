/// \file
/// \brief Frames between two steps.
#include "tumble/filtering/display_frames.hpp"

#include "tumble/filtering/tolerances.hpp"

#include <algorithm>
#include <cmath>

namespace tumble {

std::int64_t DisplayFrames::frame_from(double time) const {
  return static_cast<std::int64_t>(std::ceil(time * rate_ - tolerance::frame_slack));
}

void DisplayFrames::advance(double now) {
  const std::int64_t next = begun_ ? end_ : frame_from(now);
  last_ = begun_ ? now_ : now;
  now_ = now;
  begun_ = true;
  end_ = std::max(next,
                  static_cast<std::int64_t>(std::floor(now * rate_ + tolerance::frame_slack)) + 1);
  first_ = std::max(next, end_ - window_);
}

double DisplayFrames::share(std::int64_t frame) const {
  const double step = now_ - last_;
  const double since_last = static_cast<double>(frame) / rate_ - last_;
  return step > 0.0 ? std::clamp(since_last / step, 0.0, 1.0) : 1.0;
}

}  // namespace tumble
