/// \file
/// \brief The normal of two boxes that touch edge on edge (thesis 3.2).
#pragma once

#include "tumble/geometry/manifold.hpp"
#include "tumble/geometry/separation_pair.hpp"

namespace tumble {

/// Finds the contact of two boxes that meet edge on edge, as at the ridge of a tent of two cards.
///
/// Where one edge lies on another, the normals of four faces would do, and rounding picks one. All directions that leave
/// the first and enter the second edge between the faces beside them are normals just as well; this takes the middle
/// of them: n ~ r + s, r and s the two outermost ones, each normal to a face. For two boxes that mirror each
/// other it is normal to the mirror. Boxes that are apart, and nearest to each other in two such edges, have the
/// direction from the one edge to the other as their normal.
///
/// Changes nothing where r and s are nearly the same, and where a face is nearly parallel to one of the other box:
/// neighbours in a wall that share an edge do not push each other diagonally.
/// \param distance  [m] between the boxes along the manifold's normal
/// \param margin    [m] points farther apart along the normal are left out
/// \param manifold  as collide() found it; where the boxes meet in such edges, with both ends of the stretch that
///                  these share
/// \verified{A tent of two cards has a horizontal normal at its ridge}
void turn_to_edges(const BoxPair& pair, double distance, double margin, Manifold& manifold);

}  // namespace tumble
