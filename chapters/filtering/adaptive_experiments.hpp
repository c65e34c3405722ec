/// \file
/// \brief Whether smaller steps reduce chatter and bring rest sooner (thesis 6.3.1, claim 6.3.1b).
#pragma once

#include "driver/figure.hpp"

#include <vector>

namespace tumble::chapters {

/// The figures on adaptive steps: "claim_6_3_1b_adaptive", "adaptive_step_cost" and
/// "adaptive_step_cause".
/// \return them
std::vector<Figure> adaptive_figures();

/// Claim 6.3.1b: the clump of figure 6.7 under `damped` at steps of 1/60 s, and with the same steps
/// halved as AdaptiveStep does.
/// \param settings  seeds, per_edge, settling, watched, halvings
/// \return tables "" (by time: shares of bodies that still move, sub-steps) and "amplitudes" (share of
///         the resting bodies up to an amplitude); the claim's number
Result measure_adaptive_claim(const Parameters& settings);

/// What smaller steps cost and what they are good for: the same clump, smaller, at fixed steps and
/// with adaptive ones of several tolerances; and a cube thrown at a thin plank.
/// \param settings  seeds, per_edge, settling, watched, halvings, throws
/// \return tables "" (fixed steps: work, chatter, time to rest), "adaptive" (the same by tolerance) and
///         "plank" (by speed: share of the throws that pass through)
Result measure_adaptive_cost(const Parameters& settings);

/// Where chatter comes from: fixed steps with pushes of several sizes, and with velocities stopped in
/// place of pushes.
/// \param settings  seeds, per_edge, settling, watched, halvings
/// \return table "" (by step: mean amplitude and share of bodies that rest)
Result measure_chatter_cause(const Parameters& settings);

}  // namespace tumble::chapters
