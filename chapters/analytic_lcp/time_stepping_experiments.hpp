/// \file
/// \brief What is measured of time stepping: whether it needs events, whether it always has an answer
///        (thesis 2.6.3).
#pragma once

#include "driver/figure.hpp"

namespace tumble::chapters {

/// A cube flies into a stack of cubes, without a search for events (thesis 2.6.3).
/// \param settings  cubes, duration, shots
/// \return table "": the first shot, a row for each step with overlap, error and speed; table "shots": a
///         row for each; the share of the steps that were not solved or left a deep overlap
Result measure_no_events(const Parameters& settings);

/// Random contacts with friction, and Painlevé's rod, in the form of Anitescu and Potra (thesis 2.6.3).
/// \param settings  problems, seed
/// \return table "": how the errors of the answers are distributed; table "rod": a row for each rod; the
///         share that was not solved
Result measure_always_solved(const Parameters& settings);

}  // namespace tumble::chapters
