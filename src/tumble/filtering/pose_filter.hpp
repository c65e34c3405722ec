/// \file
/// \brief Filters of displayed poses, which never change the simulation (thesis 5.5).
///
/// This chapter is built on no other: it uses frames only.
#pragma once

#include "tumble/dynamics/trajectory.hpp"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace tumble {

/// Receives frames to display; the data that a frame points to is valid during the call only.
using FrameSink = std::function<void(const Frame&)>;

/// Base of filters for the displayed poses of a run.
///
/// A filter takes in computed frames and displays as many frames, in the same order, with the same times,
/// bodies and momenta: only positions and orientations differ. Some frames may be held back until
/// later ones are known, at most latency(). Memory is bounded, and the result depends on the frames
/// alone: whole runs, parts of them and live frames give the same bits. Each body is filtered on its
/// own, from its first frame to its last; a body that comes back counts as new.
class PoseFilter {
 public:
  virtual ~PoseFilter() = default;

  /// Adds the next frame.
  /// \param frame  all bodies at one time; after the frame before
  /// \param show   receives the frames that can be displayed now, oldest first
  /// \throws std::invalid_argument naming frame and body: a state that is not finite, a quaternion
  ///         that is not of length 1, ids that do not ascend, a time not after the one before, a
  ///         spacing that the filter cannot use. The filter is then unchanged
  void add(const Frame& frame, const FrameSink& show);

  /// Ends the run: displays the frames held back and clears the memory, ready for another run.
  /// \param show receives the remaining frames, oldest first
  void finish(const FrameSink& show);

  /// Number of frames by which display is delayed; 0 for a filter that displays each frame at once.
  [[nodiscard]] virtual int latency() const { return 0; }

  /// The text form of the filter, see filter_of(), for example "box:5".
  [[nodiscard]] virtual std::string text() const = 0;

  /// A copy with all memory: behaves exactly like this one.
  [[nodiscard]] virtual std::unique_ptr<PoseFilter> clone() const = 0;

 protected:
  PoseFilter() = default;
  /// For clone().
  PoseFilter(const PoseFilter& other) = default;
  /// For clone().
  PoseFilter& operator=(const PoseFilter& other) = default;

  /// Name of the next frame in messages, for example "frame 3 at 0.05 s", counted from 0.
  [[nodiscard]] std::string where(const Frame& frame) const;

 private:
  // Processes a valid frame for add(); throws only for its spacing, before any change.
  virtual void take(const Frame& frame, const FrameSink& show) = 0;
  // Displays the remaining frames and clears the memory.
  virtual void end(const FrameSink& show) = 0;

  std::int64_t taken_ = 0;  // number of frames in this run
  double last_time_ = 0.0;  // [s] of the last of them
};

/// Filters a recorded run.
/// \param filter  the filter; a fresh copy is used
/// \return as many frames
/// \throws std::invalid_argument as PoseFilter::add()
Trajectory filtered(const Trajectory& run, const PoseFilter& filter);

/// Filters a run while it is computed.
class FilteringObserver : public Observer {
 public:
  /// Adds the start.
  /// \param filter  the filter; a copy is used
  /// \param every   add every n-th step, at least 1
  /// \throws std::invalid_argument if `every` is below 1, or as PoseFilter::add()
  FilteringObserver(const World& world, const PoseFilter& filter, int every = 1);

  /// Adds the world after a step.
  /// \throws std::invalid_argument as PoseFilter::add()
  void on_step(const World& world, const StepReport& report) override;

  /// Ends the run: the frames held back are displayed too.
  void finish();

  /// The frames displayed so far: latency() fewer than were added before finish().
  [[nodiscard]] const Trajectory& shown() const { return shown_; }

 private:
  void take_in(const World& world);

  std::unique_ptr<PoseFilter> filter_;
  Trajectory shown_;
  int every_;
  int since_last_ = 0;
};

/// State of a following filter for one body.
struct FollowedBody {
  BodyId id{};                     ///< the body
  BodyState shown;                 ///< displayed pose; the momenta are not used
  BodyState computed;              ///< computed state in the last frame
  Vec3 velocity_w = Vec3::Zero();  ///< [m/s] smoothed, for filters that use speed; world frame
  Vec3 angular_velocity_w = Vec3::Zero();  ///< [rad/s] the same, world frame
};

/// A filter that keeps a displayed pose for each body and updates it frame by frame.
///
/// The first frame of a body is displayed as computed, and each frame at once: the latency is 0.
class FollowingFilter : public PoseFilter {
 protected:
  FollowingFilter() = default;

 private:
  /// Updates the displayed pose of a body.
  /// \param dt    [s] since the last frame
  /// \param body  `shown` in and out; `computed` is that of the last frame
  virtual void follow(const BodyState& now, double dt, FollowedBody& body) const = 0;

  void take(const Frame& frame, const FrameSink& show) override;
  void end(const FrameSink& show) override;

  std::vector<FollowedBody> bodies_;  // those of the last frame, in its order
  double last_time_ = 0.0;            // [s] of the last frame
  std::vector<FollowedBody> next_;    // storage
  std::vector<BodyState> states_;     // storage
};

}  // namespace tumble
