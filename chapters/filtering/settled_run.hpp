/// \file
/// \brief The settled clump of figure 6.7, recorded and measured (thesis 5.5).
#pragma once

#include "tumble/contact/tolerances.hpp"
#include "tumble/dynamics/step_report.hpp"
#include "tumble/dynamics/trajectory.hpp"
#include "tumble/filtering/chatter_detector.hpp"
#include "tumble/filtering/corner_motion.hpp"
#include "tumble/record/chatter.hpp"

#include "driver/experiment.hpp"

namespace tumble::chapters {

// A run that was recorded at 60 frames a second, the start included.
struct SettledRun {
  World world;                             // in the end
  Trajectory frames;                       // all of them
  std::vector<std::vector<char>> touches;  // by frame and index: whether the body is in contact
  std::vector<StepReport> reports;         // by step, one fewer than there are frames
  int first = 0;                           // the first frame in which bodies should rest

  // All steps added up.
  [[nodiscard]] StepReport work() const {
    StepReport sum;
    for (const StepReport& report : reports) add_report(report, sum);
    return sum;
  }
};

// Marks the bodies in contact, by index.
using MarkTouches = std::function<void(const World& world, std::vector<char>& touches)>;

// Plays a scene on and records it; one that has been recorded so far goes on.
// time: [s] the end
inline void record_until(double time, PlayedScene& played, const MarkTouches& touches,
                         SettledRun& run) {
  const auto record = [&] {
    run.frames.record(played.world());
    touches(played.world(), run.touches.emplace_back());
  };
  if (run.touches.empty()) record();
  played.advance(time, [&](const StepReport& report) {
    record();
    run.reports.push_back(report);
  });
  run.world = played.world();
}

// Records what touches by the contacts of the last step.
inline void record_contacts_until(double time, PlayedScene& played, SettledRun& run) {
  record_until(
      time, played,
      [&](const World& world, std::vector<char>& touches) {
        mark_contacts(world, played.technique().contacts(), touches);
      },
      run);
}

// Plays a scene of 60 steps a second and records it.
// settling: [s] before bodies should rest
// watched: [s] after that, a multiple of half a second
inline SettledRun settle_scene(const Scene& scene, const PlayedTechnique& played, double settling,
                               double watched, std::uint64_t seed = 1) {
  PlayedScene now(scene, played, seed);
  SettledRun run;
  record_contacts_until(settling + watched, now, run);
  run.first = static_cast<int>(std::lround(settling / kStep));
  return run;
}

// The cubes of figure 6.7 at their start.
inline Scene clump_scene(int per_edge, std::uint64_t seed = 1) {
  return make_scene("fig6_7", {"per_edge=" + std::to_string(per_edge)}, seed);
}

// The first frames of a run.
inline SettledRun first_part(const SettledRun& run, int frames) {
  SettledRun part{run.world, {}, run.touches, run.reports, run.first};
  for (int k = 0; k < frames; ++k) part.frames.record(run.frames.frame(k));
  part.touches.resize(idx(frames));
  part.reports.resize(idx(frames - 1));
  return part;
}

// The clump under `damped`. Several figures ask for the same run, or for its beginning, so what the program has
// run once it keeps, and goes on from there.
inline SettledRun damped_clump(int per_edge, std::uint64_t seed, double settling, double watched) {
  struct Kept {
    std::unique_ptr<PlayedScene> played;
    SettledRun run;
  };
  static std::map<std::pair<int, std::uint64_t>, Kept> kept;
  Kept& clump = kept[{per_edge, seed}];
  if (!clump.played)
    clump.played =
        std::make_unique<PlayedScene>(clump_scene(per_edge, seed), PlayedTechnique{"damped"}, seed);
  record_contacts_until(settling + watched, *clump.played, clump.run);
  SettledRun part =
      first_part(clump.run, 1 + static_cast<int>(std::lround((settling + watched) / kStep)));
  part.first = static_cast<int>(std::lround(settling / kStep));
  return part;
}

// Lets the cubes of figure 6.7 fly together and settle, and records them.
// afterwards: [s] for which the run goes on
inline SettledRun settle_clump(const Parameters& settings, int seed,
                               const PlayedTechnique& technique = {"damped", {}},
                               double afterwards = 0.0) {
  const auto chance = static_cast<std::uint64_t>(seed);
  const int per_edge = settings.count("per_edge");
  const double settling = settings.number("settling");
  const double watched = settings.number("watched") + afterwards;
  if (technique.name == "damped" && technique.settings.empty())
    return damped_clump(per_edge, chance, settling, watched);
  return settle_scene(clump_scene(per_edge, chance), technique, settling, watched, chance);
}

// Finds the one body that moves, of worlds with one.
inline std::size_t first_movable(const World& world) {
  std::size_t index = 0;
  while (!world.bodies()[index].movable()) ++index;
  return index;
}

// The corners of a body in the part of a run in which it should rest.
inline std::vector<Corners> settled_path(const SettledRun& run, const Trajectory& frames,
                                         std::size_t index) {
  std::vector<Corners> path;
  for (int k = run.first; k < frames.count(); ++k)
    path.push_back(corners_of(box_of(run.world.bodies()[index], frames.frame(k).states[index])));
  return path;
}

// How a body shakes that rests: means over the half seconds of a path, and its squirm.
struct Shake {
  double amplitude = 0.0;     // [m] largest distance between two places of a corner
  double acceleration = 0.0;  // [-] root mean square second difference, over g Δt²
  double squirm = 0.0;        // [m/s] see squirm()
};

inline constexpr std::size_t kWindow = ChatterMeter::kWindow;

// A path as half seconds that share their ends.
inline std::vector<std::span<const Corners>> half_seconds(const std::vector<Corners>& path) {
  std::vector<std::span<const Corners>> parts;
  for (std::size_t begin = 0; begin + kWindow <= path.size(); begin += kWindow - 1)
    parts.push_back(std::span(path).subspan(begin, kWindow));
  return parts;
}

// Measures a path, half second by half second (ChatterMeter::kWindow frames, ends shared).
// gravity: [m/s²] that accelerations are divided by
inline Shake shake_of(const std::vector<Corners>& path, double gravity) {
  Shake shake;
  const auto parts = half_seconds(path);
  for (const std::span<const Corners> part : parts) {
    shake.amplitude += largest_excursion(part);
    shake.acceleration += rms_second_difference(part) / (gravity * kStep * kStep);
  }
  const double count = static_cast<double>(parts.size());
  shake.amplitude /= count;
  shake.acceleration /= count;
  shake.squirm = squirm(path, kStep);
  return shake;
}

// Measures how a body shakes, as computed, in the part of a run in which it should rest.
inline Shake settled_shake(const SettledRun& run, std::size_t index) {
  return shake_of(settled_path(run, run.frames, index), run.world.gravity_w.norm());
}

// Whether two poses are the same, bit by bit.
inline bool same_pose(const BodyState& a, const BodyState& b) {
  return a.position_w == b.position_w && a.orientation_wb.coeffs() == b.orientation_wb.coeffs();
}

// Bodies that rest in the watched part, as ChatterMeter says: in every frame in contact, and in each
// half second with less than a hundredth of the shortest edge as net movement of every corner.
inline std::vector<std::size_t> resting_bodies(const SettledRun& run) {
  std::vector<std::size_t> resting;
  for (std::size_t k = 0; k < run.world.bodies().size(); ++k) {
    const BodyProperties& body = run.world.bodies()[k];
    if (!body.movable()) continue;
    bool rests = true;
    for (std::size_t f = static_cast<std::size_t>(run.first); f < run.touches.size(); ++f)
      rests = rests && run.touches[f][k] != 0;
    const std::vector<Corners> path = settled_path(run, run.frames, k);
    for (const std::span<const Corners> part : half_seconds(path))
      rests = rests && largest_displacement(part.front(), part.back()) <
                           tolerance::resting_movement * body.size.minCoeff();
    if (rests) resting.push_back(k);
  }
  return resting;
}

// [-] Amplitude over the shortest edge from which on a body that rests chatters; claim 6.1b.
inline constexpr double kChatters = 1e-3;

// Of these, the ones whose amplitude is kChatters of the shortest edge or more.
inline std::vector<std::size_t> chattering_bodies(const SettledRun& run) {
  std::vector<std::size_t> chattering;
  for (const std::size_t k : resting_bodies(run))
    if (settled_shake(run, k).amplitude >= kChatters * run.world.bodies()[k].size.minCoeff())
      chattering.push_back(k);
  return chattering;
}

}  // namespace tumble::chapters
