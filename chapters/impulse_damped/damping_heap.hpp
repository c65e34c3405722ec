/// \file
/// \brief The energy that pushes out of overlap add, and what the damping takes from a heap (thesis 4.4, 5.3).
#pragma once

#include "driver/experiment.hpp"

namespace tumble::chapters {

// The largest value that any seed has found. It has no interval: more seeds would only raise it.
Quantity largest_found(const std::string& name, std::span<const double> values);

// The energy that the pushes of a step add to a cube in the ground, less what the end of the overlap takes.
// states: [-] depths up to 3 mm that each seed tries
// seeds: [-] at least 2
void add_push_energy(int states, int seeds, Result& result);

// The energy that damping takes from heaps of 27 cubes and of 27 bricks, and that pushes add.
// seeds: [-] heaps of each, at least 2
// duration: [s] of each run
void add_heap_energy(int seeds, double duration, Result& result);

}  // namespace tumble::chapters
