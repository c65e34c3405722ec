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
  [[nodiscard]] std::vector<Corners> path(const Trajectory& frames, std::size_t index) const;

  // How each of the bodies shakes.
  [[nodiscard]] std::vector<Shake> shakes(const Trajectory& frames) const;
};

// Lets a clump settle and looks for what chatters.
ChatteringClump chattering_clump(const Parameters& settings, int seed);

// The median of each number of some bodies.
Shake median_shake(const std::vector<Shake>& shakes);

// The settings of a figure on box filters.
Parameters chattering_clump_parameters();

// By what boxes of two widths change the squirm of noise that is the same at all frequencies.
//
// Squirm is the root mean square of a sum of samples with fixed weights, and so is squirm after a
// box filter; for white noise both are as the root of the sum of the squares of the weights.
// Returns [-] squirm under the one over that under the other
Quantity squirm_of_white_noise(std::string name, int frames, int before);

}  // namespace tumble::chapters
