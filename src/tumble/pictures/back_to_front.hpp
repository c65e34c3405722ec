/// \file
/// \brief Faces sorted from back to front, cut where they overlap.
#pragma once

#include "tumble/base/types.hpp"

#include <vector>

namespace tumble {

/// A flat convex face in space, or a part of one.
struct FacePart {
  std::vector<Vec3> corners_w;    ///< [m] in order, world frame
  Vec3 normal_w = Vec3::UnitY();  ///< [-] length 1, world frame, to the side of the viewer
  int face = 0;                   ///< which face it is a part of
  bool cut = false;               ///< false: it is the whole face
};

/// Sorts faces so that each is painted after all that it hides, and cuts faces where none can be first.
///
/// A face is chosen; its plane divides the others, cutting those that cross it. The viewer is in front of it, so
/// the parts behind it are painted first, then the face, then the parts in front; each of the two
/// sets is sorted in the same way (binary space partition). Of a few faces the one that cuts fewest is chosen.
/// \param faces  each seen from its front, in any position, overlapping too
/// \return parts that cover the same points, to be painted from first to last
/// \par Cost
/// 54 boxes all in each other give about 3000 parts; at worst n² parts.
/// \see Fuchs, Kedem, Naylor, "On visible surface generation by a priori tree structures", SIGGRAPH 1980.
/// \verified{Boxes that overlap are drawn as the line of sight meets them}
[[nodiscard]] std::vector<FacePart> back_to_front(std::vector<FacePart> faces);

}  // namespace tumble
