/// \file
/// \brief The cost of a step at 10, 100 and 1000 boxes, in counts.
#pragma once

#include "choosing/compared.hpp"

namespace tumble::chapters {

/// The work of a step, the mean over a few.
/// \param scene   where they begin
/// \param played  the technique
/// \param steps   how many, of 1/60 s
/// \return [-] work_of() a step; kNoNumber if the technique does not take the scene
double step_cost(const Scene& scene, const PlayedTechnique& played, int steps);

/// Stacks of five cubes that do not touch each other.
/// \param boxes  in all, a multiple of five
/// \return stacks on a square grid, with friction 0.5
Scene separate_stacks(int boxes);

}  // namespace tumble::chapters
