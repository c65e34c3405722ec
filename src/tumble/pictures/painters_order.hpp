/// \file
/// \brief In which order boxes are painted so that nearer ones cover farther ones.
#pragma once

#include "tumble/geometry/box.hpp"

#include <span>
#include <vector>

namespace tumble {

/// From where a picture is seen: from an eye, or from infinitely far away.
class ViewPoint {
 public:
  /// A perspective view.
  /// \param eye_w  [m] where the eye is, world frame
  /// \throws std::invalid_argument for a point that is not finite
  static ViewPoint from_eye(const Vec3& eye_w);

  /// An orthographic view.
  /// \param direction_w  [-] from the viewer into the scene, world frame, any length but 0
  /// \throws std::invalid_argument for a vector that is not finite or of length 0
  static ViewPoint along(const Vec3& direction_w);

  /// The line of sight through a point.
  /// \return [any] world frame, away from the viewer; its length has no meaning
  [[nodiscard]] Vec3 sight(const Vec3& point_w) const;

  /// On which side of a plane the viewer is.
  /// \param normal_w  [-] world frame, normal of the plane
  /// \param offset    [m] n.x of its points
  /// \return above 0: where the normal points to; 0: in the plane, seeing it edge-on
  [[nodiscard]] double side(const Vec3& normal_w, double offset) const;

  /// How far away a point is, for sorting.
  /// \return [m] from the eye, or along the direction
  [[nodiscard]] double depth(const Vec3& point_w) const;

 private:
  ViewPoint(bool perspective, const Vec3& vector) : perspective_(perspective), vector_(vector) {}

  bool perspective_;
  Vec3 vector_;  // the eye, or the direction of length 1
};

/// Groups of boxes, by their indices, to be painted from first to last. Several boxes are in one group if
/// none can be painted first: they overlap, or cover each other in a ring, as three long boxes can. Their
/// faces have to be cut: see back_to_front().
using PaintersOrder = std::vector<std::vector<int>>;

/// Whether two boxes can cover each other in a picture.
///
/// Two convex outlines are apart exactly if a line along an edge of one of them parts them. Such a
/// line is the image of a plane through an edge and the viewer, so 24 planes are tried, and nothing
/// has to be projected. Boxes may be anywhere: around the eye or behind it too. On opposite sides of
/// an eye the answer may be true although no line of sight meets both.
/// \return false if no line of sight passes through the inside of both
[[nodiscard]] bool views_overlap(const Box& first, const Box& second, const ViewPoint& view);

/// Sorts boxes so that each is painted after all that it covers.
///
/// Whatever separates two boxes in space shows which one may cover the other: of a plane in the
/// middle of the gap along the separating axis of largest gap, a line of sight first passes the side
/// of the viewer, so the box there is in front. The relation holds for pairs whose views overlap.
/// The rest is sorting: of the boxes that cover none which is still to be painted, the farthest is
/// painted first. If there is none, the smallest group that covers none outside it is.
///
/// Boxes that overlap slightly are ordered by the axis of least overlap, others are in one group.
/// \return the order; boxes at equal depth in the order of their indices
/// \par Cost
/// n²/2 pairs, about 1 µs each: for pictures, not for simulations.
/// \see Newell, Newell, Sancha, "A solution to the hidden surface problem", ACM 1972.
/// \verified{Every ray from the eye meets a box that was painted later before one painted earlier}
[[nodiscard]] PaintersOrder painters_order(std::span<const Box> boxes, const ViewPoint& view);

/// Sorts boxes for a perspective view.
/// \param eye_w  [m] where the eye is, world frame
/// \throws std::invalid_argument for an eye that is not finite
[[nodiscard]] inline PaintersOrder painters_order(std::span<const Box> boxes, const Vec3& eye_w) {
  return painters_order(boxes, ViewPoint::from_eye(eye_w));
}

}  // namespace tumble
