/// \file
/// \brief A series of blocks as one heavier block (thesis 6.3.1, figure 6.4).
#pragma once

#include "geometric_stability/balance_probe.hpp"

#include <string_view>

namespace tumble::chapters {

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
