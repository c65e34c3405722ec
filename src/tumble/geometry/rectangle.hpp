/// \file
/// \brief How much of two rectangles in a plane overlaps (thesis 3.2).
///
/// The thesis asks for the area in which two faces touch; this is its planar core.
#pragma once

#include "tumble/base/types.hpp"

#include <array>

namespace tumble {

/// A rectangle anywhere in the plane.
struct Rectangle {
  Vec2 center = Vec2::Zero();       ///< [m]
  Vec2 axis = Vec2::UnitX();        ///< [-] direction of its first edge, length 1
  Vec2 half = Vec2::Constant(0.5);  ///< [m] half edge lengths, along axis and across it
};

/// A convex polygon of at most eight corners.
struct Polygon {
  /// The most corners that two rectangles can have in common.
  static constexpr int kMostCorners = 8;

  int count = 0;                           ///< how many corners are used; 0 if it is empty
  std::array<Vec2, kMostCorners> corners;  ///< [m] the first `count`, counter-clockwise
};

/// What two rectangles have in common.
/// \param a  the one
/// \param b  the other
/// \return the polygon; rectangles that exactly touch share one or two corners
/// \throws std::invalid_argument for values that are not finite, an axis that is not of length 1
///         or a half size that is not above 0
Polygon intersection(const Rectangle& a, const Rectangle& b);

/// The area of a polygon.
/// \param polygon  corners counter-clockwise
/// \return [m^2] at least 0 up to rounding
double area(const Polygon& polygon);

}  // namespace tumble
