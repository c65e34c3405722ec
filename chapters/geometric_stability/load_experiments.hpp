/// \file
/// \brief Loads on the tops of random piles, against who is called stable (thesis 5.4).
#pragma once

#include "driver/figure.hpp"

namespace tumble::chapters {

/// Claim 5.4a: how boxes of random piles accelerate under random loads on all tops.
/// \param settings  piles, loads
/// \return tables "stable", "load_proof", "printed" and "other": of the boxes that the rule of the
///         thesis calls stable, of those that are only load-proof, of those called stable as
///         printed, and of those that the rule does not call stable, the largest acceleration over
///         that by the load alone and the share of boxes with at most this; the claim's number
/// \throws std::runtime_error if a problem of contact forces has no answer
Result measure_any_load(const Parameters& settings);

}  // namespace tumble::chapters
