/// \file
/// \brief A cube that two others hit at nearly the same time (thesis 5.1).
#pragma once

#include "driver/experiment.hpp"

namespace tumble::chapters {

// Cubes of 1 m and 1 kg without gravity that bounce without loss: body 1 rests, body 0 hits it
// from the left and body 2 from the right.
struct TwoImpacts {
  World world;             // at the start of the frame
  bool left_first = true;  // body 0 comes before body 2
};

// The part of two impacts that is not random.
struct TwoImpactsOptions {
  double frame = 1.0 / 60.0;  // [s] the first impact is between a fifth and four fifths of it
  double delay = 0.0;         // [s] from the first impact to the second
  bool turning = false;       // all have any orientation and those that fly turn; else faces meet
};

// Draws speeds from 1 to 10 m/s, ways that pass the middle at up to 0.3 edges to each side,
// angular velocities up to 10 rad/s, the time of the first impact, and the side of it.
//
// The times of the impacts are right to a picosecond: a search finds when a cube that comes from a
// distance would hit, and the cube is then flown forth or back by what the time is off. The flight
// of a cube is exact in both directions, and the one that is hit rests.
TwoImpacts two_impacts(const TwoImpactsOptions& options, Random chance);

}  // namespace tumble::chapters
