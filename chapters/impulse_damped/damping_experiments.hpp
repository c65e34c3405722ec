/// \file
/// \brief The damping in place of friction: its figures, and whether it ever adds energy (thesis
///        5.3).
#pragma once

#include "driver/figure.hpp"

#include <vector>

namespace tumble::chapters {

/// Adds the figures of claims 4.2a, 5.3a, 5.3b and 5.3e.
/// \param list  gets them
void add_damping_figures(std::vector<Figure>& list);

/// By how much each stage of the damping raises the energy of a body, at random states (claim
/// 5.3a).
///
/// A stage is run alone. Its factor is the kinetic energy after it over that before; for moves that
/// are undone, over that with the move. Momenta are drawn from a hundredth of the smallest
/// threshold that is looked at to ten times the largest, each size as likely, and half of the
/// orientations are near a level face, by up to twice ε2 about each axis.
/// \param settings  states, seeds, longest, duration
/// \return tables "" (largest factor of each stage), "shape" (against the length of a brick) and
///         "heap" (energy booked over time); the claim's number, with intervals, and the same with
///         thresholds and factors halved and doubled; what pushes add
Result measure_damping_energy(const Parameters& settings);

/// What the pushes of a step add to a cube that has sunk into the ground, less what is needed to
/// end the overlap.
/// \param states  [-] depths up to 3 mm that each seed tries
/// \param seeds   [-] at least 2
/// \param result  gets the largest number, over m g L
void add_push_energy(int states, int seeds, Result& result);

/// What damping takes from heaps of 27 cubes and of 27 bricks, and what pushes add.
/// \param seeds     [-] heaps of each, at least 2
/// \param duration  [s] of each run
/// \param result    gets table "heap" (the first heap of each) and the shares
void add_heap_energy(int seeds, double duration, Result& result);

}  // namespace tumble::chapters
