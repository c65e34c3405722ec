/// \file
/// \brief Filters that show a run while it is computed: the same frames as afterwards, and how late
///        (thesis 5.5).
#pragma once

#include "tumble/filtering/filters.hpp"
#include "tumble/filtering/pose_filter.hpp"

#include "driver/experiment.hpp"

#include <bit>

namespace tumble::chapters {

// The filters that are shown live, with their standard numbers: box:5, box:5,causal, envelope,
// soft_envelope, one_euro.
inline std::vector<std::unique_ptr<PoseFilter>> live_filters() {
  std::vector<std::unique_ptr<PoseFilter>> filters;
  for (const char* text : {"box:5", "box:5,causal", "envelope", "soft_envelope", "one_euro"})
    filters.push_back(filter_of(text));
  return filters;
}

// Bits of two lists of frames, counted.
struct BitCount {
  std::int64_t different = 0;  // those that differ
  std::int64_t compared = 0;   // all of them

  // Adds other bits.
  void add(const BitCount& other) {
    different += other.different;
    compared += other.compared;
  }
};

inline constexpr int kMoved = 30;         // the frame whose pose is changed
inline constexpr int kMovedFrames = 61;   // of the run around it
inline constexpr double kMovedBy = 1e-3;  // [m]
// [m/s] Five envelopes a frame, so that no filter stands still.
inline constexpr double kMovedFast = 3.0;

using Words = std::vector<std::uint64_t>;

inline void add_words(const BodyState& state, Words& words) {
  const Quat& q = state.orientation_wb;
  for (const double value : {q.w(), q.x(), q.y(), q.z()})
    words.push_back(std::bit_cast<std::uint64_t>(value));
  for (const Vec3& v : {state.position_w, state.linear_momentum_w, state.angular_momentum_w})
    for (int k = 0; k < 3; ++k) words.push_back(std::bit_cast<std::uint64_t>(v[k]));
}

inline Words words_of(const Frame& frame) {
  Words words = {std::bit_cast<std::uint64_t>(frame.time), static_cast<std::uint64_t>(frame.step)};
  for (std::size_t k = 0; k < frame.ids.size(); ++k) {
    words.push_back(number_of(frame.ids[k]));
    add_words(frame.states[k], words);
  }
  return words;
}

// Takes away the second body that moves.
inline void remove_one(World& world) {
  int movable = 0;
  for (std::size_t k = 0; k < world.bodies().size(); ++k)
    if (world.bodies()[k].movable() && ++movable == 2) return world.remove(world.ids()[k]);
}

// Compares times, steps, ids and states, bit by bit. A frame or a body that only one list has
// differs in all of its bits.
inline BitCount differing_bits(const Trajectory& a, const Trajectory& b) {
  constexpr std::int64_t bits = 64;
  BitCount out;
  for (int f = 0; f < std::max(a.count(), b.count()); ++f) {
    const Words first = f < a.count() ? words_of(a.frame(f)) : Words();
    const Words second = f < b.count() ? words_of(b.frame(f)) : Words();
    const std::size_t both = std::min(first.size(), second.size());
    const std::size_t all = std::max(first.size(), second.size());
    for (std::size_t k = 0; k < both; ++k) out.different += std::popcount(first[k] ^ second[k]);
    out.different += bits * static_cast<std::int64_t>(all - both);
    out.compared += bits * static_cast<std::int64_t>(all);
  }
  return out;
}

// A run that was filtered while it was computed.
struct LiveRun {
  Trajectory computed;           // all frames
  std::vector<Trajectory> live;  // by filter: what was shown in the end
  std::vector<int> held_back;    // by filter: the most frames that were waiting after a step
};

// Computes a run and filters it at the same time.
// duration: [s] of the run
// removal: [s] when the second movable body is taken out of the world; infinity: never
inline LiveRun play_live(PlayedScene& played,
                         const std::vector<std::unique_ptr<PoseFilter>>& filters, double duration,
                         double removal) {
  LiveRun run;
  std::vector<FilteringObserver> viewers;
  for (const auto& filter : filters) viewers.emplace_back(played.world(), *filter);
  run.computed.record(played.world());
  run.held_back.assign(filters.size(), 0);
  played.advance(duration, [&](const StepReport& report) {
    if (played.world().time() > removal) {
      remove_one(played.world());
      removal = std::numeric_limits<double>::infinity();
    }
    run.computed.record(played.world());
    for (std::size_t k = 0; k < viewers.size(); ++k) {
      viewers[k].on_step(played.world(), report);
      run.held_back[k] =
          std::max(run.held_back[k], run.computed.count() - viewers[k].shown().count());
    }
  });
  for (FilteringObserver& viewer : viewers) {
    viewer.finish();
    run.live.push_back(viewer.shown());
  }
  return run;
}

// The poses of the one body of a run as a live viewer sees them.
inline std::vector<BodyState> seen_live(const Trajectory& run, const PoseFilter& filter) {
  std::vector<BodyState> seen;
  BodyState newest = run.frame(0).states.front();
  const std::unique_ptr<PoseFilter> own = filter.clone();
  for (int k = 0; k < run.count(); ++k) {
    own->add(run.frame(k), [&](const Frame& frame) { newest = frame.states.front(); });
    seen.push_back(newest);
  }
  return seen;
}

// A body that moves along x at constant speed.
// speed: [m/s]
inline Trajectory steady_run(double speed, int frames) {
  Trajectory run;
  const std::array<BodyId, 1> ids = {BodyId{0}};
  std::array<BodyState, 1> states;
  for (int k = 0; k < frames; ++k) {
    const double time = k * kStep;
    states[0].position_w.x() = speed * time;
    run.record(Frame{time, k, ids, states});
  }
  return run;
}

// By how many frames a body is seen late that moves at constant speed: the mean way between the
// computed and the shown pose, over the way of a frame, in the second half of a run.
// speed: [m/s]
// Returns [frames]
inline double steady_delay(double speed, int frames, const PoseFilter& filter) {
  const Trajectory run = steady_run(speed, frames);
  const std::vector<BodyState> seen = seen_live(run, filter);
  double sum = 0.0;
  for (int k = frames / 2; k < frames; ++k)
    sum += (run.frame(k).states[0].position_w - seen[idx(k)].position_w).x();
  return sum / ((frames - frames / 2) * speed * kStep);
}

// How many frames after a frame can change how it is shown: a pose in the middle of a run at 3 m/s is
// moved by 1 mm, and frames before it are compared bit by bit.
inline int later_frames_needed(const PoseFilter& filter) {
  const Trajectory run = steady_run(kMovedFast, kMovedFrames);
  Trajectory moved;
  for (int k = 0; k < run.count(); ++k) {
    const Frame frame = run.frame(k);
    std::array<BodyState, 1> states = {frame.states[0]};
    if (k == kMoved) states[0].position_w.y() += kMovedBy;
    moved.record(Frame{frame.time, frame.step, frame.ids, states});
  }
  const Trajectory shown = filtered(run, filter);
  const Trajectory shown_moved = filtered(moved, filter);
  for (int k = 0; k < kMoved; ++k)
    if (!(shown.frame(k).states[0] == shown_moved.frame(k).states[0])) return kMoved - k;
  return 0;
}

}  // namespace tumble::chapters
