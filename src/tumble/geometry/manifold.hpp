/// \file
/// \brief Contact of two bodies: all points of the contact area (thesis 3.2).
#pragma once

#include "tumble/base/types.hpp"
#include "tumble/geometry/separation.hpp"

#include <array>
#include <cstdint>

namespace tumble {

/// The name of a contact point over time: which features of the two bodies meet there.
///
/// Equal in two steps means that the same corner or pair of edges still touches. Between two boxes
/// it holds the numbers of the two box edges that meet in the point: one of each box where edges
/// cross, two of the same box where its corner lies in a face of the other one. The name does not
/// depend on whose face the points were clipped to. Between ground and box it is the number of the
/// corner.
using FeatureId = std::uint32_t;

/// One point where two bodies touch, at one instant.
struct ManifoldPoint {
  Vec3 position_w = Vec3::Zero();  ///< [m] world frame, halfway between the two surfaces
  double distance = 0.0;           ///< [m] along the normal; below 0 the surfaces overlap
  FeatureId feature = 0;           ///< its name over time, unique within the manifold
};

/// All points where two bodies touch, with one common normal.
struct Manifold {
  /// The most points that two boxes can have: a rectangle clipped by a rectangle.
  static constexpr int kMostPoints = 8;

  Vec3 normal_w = Vec3::UnitY();  ///< [-] world frame, length 1, from the first body to the second
  AxisIndex axis = kNoAxis;       ///< which of the 15 axes; kNoAxis for box and ground
  int count = 0;                  ///< how many of the points are used, 0 if the bodies do not touch
  std::array<ManifoldPoint, kMostPoints> points;  ///< the first `count`, in order around the area
};

/// Finds where two boxes touch, once it is known along which direction.
///
/// Along a face axis: the face of the other box that looks back most is clipped to that face, and
/// the rest, at most an octagon, is the contact area (thesis 3.2). Along an edge axis: the one
/// point where the two edges pass each other. Points with distance <= margin are kept, so boxes
/// that exactly touch do so with margin 0. Where the clipped area shrinks to a line or a point,
/// two points or one are left.
///
/// Along the exact best axis boxes that overlap have a point, and the deepest one is as deep as
/// they are. Along another one (preferred or remembered) and for boxes that are apart the contact may
/// be missed: faces that do not lie over each other give no point, edges that pass beyond their ends
/// give one between their closest points. Edges that are parallel but for 1e-7 rad give the middle
/// of the stretch that they share or, from collide() for boxes that are apart, both ends of it.
/// \param found   what separation() said about the same two boxes
/// \param margin  [m] keep points up to this far apart, at least 0
/// \param out     is overwritten; count is 0 if the boxes are farther apart than the margin
/// \throws std::invalid_argument if the margin is negative or not finite, or `found` has no axis
/// \par Cost
/// About 100 ns for two faces (2026, one core of a server); without allocation.
/// \algorithm{The contact area of two boxes: section 3.2}
/// \verified{The contact of two stacked cubes has the area in which their faces overlap}
void find_manifold(const Box& first, const Box& second, const Separation& found, double margin,
                   Manifold& out);

/// Finds whether and where two boxes touch: separation() and find_manifold() in one.
///
/// Face axes and the remembered one are preferred, but not where they miss the contact: then the
/// memory is dropped, and if need be the preference. So boxes that overlap always have a point.
///
/// Without a remembered axis, no point of boxes turned against each other by up to 0.1 rad, with edges of
/// up to 1 : 1e6, is farther off either box than the margin, half the overlap at the point, and 1e-6 of the longest
/// edge.
/// \param margin      [m] boxes up to this far apart count as touching, at least 0
/// \param remembered  the axis in the manifold that the pair had before, or kNoAxis
/// \param out         is overwritten. If the boxes do not touch its count is 0 and its axis and
///                    normal are those of the direction that separates them: remember it
/// \throws std::invalid_argument if the margin is negative or not finite, or for an axis that is
///         none
/// \pre both boxes are finite with orthonormal axes (make_box sees to that)
/// \verified{Contact points of 100000 pairs of almost aligned boxes lie on both boxes}
/// \verified{Contact points of boxes of 1 to a million that meet in corners and edges lie on both boxes}
/// \par Cost and determinism
/// About 160 ns for two faces, 40 ns for boxes that are apart (2026, one core of a server); without
/// allocation. Face to face the same points come out whichever box is the first.
bool collide(const Box& first, const Box& second, double margin, AxisIndex remembered,
             Manifold& out);

/// Adds to the one point where two edges cross those where the faces beside these edges come near each other.
///
/// A box that rocks on an edge touches in one point at a time, first at one end, then at the other. A step that knows
/// only the first lets the second go in. Of the faces of both boxes the one is taken that looks most along the
/// normal; the other box's face opposite is clipped to it, and each corner of the clipped face is a point, with its
/// distance along the normal of the contact. Boxes with plane faces overlap exactly if one of these distances is below 0.
/// \param margin    [m] points up to this far apart are added, at least 0
/// \param manifold  as collide() found it; changed only if its axis is one of two edges and it has one point, which
///                  stays the first
/// \throws std::invalid_argument if the margin is negative or not finite
/// \verified{A beam across an edge gets a point at each end of the edge}
void add_face_points(const Box& first, const Box& second, double margin, Manifold& manifold);

/// Exchanges the roles of the two bodies: the normal turns round; points and names stay.
void flip(Manifold& manifold);

}  // namespace tumble
