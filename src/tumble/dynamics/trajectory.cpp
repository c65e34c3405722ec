/// \file
/// \brief The record of a run: its states.
#include "tumble/dynamics/trajectory.hpp"

#include "tumble/base/error.hpp"

#include <algorithm>
#include <string>

namespace tumble {

void Trajectory::record(const Frame& frame) {
  frames_.push_back(Entry{frame.time, frame.step, states_.size(), frame.states.size()});
  ids_.insert(ids_.end(), frame.ids.begin(), frame.ids.end());
  states_.insert(states_.end(), frame.states.begin(), frame.states.end());
}

Frame Trajectory::frame(int index) const {
  if (index < 0 || index >= count())
    refuse("frame " + std::to_string(index) + ": there are " + std::to_string(count()) +
           ", counted from 0");
  const Entry& entry = frames_[static_cast<std::size_t>(index)];
  return Frame{entry.time, entry.step, std::span(ids_).subspan(entry.first, entry.count),
               std::span(states_).subspan(entry.first, entry.count)};
}

std::optional<BodyState> Trajectory::state(int index, BodyId id) const {
  const Frame bodies = frame(index);
  const auto place = std::lower_bound(bodies.ids.begin(), bodies.ids.end(), id);
  if (place == bodies.ids.end() || *place != id) return std::nullopt;
  return bodies.states[static_cast<std::size_t>(place - bodies.ids.begin())];
}

std::vector<Sample> Trajectory::samples(BodyId id) const {
  std::vector<Sample> out;
  for (int i = 0; i < count(); ++i) {
    const std::optional<BodyState> at_frame = state(i, id);
    if (at_frame) out.push_back(Sample{frame(i).time, *at_frame});
  }
  return out;
}

TrajectoryRecorder::TrajectoryRecorder(const World& world, int every) : every_(every) {
  require::that(every >= 1, "every = " + std::to_string(every) + ": expected at least 1");
  trajectory_.record(world);
}

void TrajectoryRecorder::on_step(const World& world, const StepReport& report) {
  (void)report;
  if (++since_last_ < every_) return;
  since_last_ = 0;
  trajectory_.record(world);
}

}  // namespace tumble
