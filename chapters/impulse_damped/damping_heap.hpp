/// \file
/// \brief The energy that pushes out of overlap add, and what the damping takes from a heap (thesis 4.4, 5.3).
#pragma once

#include "driver/figure.hpp"

#include <span>
#include <string>

namespace tumble::chapters {

/// The largest of some values, with its interval over seeds.
/// \param name    of the number, a ratio
/// \param values  of each seed, at least 2
/// \return as over_seeds() gives it
Quantity most_over_seeds(const std::string& name, std::span<const double> values);

/// The energy that the pushes of a step add to a cube in the ground, less what the end of the overlap takes.
/// \param states  [-] depths up to 3 mm that each seed tries
/// \param seeds   [-] at least 2
/// \param result  gets the largest number, over m g L
void add_push_energy(int states, int seeds, Result& result);

/// The energy that damping takes from heaps of 27 cubes and of 27 bricks, and that pushes add.
/// \param seeds     [-] heaps of each, at least 2
/// \param duration  [s] of each run
/// \param result    gets table "heap" (the first heap of each) and the shares
void add_heap_energy(int seeds, double duration, Result& result);

}  // namespace tumble::chapters
