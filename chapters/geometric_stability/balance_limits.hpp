/// \file
/// \brief Structures that just stand (thesis 6.3.1): a heavy block that keeps two others from tipping (figure 6.5), and
///        a series of blocks as one heavier block (figure 6.4).
#pragma once

#include "geometric_stability/balance_probe.hpp"

#include <string_view>

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

// The reach of blocks of 1 m over the edge of a table.
//
// The centre of the upper k blocks has to be over the one below them. If it is over its edge at every
// level, block k is 1/(2k) over: sum over all.
// Returns [m] 1/2, 3/4, 11/12, 25/24, 137/120, 49/40, ...
double largest_overhang(int blocks);

// The series of figure 6.4.
// overhang: [-] from each block to the next, in lengths of a block
RestingPile series_of(std::string_view pattern, int blocks, double overhang);

// A test of whether a structure stands.
using StandTest = bool (*)(const RestingPile&);

// The overhang up to which a test lets a series of figure 6.4 stand [-], in lengths of a block.
double series_limit(std::string_view pattern, int blocks, StandTest test);

// The error of the reach up to which a test lets blocks hang over an edge [-], relative to largest_overhang().
double edge_error(int blocks, StandTest test);

}  // namespace tumble::chapters
