/// \file
/// \brief Two bodies that stick where they touch: what is held, and how far it has come apart (thesis 6.2).
///
/// Uses no other chapter.
#pragma once

#include "tumble/contact/contact.hpp"

#include <array>
#include <span>
#include <vector>

namespace tumble {

/// What of a joint is held.
enum class JointHold : std::uint8_t {
  area,    ///< all relative motion: six rows, glue
  edge,    ///< all but turning about a side of the area, or about the line of contact: five rows
  corner,  ///< a point stays on a point: three rows
  nothing  ///< the two have come apart
};

/// The corners of an area, in one body's frame.
using Corners = std::array<Vec3, Manifold::kMostPoints>;

/// Corners that are not known yet.
/// \return [m] all 0
inline Corners no_corners() {
  Corners corners;
  corners.fill(Vec3::Zero());
  return corners;
}

/// The place where a body stands on another one and sticks, in the frames of both.
///
/// The area is a convex polygon of up to eight corners. Each corner is kept twice, as a point of the
/// first body's material and as one of the second's; at the start they are the same point of the
/// world. A line has two corners, a point one.
struct Joint {
  int first = 0;                            ///< index of the one
  int second = 0;                           ///< index of the other one, the larger
  int count = 0;                            ///< corners, 1 to 8, in order around the area
  Corners corners_first_b = no_corners();   ///< [m] frame of the first body
  Corners corners_second_b = no_corners();  ///< [m] frame of the second body
  Vec3 normal_first_b = Vec3::UnitY();      ///< [-] towards the second body, frame of the first
  JointHold hold = JointHold::area;         ///< what is held now
  int side = 0;                             ///< of an edge: from this corner to the next one

  /// Whether the area has an extent: only then it can open and close.
  /// \return false for a line or a point
  [[nodiscard]] bool is_area() const { return count > 2; }
};

/// A point where the material of two bodies was glued together.
struct JointPoint {
  Vec3 first_w = Vec3::Zero();   ///< [m] where the first body has it, world frame
  Vec3 second_w = Vec3::Zero();  ///< [m] where the second body has it, world frame
};

/// Makes a joint of a contact.
///
/// Two points make an edge, one a corner, more an area.
/// \param world    the bodies, at the poses at which the contact was found
/// \param contact  with at least one point
/// \return what is held is what the points can hold
/// \throws std::invalid_argument for a contact without a point
Joint joint_of(const World& world, const Contact& contact);

/// All joints of bodies that touch and do not part.
///
/// A pair parts if all its points do, faster than tolerance::resting_speed times sqrt(g L) of its
/// smaller edge L, and times the speed of its faster body.
/// \param world   the bodies
/// \param margin  [-] surfaces up to this far apart touch, over the shortest edge of the pair
/// \return sorted by pair
/// \throws std::invalid_argument for a margin that is negative or not finite
/// \par Cost
/// One test of two boxes for each pair whose bounds overlap.
std::vector<Joint> find_joints(const World& world, double margin);

/// The joints of a world after bodies came or went.
///
/// Bodies that were there keep the joints that they have, open or not; a new body sticks to what it
/// touches.
/// \param joints  as they were
/// \param before  the ids of the bodies then, by index
/// \param world   the bodies now
/// \param margin  [-] of find_joints(), for new bodies
/// \return sorted by pair
/// \throws std::invalid_argument for a margin that is negative or not finite
std::vector<Joint> renewed_joints(std::span<const Joint> joints, std::span<const BodyId> before,
                                  const World& world, double margin);

/// The point about which a joint is held: the mean of its corners, of the two of an edge, or the one.
/// \param joint   see there
/// \param states  of all bodies, by index
/// \return in the world, from both sides
JointPoint held_point(const Joint& joint, std::span<const BodyState> states);

/// A corner of a joint.
/// \param joint   see there
/// \param corner  from 0, below the count
/// \param states  of all bodies, by index
/// \return in the world, from both sides
JointPoint corner_of(const Joint& joint, int corner, std::span<const BodyState> states);

/// How far a joint has come apart, where it is held.
struct JointGap {
  double opening = 0.0;  ///< [m] largest distance along the normal, 0 or above
  double overlap = 0.0;  ///< [m] deepest overlap along the normal, 0 or above
  double apart = 0.0;    ///< [m] largest distance of a corner from itself
};

/// Measures a joint at the corners that are held: all of an area, two of an edge, one.
/// \param joint   see there; nothing held gives all zeros
/// \param states  of all bodies, by index
/// \return over its corners
JointGap gap_of(const Joint& joint, std::span<const BodyState> states);

/// The largest of a group.
/// \param joints  see there
/// \param states  of all bodies, by index
/// \return over all of them
JointGap gap_of(std::span<const Joint> joints, std::span<const BodyState> states);

/// How wide an area that is held by an edge has opened.
/// \param joint   with an area
/// \param states  of all bodies, by index
/// \return [m] how far the second body's middle of the area is above the first's plane, as seen from the
///         edge; below 0 they overlap
double opened(const Joint& joint, std::span<const BodyState> states);

}  // namespace tumble
