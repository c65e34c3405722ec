/// \file
/// \brief A series of blocks as one heavier block (thesis 6.3.1, figure 6.4).
#pragma once

#include "driver/figure.hpp"
#include "geometric_stability/balance_probe.hpp"

#include <string_view>

namespace tumble::chapters {

/// Blocks of 1 m length over the edge of a table, the k-th from the top 1/k as far over the one below
/// it as the uppermost: they reach farthest, and all of them would tip at once.
/// \param blocks    how many, at least 1
/// \param overhang  [m] of the uppermost over the edge of the table
/// \return the table and the blocks, from below
Structure blocks_over_edge(int blocks, double overhang);

/// How far blocks of 1 m can reach over the edge.
///
/// The centre of the upper k blocks has to be over the one below them. If it is over its edge at every
/// level, block k is 1/(2k) over: sum over all.
/// \param blocks  how many, at least 1
/// \return [m] 1/2, 3/4, 11/12, 25/24, 137/120, 49/40, ...
double largest_overhang(int blocks);

/// The series of figure 6.4.
/// \param pattern   "staircase" or "to_and_fro"
/// \param blocks    how many
/// \param overhang  [-] from each block to the next, in lengths of a block
/// \return a base on the ground and the blocks, from below
Structure series_of(std::string_view pattern, int blocks, double overhang);

/// Figure 6.4: hulls and centres at every level, one block instead, how it tips, and the work.
/// \param settings  count, overhang, beyond, largest
/// \return tables "" (work against the number of blocks), "boxes", "levels", "one", "outlines" and
///         "arrows"; thresholds against closed forms
Result measure_one_block(const Parameters& settings);

}  // namespace tumble::chapters
