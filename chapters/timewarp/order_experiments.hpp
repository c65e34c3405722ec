/// \file
/// \brief Figure 5.1: in which order five cubes meet, and the queue of collisions at work (thesis
///        5.1).
#pragma once

#include "driver/figure.hpp"

namespace tumble::chapters {

/// Figure 5.1 and claim 5.1b: one frame of five cubes on a line, by three forms of the timewarp and a
/// search over all bodies in tiny steps.
/// \param settings  those of the scene `fig5_1`, frame, reference_steps
/// \return tables "" (the collisions as they were resolved), "bands", "overlaps", "scene"; how many
///         are out of place; the claim's number. Panels count simple, safer, swept, reference from 0
/// \throws std::invalid_argument if the cubes overlap at the start
Result measure_order_of_five(const Parameters& settings);

/// How the queue changes from collision to collision, in one frame of a few cubes on a line.
/// \param settings  boxes (as of the scene `line`), frame, form (of the timewarp)
/// \return tables "" (the queue, panel by panel), "ways", "dots"; what became of foreseen
///         collisions
/// \throws std::runtime_error if more than one collision in a row is put in front of the queue
Result measure_queue_at_work(const Parameters& settings);

}  // namespace tumble::chapters
