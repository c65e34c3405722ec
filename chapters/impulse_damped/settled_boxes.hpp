/// \file
/// \brief Boxes that settle under damped integration, seen as a viewer sees them (thesis 5.3).
#pragma once

#include "tumble/impulse_damped/damped.hpp"

#include "driver/experiment.hpp"

namespace tumble::chapters {

// How a box ends a run; its last half second, seen on frames of 1/60 s.
struct BoxEnd {
  bool rests = false;      // it touches others all the time and gets nowhere: see ChatterMeter
  double shake = 0.0;      // [-] of a box that rests: its acceleration, see Chatter
  double rest_time = 0.0;  // [s] when one of its corners last moved by more than a little
  bool on_face = false;    // a face of it has lain on another body; otherwise it leans
  double tilt = 0.0;       // [rad] between the vertical and its nearest axis
  bool aligned = false;    // what the alignment test says, with its ε2

  // Whether it chatters: it rests, but shakes by more than a tenth of free fall.
  [[nodiscard]] bool chatters() const;
};

// Runs a world under damped integration with steps of 1/60 s.
// duration: [s] at least a second
// \par Cost
// That of the steps; contacts are looked for again in the last half second.
std::vector<BoxEnd> settle(World world, const DampedOptions& options, double duration);

// Figure 6.7 with few cubes, 1.75 m from centre to centre, so that they meet soon.
World clump(int per_edge, int seed);

// The scene `leaning` at a random angle of 50 to 75 degrees: three planks, each on its block.
//
// Damped integration has no friction, so a kerb keeps each plank's foot from sliding away, and a
// wall each block.
World propped_planks(int seed);

}  // namespace tumble::chapters
