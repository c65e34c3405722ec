/// \file
/// \brief The schemes of the film strips, gaps over time, and gaps that single steps make (thesis 6.2).
#pragma once

#include "driver/figure.hpp"
#include "exterior_rotation/held_run.hpp"

#include <span>
#include <string>
#include <vector>

namespace tumble::chapters {

/// A scheme as figures call it.
struct FilmScheme {
  std::string column;  ///< of tables
  std::string words;   ///< for readers
  GluedScheme scheme;  ///< how the motion is integrated
};

/// The three schemes of order 1, the midpoint rule, the classical method, and the reference.
/// \return in this order, the thesis's first
std::span<const FilmScheme> film_schemes();

/// How many of film_schemes() are told apart by eye: all but the classical method and the reference.
inline constexpr std::size_t kSeenSchemes = 4;

/// The options of `glued` for a scheme, centres and orientations apart.
/// \param scheme  one of film_schemes()
/// \param pose    how bodies are moved
/// \return the reference with an accuracy of 1e-12
GluedOptions options_of(const FilmScheme& scheme, PoseUpdate pose = PoseUpdate::separate);

/// By how far the upper of two bodies in a joint is too far out along a direction.
/// \param world   the bodies
/// \param joint   held
/// \param out_w   [-] of length 1
/// \return [m] above 0: they have moved away from each other
double outwards(const World& world, const Joint& joint, const Vec3& out_w);

/// By how far one step from an exact state of the column pulls its highest joint apart, along the line
/// from the centre of rotation of the one to that of the other.
/// \param world    falling_column's; with one box the joint is the edge, and the line that from pivot to centre
/// \param options  of the step
/// \param dt       [s] above 0
/// \return [m] above 0 a gap, below 0 overlap
double gap_of_step(const World& world, const GluedOptions& options, double dt);

}  // namespace tumble::chapters
