/// \file
/// \brief Measures of this chapter: the cost of a step at 10, 100 and 1000 boxes, in counts; error
///        against work on motions with closed forms (thesis 6.3.2); boxes that should rest, and one that should tip.
#pragma once

#include "choosing/compared.hpp"
#include "driver/experiment.hpp"

namespace tumble::chapters {

// The work of a step, the mean over a few.
// Returns [-] work_of() a step; kNoNumber if the technique does not take the scene
double step_cost(const Scene& scene, const PlayedTechnique& played, int steps);

// Stacks of five cubes that do not touch each other.
Scene separate_stacks(int boxes);

// The least work that each technique needs in each problem; infinity where no step gets there.
using LeastWork = std::vector<std::array<double, 3>>;

// How many pairs of techniques change places between two problems.
//
// A pair does if one needs less work in one problem, and the other in another. A technique that never gets
// there needs more than one that does, and two of that kind have no order.
// Returns [-] over all pairs
double share_that_changes_places(const LeastWork& work);

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
