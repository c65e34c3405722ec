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

// [deg] From this slope on a box twice as high as wide tips over its lower edge: arctan 1/2.
inline const double kTippingSlope = std::atan(0.5) * 180.0 / std::numbers::pi;

// Whether such a box tips on a slope that is steeper by so much, and not on one that is less steep by as much. Its
// coefficient of friction is 2, so that it does not slide.
// within: [deg]
bool tips_at_limit(const PlayedTechnique& played, double within);

}  // namespace tumble::chapters
