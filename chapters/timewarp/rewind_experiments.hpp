/// \file
/// \brief What it costs to take bodies back in time, and to keep them at one time (thesis 2.4.3).
#pragma once

#include "driver/figure.hpp"

#include <vector>

namespace tumble::chapters {

/// The figures on what taking back costs: "claim_2_4_3a_rewinding", "claim_2_4_3b_synchronising" and
/// "timewarp_stride".
/// \return three figures
std::vector<Figure> rewind_figures();

/// Claim 2.4.3a: work per collision against the number of bodies, and against collisions in a frame.
/// \param settings  seeds, speed, spin, lead, frames
/// \return tables "" (a row for each number of bodies) and "rates" (a row for each speed); the
///         claim's number
Result measure_rewinding(const Parameters& settings);

/// Claim 2.4.3b: integrations of full timewarp, synchronised more or less often.
/// \param settings  seeds, speed, spin, lead, flights
/// \return tables "" (a row for each time between synchronisations) and "rates" (a row for each
///         speed); the claim's number
Result measure_synchronising(const Parameters& settings);

/// What the length of full timewarp's flights does.
/// \param settings  seeds, count, speed, spin, lead, frames
/// \return table "" (a row for each length); work of some lengths
Result measure_stride(const Parameters& settings);

}  // namespace tumble::chapters
