/// \file
/// \brief A small cube thrown at a thin plank: does it pass through? (thesis 6.3.1)
#pragma once

#include "tumble/filtering/adaptive_step.hpp"

namespace tumble::chapters {

/// Throws cubes of 0.2 m at a fixed plank of 0.05 m, from distances that differ by less than the way
/// in a step, under `damped` at 60 steps a second.
/// \param speed    [m/s] of the cube, above 0
/// \param throws   how many, at least 1
/// \param options  when steps are divided
/// \return [-] share of them that end behind the plank
double share_through(double speed, int throws, const AdaptiveStepOptions& options);

}  // namespace tumble::chapters
