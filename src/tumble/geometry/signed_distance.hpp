/// \file
/// \brief Distance and direction of a point from a box (thesis 3.3.2, footnote).
#pragma once

#include "tumble/geometry/box.hpp"

namespace tumble {

/// How far a point is from the surface of a box.
struct SignedDistance {
  double distance = 0.0;            ///< [m] below 0 inside, 0 on the surface, above 0 outside
  Vec3 gradient_w = Vec3::UnitX();  ///< [-] world frame, length 1, the way out
};

/// The distance function of a box and its gradient, the normal that the thesis did without.
///
/// Let p be the point in the box's frame, h the half edges and \f$q_k = |p_k| - h_k\f$:
/// \f[ \varphi = |\max(q, 0)| + \min(\max_k q_k,\; 0). \f]
/// Outside, the first term is the distance to the nearest point of the box, and the gradient points
/// from there to p. Inside, and on the surface, the second is minus the distance to the nearest
/// face, and the gradient is that face's normal.
///
/// Inside, the gradient jumps where two faces are equally near. There the axis of lowest number is
/// taken, and the positive side where the coordinate is 0: at the centre of a cube the gradient
/// is the box's own +x.
///
/// \return distance, exact to rounding, and gradient
/// \throws std::invalid_argument for a point that is not finite
/// \par Cost
/// About 15 operations and two changes of frame: the thesis had no reason to avoid it.
/// \note It judges points. Two boxes can overlap edge to edge with no corner of either inside the
///       other, so the separating axis test remains the judge of pairs.
/// \algorithm{The signed distance of a box: footnote in section 3.3.2}
/// \verified{No point of a dense sampling of the surface is nearer than the signed distance}
[[nodiscard]] SignedDistance signed_distance(const Box& box, const Vec3& point_w);

}  // namespace tumble
