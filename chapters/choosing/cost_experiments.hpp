/// \file
/// \brief What a step costs at 10, 100 and 1000 boxes, in counts.
#pragma once

#include "choosing/compared.hpp"

#include <vector>

namespace tumble::chapters {

/// The figure "choose_cost".
/// \return it
std::vector<Figure> cost_figures();

/// The work of a step, on average, and what can be told of its size.
struct StepCost {
  bool refused = false;  ///< the technique does not take the scene
  double work = 0.0;     ///< [-] work_of() a step
  double pivots = 0.0;   ///< [-] of these
};

/// Steps a scene a few times.
/// \param scene   what is stepped
/// \param played  the technique
/// \param steps   how many, of 1/60 s
/// \return the mean over these steps
StepCost step_cost(const Scene& scene, const PlayedTechnique& played, int steps);

/// Stacks of five cubes that do not touch each other.
/// \param boxes  in all, a multiple of five
/// \return stacks on a square grid, with friction 0.5
Scene separate_stacks(int boxes);

/// Work of a step in separate stacks and in one pyramid, by technique and number of boxes.
/// \param settings  steps, patient
/// \return table "" (by technique, scene and size) and the work as numbers
Result measure_cost(const Parameters& settings);

}  // namespace tumble::chapters
