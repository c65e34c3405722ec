/// \file
/// \brief Convex polygons in a plane, for pictures: hull, clipping, area.
#pragma once

#include "tumble/base/types.hpp"

#include <vector>

namespace tumble {

/// Corners of a polygon, in order; the last one is joined to the first.
using Polygon = std::vector<Vec2>;

/// All points p with n·p <= offset.
struct HalfPlane {
  Vec2 normal = Vec2::UnitX();  ///< [-] outwards; its length is the unit of the offset
  double offset = 0.0;          ///< [any] n·p on the border
};

/// The smallest convex polygon around points.
/// \param points  any number, in any order
/// \return its corners counter-clockwise (x right, y up), without points in the middle of an edge;
///         fewer than three if the points lie on a line
/// \see Andrew, "Another efficient algorithm for convex hulls in two dimensions", 1979.
[[nodiscard]] Polygon convex_hull(Polygon points);

/// The part of a polygon in a half-plane.
/// \param polygon     convex; a line is given as two points
/// \return its corners in the same sense of rotation; none if the intersection is empty
/// \see Sutherland, Hodgman, "Reentrant polygon clipping", CACM 1974.
[[nodiscard]] Polygon clipped(const Polygon& polygon, const HalfPlane& half_plane);

/// The part of a polygon in a convex polygon.
/// \param polygon  convex
/// \param convex   counter-clockwise
/// \param slack    [any] distance by which its edges are first moved outwards
[[nodiscard]] Polygon clipped(const Polygon& polygon, const Polygon& convex, double slack = 0.0);

/// The area of a polygon.
/// \param polygon  corners in order
/// \return above 0 if they run counter-clockwise (x right, y up)
[[nodiscard]] double area_of(const Polygon& polygon);

}  // namespace tumble
