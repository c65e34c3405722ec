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

/// [-] Two edges lie on each other if a contact is no farther from both than this share of the longest edge. Reason:
/// what an impact leaves, an overlap of at most a thousandth. (3.2)
inline constexpr double edge_on_edge = 1e-3;

/// [-] And than this share of the shortest edge. Reason: in thin plates the other edge beside the same face is meant no
/// longer. (3.2)
inline constexpr double edge_on_edge_of_shortest = 0.1;

/// [-] 1 - cosine of the angle up to which such edges count as parallel. Reason: at 1e-3 rad the distance between them
/// changes along them by what edge_on_edge allows. (3.2)
inline constexpr double edge_on_edge_turn = 5e-7;

/// [-] Of the boxes' extent: what rounding may change of the distance between two such edges. Reason: far above rounding,
/// far below any margin of boxes that are not side by side. (3.2)
inline constexpr double edge_on_edge_rounding = 1e-9;

/// [-] Cosine of the angle (6 degrees) below which faces beside such edges count as parallel. Reason: boxes laid in rows
/// are turned by less. (3.2)
inline constexpr double edge_on_edge_aligned = 0.995;

/// [-] Cosine of the angle (24 degrees) below which the outermost normals of two such edges count as one. Reason: a
/// friction of 0.2 makes up for half of it; a box that tips over on the edge of another one keeps its face's normal. (3.2)
inline constexpr double edge_on_edge_same = 0.914;

}  // namespace tumble::tolerance
