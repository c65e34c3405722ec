/// \file
/// \brief The record of a run: its states and collisions.
#pragma once

#include "tumble/dynamics/technique.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace tumble {

/// All bodies at one recorded time; valid until the trajectory records again.
struct Frame {
  double time = 0.0;                  ///< [s] simulated since the world was made
  std::int64_t step = 0;              ///< steps since then
  std::span<const BodyId> ids;        ///< the bodies that there were, ascending
  std::span<const BodyState> states;  ///< their states, in the same order
};

/// The bodies of a world as a frame; valid until the world changes.
[[nodiscard]] inline Frame frame_of(const World& world) {
  return Frame{world.time(), world.steps(), world.ids(), world.states()};
}

/// One body at one recorded time.
struct Sample {
  double time = 0.0;  ///< [s]
  BodyState state;    ///< its state then
};

/// Recorded states. Bodies may come and go between frames: every frame has its own ids.
class Trajectory {
 public:
  /// Adds a frame.
  /// \param world all its bodies are recorded, the immovable ones too
  void record(const World& world) { record(frame_of(world)); }

  /// Adds a frame.
  /// \param frame  copied; not of this trajectory
  void record(const Frame& frame);

  /// How many frames there are.
  [[nodiscard]] int count() const { return static_cast<int>(frames_.size()); }

  /// One frame.
  /// \param index 0 to count() - 1
  /// \throws std::invalid_argument for another index
  [[nodiscard]] Frame frame(int index) const;

  /// One body in one frame.
  /// \return its state, or nothing if it was not there. O(log n)
  /// \throws std::invalid_argument for an index that is no frame
  [[nodiscard]] std::optional<BodyState> state(int index, BodyId id) const;

  /// One body over time: its states in all frames that have it, in order of time; empty if there is none.
  [[nodiscard]] std::vector<Sample> samples(BodyId id) const;

 private:
  struct Entry {
    double time = 0.0;
    std::int64_t step = 0;
    std::size_t first = 0;  // where its bodies begin in the arrays below
    std::size_t count = 0;
  };

  std::vector<Entry> frames_;
  std::vector<BodyId> ids_;
  std::vector<BodyState> states_;
};

/// Records the start and every n-th step of a run.
class TrajectoryRecorder : public Observer {
 public:
  /// Records the start.
  /// \param every  record every so many steps, at least 1
  /// \throws std::invalid_argument if `every` is below 1
  explicit TrajectoryRecorder(const World& world, int every = 1);

  void on_step(const World& world, const StepReport& report) override;

  /// What has been recorded: the start and every n-th step since.
  [[nodiscard]] const Trajectory& trajectory() const { return trajectory_; }

 private:
  Trajectory trajectory_;
  int every_;
  int since_last_ = 0;
};

/// Records every collision.
class EventRecorder : public Observer {
 public:
  void on_event(const Event& event) override { events_.push_back(event); }

  /// What has been recorded, in the order in which collisions were resolved.
  [[nodiscard]] const EventLog& events() const { return events_; }

 private:
  EventLog events_;
};

}  // namespace tumble
