/// \file
/// \brief Boxes that should rest, and one that should tip, under each technique.
#pragma once

#include "choosing/compared.hpp"

namespace tumble::chapters {

// What became of a pile. One that does not stand has no other numbers but the overlap.
struct PileRun {
  bool stands = false;         // no box ends half an edge from its start, or at 1 m/s or more
  double speed = kNoNumber;    // [m/s] fastest centre in the last half second
  double overlap = 0.0;        // [m] deepest during the run
  double chatter = kNoNumber;  // [m] amplitude at the end; none if nothing rests or it fell
};

// Runs a pile of boxes.
// duration: [s] at least half a second
PileRun pile_run(const Scene& scene, const PlayedTechnique& played, double duration);

// At which slope a box tips over its lower edge, by bisection.
//
// A box twice as high as wide should tip from \f$\arctan \tfrac12\f$ on. Its coefficient of friction is 2, so
// that it does not slide.
// Returns [deg] the middle of the last interval; 0 if it tips at 2 degrees, infinity if it does not at 60
double tipping_angle(const PlayedTechnique& played, int halves);

}  // namespace tumble::chapters
