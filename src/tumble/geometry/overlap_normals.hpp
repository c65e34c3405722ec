/// \file
/// \brief Normals of two boxes that overlap, by other rules than the shortest way out (thesis 3.3.2).
#pragma once

#include "tumble/geometry/separation.hpp"

namespace tumble {

/// The face of two boxes that is closest to the other box.
///
/// Along the normal n of a face the boxes are
/// \f$s(n) = |d\cdot n| - \sum_i a_i|A_i\cdot n| - \sum_j b_j|B_j\cdot n|\f$ apart; the face with
/// the largest s is the closest. Of faces that tie (tolerance::face_tie) the one with the lowest
/// number is taken.
/// \return its axis, 0 to 5, the way from the first box to the second along it, and s
[[nodiscard]] Separation closest_face(const Box& first, const Box& second);

/// The direction in which the distance function of one box grows where the other one is deepest in
/// it.
///
/// Looked at are 26 points of each box's surface: corners, middles of edges and of faces.
/// \return a face's axis, 0 to 5, the normal and how far the boxes are apart along it; axis kNoAxis
///         if no point of either lies in the other, as where two edges cross
/// \see Guendelman, Bridson, Fedkiw, "Nonconvex rigid bodies with stacking", 2003, section 4.
[[nodiscard]] Separation deepest_gradient(const Box& first, const Box& second);

}  // namespace tumble
