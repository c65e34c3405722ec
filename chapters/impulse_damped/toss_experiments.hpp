/// \file
/// \brief Tossed cubes with and without chance, against measured ones (thesis 2.4.2, 4.2).
#pragma once

#include "driver/figure.hpp"

#include <array>

namespace tumble::chapters {

/// The quartiles of twenty measured tosses of a real cube.
///
/// Of ContactNets' data (Pfrommer, Halm, Posa: ContactNets, CoRL 2020), the first twenty tosses, as
/// read_tosses() and measured_outcome() give them; a test computes them again where the data are.
struct MeasuredQuartiles {
  std::array<double, 3> travel;        ///< [m] along the table, from start to end
  std::array<double, 3> time_to_rest;  ///< [s] until the cube moves no more, see `toss_still`
};

/// What was measured.
inline constexpr MeasuredQuartiles measured_tosses{{0.37300048, 0.40627362, 0.45103770},
                                                   {0.61993243, 0.65202703, 0.66891892}};

/// Claim 2.4.2a: whether chance in fast collisions brings outcomes nearer to the measured ones.
/// \param settings  tosses (for each seed), seeds
/// \return tables "" (shares of tosses by travel and by time) and "quartiles"; how far quartiles
///         are from the measured ones
Result measure_tosses(const Parameters& settings);

}  // namespace tumble::chapters
