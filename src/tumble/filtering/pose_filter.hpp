/// \file
/// \brief Filters that change what is shown of a run, and never the run (thesis 5.5).
///
/// Of the chapters this one is built on none: it sees frames only.
#pragma once

#include "tumble/dynamics/trajectory.hpp"

#include <functional>
#include <memory>
#include <string>

namespace tumble {

/// Takes frames as they come to be shown; what a frame points to is valid during the call only.
using FrameSink = std::function<void(const Frame&)>;

/// Changes the poses that are shown of a run.
///
/// A filter takes in frames as they are computed and shows as many frames, in the same order, with
/// the same times, bodies and momenta: only positions and orientations differ. Some frames may be
/// held back until later ones are known; latency() says how many. Memory is bounded, and what is
/// shown depends on the frames alone: whole runs, pieces of them and frames that come in live give
/// the same bits. Each body is filtered by itself, from the frame it comes in to the one it leaves
/// with, so a body that comes back is a new one.
class PoseFilter {
 public:
  virtual ~PoseFilter() = default;

  /// Takes in the next frame.
  /// \param frame  all bodies at one time; after the frame before
  /// \param show   told about the frames that can be shown now, oldest first
  /// \throws std::invalid_argument naming frame and body: a state that is not finite, a quaternion
  ///         that is not of length 1, ids that do not ascend, a time not after the one before, a
  ///         spacing that the filter cannot use. The filter is then as before
  void add(const Frame& frame, const FrameSink& show);

  /// The run is over: shows what was held back and forgets everything, ready for another run.
  /// \param show told about the frames that are left, oldest first
  void finish(const FrameSink& show);

  /// How many frames a frame is held back until it can be shown.
  /// \return 0 for a filter that shows each frame at once
  [[nodiscard]] virtual int latency() const { return 0; }

  /// The filter as a user writes it, see filter_of().
  /// \return for example "box:5"
  [[nodiscard]] virtual std::string text() const = 0;

  /// A copy with all memory.
  /// \return goes on exactly like this one
  [[nodiscard]] virtual std::unique_ptr<PoseFilter> clone() const = 0;

 protected:
  PoseFilter() = default;
  /// For clone().
  /// \param other the original
  PoseFilter(const PoseFilter& other) = default;
  /// For clone().
  /// \param other the original
  /// \return this
  PoseFilter& operator=(const PoseFilter& other) = default;

  /// How a message names the next frame.
  /// \param frame  what add() was given
  /// \return for example "frame 3 at 0.05 s", counted from 0
  [[nodiscard]] std::string where(const Frame& frame) const;

 private:
  // What add() does with a frame that is in order; throws only for its spacing, before any change.
  virtual void take(const Frame& frame, const FrameSink& show) = 0;
  // Shows the rest and forgets all frames.
  virtual void end(const FrameSink& show) = 0;

  std::int64_t taken_ = 0;  // frames since the run began
  double last_time_ = 0.0;  // [s] of the last of them
};

/// Filters a recorded run.
/// \param run     its frames, any number
/// \param filter  how; a fresh copy is used, so the filter itself stays as it is
/// \return as many frames
/// \throws std::invalid_argument as PoseFilter::add()
Trajectory filtered(const Trajectory& run, const PoseFilter& filter);

/// Filters a run while it is computed.
class FilteringObserver : public Observer {
 public:
  /// Takes in the start.
  /// \param world   the bodies before the first step
  /// \param filter  how; a copy is used
  /// \param every   take in every so many steps, at least 1
  /// \throws std::invalid_argument if `every` is below 1, or as PoseFilter::add()
  FilteringObserver(const World& world, const PoseFilter& filter, int every = 1);

  /// Takes in the world after a step.
  /// \param world   the bodies
  /// \param report  not used
  /// \throws std::invalid_argument as PoseFilter::add()
  void on_step(const World& world, const StepReport& report) override;

  /// The run is over: the frames that were held back are shown too.
  void finish();

  /// What can be shown by now.
  /// \return the frames so far, latency() fewer than were taken in before finish()
  [[nodiscard]] const Trajectory& shown() const { return shown_; }

 private:
  void take_in(const World& world);

  std::unique_ptr<PoseFilter> filter_;
  Trajectory shown_;
  int every_;
  int since_last_ = 0;
};

}  // namespace tumble
