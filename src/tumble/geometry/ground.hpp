/// \file
/// \brief Contact of a box with the ground, the half-space y <= 0 (thesis 3.2).
#pragma once

#include "tumble/geometry/manifold.hpp"

namespace tumble {

/// Finds where a box touches the ground.
///
/// The ground is the first body and the box the second, so the normal is +y; a caller with the
/// other order calls flip(). The points are the corners with height <= margin, in order around the
/// area; a corner's distance is its height, and its position is halfway between it and the ground.
/// A corner below the ground is kept however deep it is, but only the corners of the face that
/// looks down most can touch: the ones above it would push where nothing is.
/// \param margin  [m] keep corners up to this high, at least 0
/// \param out     is overwritten; its count is 0 to 4
/// \return whether there is a point
/// \throws std::invalid_argument if the margin is negative or not finite
bool collide_with_ground(const Box& box, double margin, Manifold& out);

}  // namespace tumble
