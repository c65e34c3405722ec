/// \file
/// \brief Which frames of a display lie between two steps of a run (thesis 5.5).
#pragma once

#include "tumble/dynamics/world.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace tumble {

/// Frames at multiples of a fixed time, whatever the time step is.
///
/// Frame n is shown at n over the rate. A step that ends by tolerance::frame_slack of a frame before it
/// still shows it. Between two steps things are where the straight line is.
class DisplayFrames {
 public:
  /// Before the first step.
  /// \param rate    [1/s] frames per second
  /// \param window  how many frames are in sight; of a step over more, only the last ones are taken
  DisplayFrames(double rate, int window) : rate_(rate), window_(window) {}

  /// Goes on by a step; the first call shows at most the frame at its own time.
  /// \param now [s] the time after the step, not before that of the step before
  void go_on(double now);

  /// Whether there has been a step, or a start.
  /// \return false until go_on() is called
  [[nodiscard]] bool begun() const { return begun_; }
  /// The time after the last step.
  /// \return [s]
  [[nodiscard]] double now() const { return now_; }
  /// The first frame of the last step that is in sight.
  /// \return end() if the step shows none
  [[nodiscard]] std::int64_t first() const { return first_; }
  /// The first frame that has not been shown yet.
  /// \return one more than the last one shown
  [[nodiscard]] std::int64_t end() const { return end_; }
  /// The first frame at a time or after it.
  /// \param time [s]
  /// \return its number
  [[nodiscard]] std::int64_t frame_from(double time) const;
  /// Where a frame lies within the last step.
  /// \param frame first() to end() - 1
  /// \return [-] share of the step that is over by then, 0 to 1
  [[nodiscard]] double share(std::int64_t frame) const;

 private:
  double rate_;
  int window_;
  bool begun_ = false;
  double last_ = 0.0;  // [s] before the last step
  double now_ = 0.0;   // [s] after it
  std::int64_t first_ = 0;
  std::int64_t end_ = 0;
};

/// Forgets the bodies that are no more, or do not move any more.
/// \param world   the bodies
/// \param tracks  what is known of each, with its `id`; their order is kept
template <class Track>
void forget_removed(const World& world, std::vector<Track>& tracks) {
  std::erase_if(tracks, [&](const Track& track) {
    const std::optional<int> index = world.find(track.id);
    return !index || !world.bodies()[static_cast<std::size_t>(*index)].movable();
  });
}

}  // namespace tumble
