/// \file
/// \brief Frames of a display that lie between two steps of a run (thesis 5.5).
#pragma once

#include "tumble/dynamics/world.hpp"
#include "tumble/filtering/tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

namespace tumble {

/// Frames at multiples of a fixed time, independent of the time step.
///
/// Frame n is at time n over the rate. A step shows it even if it ends before it by up to
/// tolerance::frame_slack of a frame. Poses between two steps are interpolated linearly.
class DisplayFrames {
 public:
  /// Starts before the first step.
  /// \param rate    [1/s] frames per second
  /// \param window  of a step over more frames, only this many last ones are shown
  DisplayFrames(double rate, int window) : rate_(rate), window_(window) {}

  /// Adds a step; the first call shows at most the frame at its own time.
  /// \param now [s] time after the step, not before that of the last step
  void advance(double now) {
    const std::int64_t next = begun_ ? end_ : frame_from(now);
    last_ = begun_ ? now_ : now;
    now_ = now;
    begun_ = true;
    end_ = std::max(next, number(std::floor(now * rate_ + tolerance::frame_slack)) + 1);
    first_ = std::max(next, end_ - window_);
  }

  /// Whether a step or a start has been added; false until advance() is called.
  [[nodiscard]] bool begun() const { return begun_; }
  /// The time after the last step [s].
  [[nodiscard]] double now() const { return now_; }
  /// The first frame that the last step shows; end() if the step shows none.
  [[nodiscard]] std::int64_t first() const { return first_; }
  /// The first frame that has not been shown yet: one more than the last one shown.
  [[nodiscard]] std::int64_t end() const { return end_; }
  /// The first frame at a time or after it.
  /// \param time [s]
  [[nodiscard]] std::int64_t frame_from(double time) const {
    return number(std::ceil(time * rate_ - tolerance::frame_slack));
  }
  /// Position of a frame within the last step.
  /// \param frame first() to end() - 1
  /// \return [-] share of the step that is over by then, 0 to 1
  [[nodiscard]] double share(std::int64_t frame) const {
    const double step = now_ - last_;
    const double since_last = static_cast<double>(frame) / rate_ - last_;
    return step > 0.0 ? std::clamp(since_last / step, 0.0, 1.0) : 1.0;
  }

 private:
  // Beyond 2^53, after 4.8 million years at 60 Hz, doubles skip numbers: no frame is shown there.
  static std::int64_t number(double frame) {
    return static_cast<std::int64_t>(std::min(frame, 9007199254740992.0));
  }

  double rate_;
  int window_;
  bool begun_ = false;
  double last_ = 0.0;  // [s] before the last step
  double now_ = 0.0;   // [s] after it
  std::int64_t first_ = 0;
  std::int64_t end_ = 0;
};

/// Removes the tracks of bodies that are no longer in the world or no longer movable.
/// \param tracks  each with the `id` of its body; their order is kept
template <class Track>
void forget_removed(const World& world, std::vector<Track>& tracks) {
  std::erase_if(tracks, [&](const Track& track) {
    const std::optional<int> index = world.find(track.id);
    return !index || !world.bodies()[static_cast<std::size_t>(*index)].movable();
  });
}

}  // namespace tumble
