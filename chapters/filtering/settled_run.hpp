/// \file
/// \brief The settled clump of figure 6.7, recorded and measured (thesis 5.5).
#pragma once

#include "tumble/dynamics/trajectory.hpp"
#include "tumble/filtering/corner_motion.hpp"

#include "driver/experiment.hpp"

namespace tumble::chapters {

// A run that was recorded at 60 frames a second, the start included.
struct SettledRun {
  World world;                             // in the end
  Trajectory frames;                       // all of them
  std::vector<std::vector<char>> touches;  // by frame and index: whether the body is in contact
  int first = 0;                           // the first frame in which bodies should rest
};

// Marks the bodies in contact, by index.
using MarkTouches = std::function<void(const World& world, std::vector<char>& touches)>;

// Plays a scene on and records it.
// settling: [s] before bodies should rest
// watched: [s] after that
SettledRun record_run(PlayedScene& played, double settling, double watched,
                      const MarkTouches& touches,
                      const std::function<void(const StepReport&)>& after = {});

// Plays a scene of 60 steps a second and records it.
// settling: [s] before bodies should rest
// watched: [s] after that, a multiple of half a second
SettledRun settle_scene(const Scene& scene, const PlayedTechnique& played, double settling,
                        double watched, std::uint64_t seed = 1);

// The cubes of figure 6.7 at their start.
Scene clump_scene(int per_edge, std::uint64_t seed = 1);

// Lets the cubes of figure 6.7 fly together and settle, and records them.
// afterwards: [s] for which the run goes on
SettledRun settle_clump(const Parameters& settings, int seed,
                        const PlayedTechnique& technique = {"damped", {}}, double afterwards = 0.0);

// Finds the one body that moves, of worlds with one.
std::size_t first_movable(const World& world);

// The corners of a body in the part of a run in which it should rest.
std::vector<Corners> settled_path(const SettledRun& run, const Trajectory& frames,
                                  std::size_t index);

// How a body shakes that rests: means over the half seconds of a path, and its squirm.
struct Shake {
  double amplitude = 0.0;     // [m] largest distance between two places of a corner
  double acceleration = 0.0;  // [-] root mean square second difference, over g Δt²
  double squirm = 0.0;        // [m/s] see squirm()
};

// Measures a path, half second by half second (ChatterMeter::kWindow frames, ends shared).
// gravity: [m/s²] that accelerations are divided by
Shake shake_of(const std::vector<Corners>& path, double gravity);

// Measures how a body shakes, as computed, in the part of a run in which it should rest.
Shake settled_shake(const SettledRun& run, std::size_t index);

// Whether two poses are the same, bit by bit.
bool same_pose(const BodyState& a, const BodyState& b);

// Bodies that rest in the watched part, as ChatterMeter says: in every frame in contact, and in each
// half second with less than a hundredth of the shortest edge as net movement of every corner.
std::vector<std::size_t> resting_bodies(const SettledRun& run);

// [-] Amplitude over the shortest edge from which on a body that rests chatters; claim 6.1b.
inline constexpr double kChatters = 1e-3;

// Of these, the ones whose amplitude is kChatters of the shortest edge or more.
std::vector<std::size_t> chattering_bodies(const SettledRun& run);

}  // namespace tumble::chapters
