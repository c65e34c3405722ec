/// \file
/// \brief Dice that come to rest with randomness in fast collisions, in slow ones, and in all
///        (thesis 4.2).
#pragma once

#include "driver/figure.hpp"

namespace tumble::chapters {

/// The time until thrown dice rest, against which collisions are left to chance (claim 4.2a).
///
/// A die rests from the step on after which no corner of it moves by more than a two-thousandth of
/// its edge in a step; dice that do not rest count with the whole run.
/// \param settings  seeds, duration
/// \return tables "" (mean time to rest under each rule, with the damping and without) and "path"
///         (the lowest corner of one die over time); the claim's number, with intervals, and the
///         same with thresholds and factors halved and doubled, without damping, and for tossed
///         cubes
Result measure_chance(const Parameters& settings);

}  // namespace tumble::chapters
