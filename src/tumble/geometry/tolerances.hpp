/// \file
/// \brief The thresholds of contact points, each with its reason.
#pragma once

namespace tumble::tolerance {

// --- contact points ---------------------------------------------------------------------

/// [-] Sine of the angle below which two edges that touch are taken to do so in the middle of the
/// stretch they share. Reason: the distance between them changes by this part of a size along it,
/// and rounding hides where it is least. (3.2)
inline constexpr double edges_side_by_side = 1e-7;

/// [-] Sine of the angle below which the closest points of two edges are found one from the other.
/// Reason: found each by itself they differ by rounding over the square of the angle, here 1e-8 of
/// a size. (3.2)
inline constexpr double nearly_parallel_edges = 1e-4;

/// [-] Edges that touch along an axis are a contact if their points are no farther apart beside it than this share of the
/// longest edge. Reason: a contact point may lie off a box by so much; edges side by side leave rounding. (4.1)
inline constexpr double beside_the_normal = 1e-6;

}  // namespace tumble::tolerance
