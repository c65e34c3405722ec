/// \file
/// \brief A heavy block that keeps two others from tipping (thesis 6.3.1, figure 6.5).
#pragma once

#include "geometric_stability/balance_probe.hpp"

namespace tumble::chapters {

/// The configuration of figure 6.5.
/// \param mass_ratio  [-] mass of the top block over that of a lower one
/// \param offset      [m] of the top block, to the right
/// \param friction    [-] Coulomb's coefficient of everything
/// \return two pedestals, two blocks that overhang outwards, and the one on top
RestingPile heavy_top(double mass_ratio, double offset, double friction = 0.0);

/// The mass ratio from which figure 6.5 can stand, by hand:
/// \f[ \frac{M}{m} = \frac{14}{(3 + 4\mu)\,(7 - 4|o|)} . \f]
/// The derivation stands beside the code. With friction it says that forces exist, not that they
/// come about.
/// \param offset    [m] o, of the top block, from -0.25 to 0.25
/// \param friction  [-] mu, at most 2.75
/// \return [-]
double mass_ratio_by_hand(double offset, double friction = 0.0);

/// The same by bisection on the verdict of StaticEquilibrium.
/// \param offset          [m] of the top block
/// \param friction        [-] Coulomb's coefficient; 0: none
/// \param friction_edges  of the pyramid of friction
/// \return [-]
double mass_ratio_by_balance(double offset, double friction = 0.0, int friction_edges = 0);

}  // namespace tumble::chapters
