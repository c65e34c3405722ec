/// \file
/// \brief How often the forms of the timewarp tell a crowded frame wrong (thesis 5.1).
#pragma once

#include "driver/figure.hpp"

#include <vector>

namespace tumble::chapters {

/// The figure on crowded frames: "claim_5_1a_order".
/// \return it
std::vector<Figure> crowd_figures();

/// Claim 5.1a: collisions missed or out of order in single frames of random crowded scenes.
///
/// Each frame starts from a fresh state of cubes in a cage: places and orientations stirred,
/// velocities drawn anew. The story of a frame is held against that of a search over all bodies
/// that misses nothing.
/// \param settings  seeds, frames, cubes, chains, checked, finest, resolution
/// \return tables "" (by speed: shares of frames told wrong and of events missed or out of order),
///         "chains" (by speed: share of chains told wrong) and "references" (by step: share of
///         frames in which two references differ); the claim's number
Result measure_crowd_order(const Parameters& settings);

}  // namespace tumble::chapters
