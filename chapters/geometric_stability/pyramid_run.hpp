/// \file
/// \brief How many contact forces are unknown, step by step, while a pyramid is simulated (thesis
///        5.4).
#pragma once

#include "tumble/dynamics/world.hpp"

#include <cstdint>
#include <functional>
#include <vector>

namespace tumble::chapters {

/// Counts at the start of each step of a run.
struct CountedRun {
  std::vector<double> all;     ///< unknown forces if nobody is left out
  std::vector<double> left;    ///< without the boxes that are stable then, by the rule of corners
  std::vector<double> stable;  ///< how many those are
};

/// Simulates a world with the technique `analytic`, without friction and damped, stable boxes left
/// out, at 60 steps a second.
/// \param world   at the start
/// \param steps   how many
/// \param before  called before each step with the world; may be empty
/// \return the counts of each step
/// \throws std::runtime_error if a step was not solved
CountedRun count_run(World world, int steps, const std::function<void(const World&)>& before = {});

/// The pyramid of figure 5.6 in which everything that is not stable has got a random velocity.
/// \param rows   boxes in the lowest row before one was taken out, an odd number
/// \param gap    [-] between neighbours, in edges
/// \param knock  [m/s] each component is drawn from [-knock, knock)
/// \param seed   of the draws
/// \return the world
World knocked_pyramid(int rows, double gap, double knock, std::uint64_t seed);

}  // namespace tumble::chapters
