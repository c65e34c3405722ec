/// \file
/// \brief The cost of a step at 10, 100 and 1000 boxes, in counts.
#pragma once

#include "choosing/compared.hpp"

namespace tumble::chapters {

// The work of a step, the mean over a few.
// Returns [-] work_of() a step; kNoNumber if the technique does not take the scene
double step_cost(const Scene& scene, const PlayedTechnique& played, int steps);

// Stacks of five cubes that do not touch each other.
Scene separate_stacks(int boxes);

}  // namespace tumble::chapters
