/// \file
/// \brief Joints between bodies that stick where they touch, and the gap of a joint (thesis 6.2).
#pragma once

#include "tumble/contact/contact.hpp"

#include <array>
#include <span>
#include <vector>

namespace tumble {

/// Degrees of freedom that a joint holds.
enum class JointHold : std::uint8_t {
  area,    ///< all relative motion: six rows, glue
  edge,    ///< all but rotation about a side of the area, or about the line of contact: five rows
  corner,  ///< relative motion of a point: three rows
  nothing  ///< none: the bodies have come apart
};

/// The corners of an area, in one body's frame.
using Corners = std::array<Vec3, Manifold::kMostPoints>;

/// Initial value of corners [m]: all 0.
inline Corners no_corners() {
  Corners corners;
  corners.fill(Vec3::Zero());
  return corners;
}

/// The contact area in which two bodies stick together, in the frames of both.
///
/// The area is a convex polygon of up to eight corners. Each corner is stored as a material point of the
/// first body and as one of the second; at the start the two coincide. A line has two corners, a
/// point one.
struct Joint {
  int first = 0;                            ///< index of the first body
  int second = 0;                           ///< index of the second body, larger
  int count = 0;                            ///< corners, 1 to 8, in order around the area
  Corners corners_first_b = no_corners();   ///< [m] frame of the first body
  Corners corners_second_b = no_corners();  ///< [m] frame of the second body
  Vec3 normal_first_b = Vec3::UnitY();      ///< [-] towards the second body, frame of the first
  JointHold hold = JointHold::area;         ///< degrees of freedom held now
  int side = 0;                             ///< of an edge: from this corner to the next one
  bool of_scene = false;                    ///< made by World::join(): neither opens nor closes

  /// Whether the area has an extent; only then it can open and close; false for a line or a point.
  [[nodiscard]] bool is_area() const { return count > 2; }
};

/// A material point at which two bodies were glued together.
struct JointPoint {
  Vec3 first_w = Vec3::Zero();   ///< [m] its position on the first body, world frame
  Vec3 second_w = Vec3::Zero();  ///< [m] its position on the second body, world frame
};

/// Makes a joint from a contact.
///
/// Two points make an edge, one a corner, more an area.
/// \param world    the bodies, at the poses at which the contact was found
/// \param contact  with at least one point
/// \return the joint, with the degrees of freedom that the points can hold
/// \throws std::invalid_argument for a contact without a point
Joint joint_of(const World& world, const Contact& contact);

/// All joints of bodies that touch and do not separate.
///
/// Bodies that a joint of the scene joins stick nowhere else. A pair separates if all its points do, faster than tolerance::resting_speed times sqrt(g L) of its
/// smaller edge L, and times the speed of its faster body.
/// \param margin  [-] largest gap of touching surfaces, over the shortest edge of the pair
/// \return sorted by pair
/// \throws std::invalid_argument for a margin that is negative or not finite
/// \par Cost
/// One test of two boxes for each pair whose bounds overlap.
std::vector<Joint> find_joints(const World& world, double margin);

/// A joint of the scene: a ball holds a corner, a hinge an edge along its axis, a fixed joint an area.
///
/// Corners lie half the shortest edge of the two bodies from the anchor, so that turning shows in them as distance.
/// \return with the degrees of freedom that its kind holds
Joint joint_of(const World& world, const BodyJoint& joint);

/// The joints of a world after bodies were added or removed.
///
/// Existing joints stay, open or not, but for those of the scene; a new body sticks to the bodies that it touches.
/// \param before  the ids of the bodies then, by index
/// \param world   the present bodies
/// \param margin  [-] of find_joints(), for new bodies
/// \return sorted by pair
/// \throws std::invalid_argument for a margin that is negative or not finite
std::vector<Joint> renewed_joints(std::span<const Joint> joints, std::span<const BodyId> before,
                                  const World& world, double margin);

/// The point about which a joint is held: the mean of its corners, of the two of an edge, or the corner.
JointPoint held_point(const Joint& joint, std::span<const BodyState> states);

/// A corner of a joint.
/// \param corner  from 0, below the count
JointPoint corner_of(const Joint& joint, int corner, std::span<const BodyState> states);

/// Drift of a joint at the points where it is held.
struct JointGap {
  double opening = 0.0;  ///< [m] largest gap along the normal, 0 or above
  double overlap = 0.0;  ///< [m] deepest overlap along the normal, 0 or above
  double apart = 0.0;    ///< [m] largest distance of a corner's two positions
};

/// Measures a joint at its held corners: all of an area, two of an edge, one.
/// \param joint   see there; all results are 0 if nothing is held
/// \return maxima over its corners
JointGap gap_of(const Joint& joint, std::span<const BodyState> states);

/// Largest drift of several joints: maxima over all of them.
JointGap gap_of(std::span<const Joint> joints, std::span<const BodyState> states);

/// How far two bodies have turned against each other in a joint, as its corners show.
/// \param joint   with two corners or more
/// \return [rad] rotation vector of the second body, world frame, to first order; of an edge only its part across the edge
Vec3 turned_in(const Joint& joint, std::span<const BodyState> states);

/// Opening of an area that is held by an edge.
/// \param joint   with an area
/// \return [m] distance of the area's middle on the second body above the first body's plane; below 0 they
///         overlap
double opened(const Joint& joint, std::span<const BodyState> states);

}  // namespace tumble
