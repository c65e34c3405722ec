/// \file
/// \brief What damping does in place of friction between bodies, measured (thesis 5.3).
#pragma once

#include "driver/figure.hpp"

#include <vector>

namespace tumble::chapters {

/// Adds the figures on friction: "fig5_2_friction", "claim_5_3c_friction", "claim_5_3f_chain" and
/// "claim_5_3g_seen".
/// \param list  gets them
void add_friction_figures(std::vector<Figure>& list);

/// Figure 5.2: a block slides on one that is free to move, damped and with Coulomb's friction.
/// \param settings  speed, mass, lower_mass, friction, ground_friction, duration
/// \return tables "" (speeds and momentum over time), "blocks" and "forces" (means while the upper
///         block slides); momenta at the end, mean forces
Result measure_sliding_blocks(const Parameters& settings);

/// Claim 5.3c: how far the speed of the upper block is from the one with Coulomb's friction.
/// \param settings  speed, duration, steps
/// \return tables "" (speeds over time, for half and twice the damping too) and "friction" (the
///         number that decides against the coefficient of friction); the claim's number
Result measure_friction_on_upper(const Parameters& settings);

/// Claim 5.3f: what friction gives to the upper box of a stack on a sled.
/// \param settings  speed, duration
/// \return tables "" (speeds over time) and "boxes" (where they end); the claim's number
Result measure_friction_chain(const Parameters& settings);

/// Claim 5.3g: how far things go, and how they lie in the end, over seeds.
/// \param settings  seeds, rows, per_edge, duration
/// \return tables "" (a row for each seed and scene) and "travel" (medians); the claim's number
Result measure_what_is_seen(const Parameters& settings);

}  // namespace tumble::chapters
