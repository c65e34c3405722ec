/// \file
/// \brief A heavy block that keeps two others from tipping (thesis 6.3.1, figure 6.5).
#pragma once

#include "geometric_stability/balance_probe.hpp"

namespace tumble::chapters {

// The configuration of figure 6.5.
// mass_ratio: [-] mass of the top block over that of a lower one
// offset: [m] of the top block, to the right
// friction: [-] Coulomb's coefficient of everything
RestingPile heavy_top(double mass_ratio, double offset, double friction = 0.0);

// The mass ratio from which figure 6.5 can stand, by hand:
// \f[ \frac{M}{m} = \frac{14}{(3 + 4\mu)\,(7 - 4|o|)} . \f]
// The derivation stands beside the code. With friction it says that forces exist, not that they
// come about.
// offset: [m] o, of the top block, from -0.25 to 0.25
// friction: [-] mu, at most 2.75
// Returns [-]
double mass_ratio_by_hand(double offset, double friction = 0.0);

// The same by bisection on the verdict of StaticEquilibrium.
// offset: [m] of the top block
// friction: [-] Coulomb's coefficient; 0: none
// Returns [-]
double mass_ratio_by_balance(double offset, double friction = 0.0, int friction_edges = 0);

}  // namespace tumble::chapters
