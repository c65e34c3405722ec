/// \file
/// \brief The settled clump as a filter shows it: medians over the bodies that chatter, and overlap
///        (thesis 5.5).
#pragma once

#include "tumble/filtering/pose_filter.hpp"
#include "tumble/geometry/broad_phase.hpp"

#include "driver/experiment.hpp"
#include "filtering/settled_run.hpp"

namespace tumble::chapters {

// A settled clump and what chatters in it.
//
// The run goes on for half a second after the watched part, so that a filter has later frames to
// look at and no window is cut within it.
struct ChatteringClump {
  SettledRun run;                   // recorded, with the half second
  std::vector<std::size_t> bodies;  // indices of those that chatter
  std::size_t watched = 0;          // frames from run.first on that are measured

  // A body's corners in the watched part.
  [[nodiscard]] std::vector<Corners> path(const Trajectory& frames, std::size_t index) const {
    std::vector<Corners> corners = settled_path(run, frames, index);
    corners.resize(watched);
    return corners;
  }

  // How each of the bodies shakes.
  [[nodiscard]] std::vector<Shake> shakes(const Trajectory& frames) const {
    const double gravity = run.world.gravity_w.norm();
    std::vector<Shake> out;
    for (const std::size_t index : bodies) out.push_back(shake_of(path(frames, index), gravity));
    return out;
  }
};

inline constexpr double kAfterwards = 0.5;  // [s] more than half of the widest window, 15 frames

// The sum of squares of the weights with which samples enter a slope after a box filter.
inline double weight_of(int frames) {
  constexpr int kReach = kSquirmFrames / 2;
  double sum = 0.0;
  for (int n = -kReach - frames / 2; n <= kReach + frames / 2; ++n) {
    double weight = 0.0;
    for (int k = -(frames / 2); k <= frames / 2; ++k)
      if (std::abs(n - k) <= kReach) weight += static_cast<double>(n - k) / frames;
    sum += weight * weight;
  }
  return sum;
}

// Lets a clump settle and looks for what chatters.
inline ChatteringClump chattering_clump(const Parameters& settings, int seed) {
  ChatteringClump clump{
      .run = settle_clump(settings, seed, {"damped", {}}, kAfterwards),
      .watched = static_cast<std::size_t>(std::lround(settings.number("watched") / kStep)) + 1};
  clump.bodies = chattering_bodies(clump.run);
  if (clump.bodies.empty())
    throw std::runtime_error("nothing chatters in the clump of seed " + std::to_string(seed) +
                             ", so there is nothing to filter");
  return clump;
}

// The median of each number of some bodies.
inline Shake median_shake(const std::vector<Shake>& shakes) {
  const auto median = [&](double Shake::*number) { return median_of(numbers_of(shakes, number)); };
  return {median(&Shake::amplitude), median(&Shake::acceleration), median(&Shake::squirm)};
}

// The settings of a figure on box filters.
inline Parameters chattering_clump_parameters() {
  return {whole("seeds", 8, 2, 1000, "clumps"),
          whole("per_edge", 5, 2, 8, "cubes along each edge of the grid at the start"),
          number("settling", 10.0, 1.0, 1000.0, "s", "before bodies should rest"),
          number("watched", 4.0, 0.5, 1000.0, "s", "after that, a multiple of 0.5")};
}

// By what boxes of two widths change the squirm of noise that is the same at all frequencies.
//
// Squirm is the root mean square of a sum of samples with fixed weights, and so is squirm after a
// box filter; for white noise both are as the root of the sum of the squares of the weights.
// Returns [-] squirm under the one over that under the other
inline Quantity squirm_of_white_noise(std::string name, int frames, int before) {
  return {std::move(name), "-", std::sqrt(weight_of(frames) / weight_of(before))};
}

}  // namespace tumble::chapters
