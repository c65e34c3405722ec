/// \file
/// \brief Filters that show a run while it is computed: the same frames as afterwards, and how late
///        (thesis 5.5).
#pragma once

#include "tumble/filtering/pose_filter.hpp"

#include "driver/experiment.hpp"

namespace tumble::chapters {

// The filters that are shown live, with their standard numbers: box:5, box:5,causal, envelope,
// soft_envelope, one_euro.
std::vector<std::unique_ptr<PoseFilter>> live_filters();

// Bits of two lists of frames, counted.
struct BitCount {
  std::int64_t different = 0;  // those that differ
  std::int64_t compared = 0;   // all of them

  // Adds other bits.
  void add(const BitCount& other);
};

// Compares times, steps, ids and states, bit by bit. A frame or a body that only one list has
// differs in all of its bits.
BitCount differing_bits(const Trajectory& a, const Trajectory& b);

// A run that was filtered while it was computed.
struct LiveRun {
  Trajectory computed;           // all frames
  std::vector<Trajectory> live;  // by filter: what was shown in the end
  std::vector<int> held_back;    // by filter: the most frames that were waiting after a step
};

// Computes a run and filters it at the same time.
// duration: [s] of the run
// removal: [s] when the second movable body is taken out of the world; infinity: never
LiveRun play_live(PlayedScene& played, const std::vector<std::unique_ptr<PoseFilter>>& filters,
                  double duration, double removal);

// The poses of the one body of a run as a live viewer sees them.
std::vector<BodyState> seen_live(const Trajectory& run, const PoseFilter& filter);

// A body that moves along x at constant speed.
// speed: [m/s]
Trajectory steady_run(double speed, int frames);

// By how many frames a body is seen late that moves at constant speed: the mean way between the
// computed and the shown pose, over the way of a frame, in the second half of a run.
// speed: [m/s]
// Returns [frames]
double steady_delay(double speed, int frames, const PoseFilter& filter);

// How many frames after a frame can change how it is shown: a pose in the middle of a run at 3 m/s is
// moved by 1 mm, and frames before it are compared bit by bit.
int later_frames_needed(const PoseFilter& filter);

}  // namespace tumble::chapters
