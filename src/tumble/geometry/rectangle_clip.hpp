/// \file
/// \brief Clips a parallelogram to a rectangle: the core of contact areas (thesis 3.2).
///
/// Internal to geometry: callers use manifold.hpp.
#pragma once

#include <array>
#include <cstddef>

namespace tumble {

/// A corner of an area that is being clipped.
struct ClipCorner {
  /// [m] two coordinates in the plane of the rectangle, then the height above it
  std::array<double, 3> x;
  /// The line on which the area's boundary leaves this corner: 0-3 are the edges of the
  /// parallelogram, 4 and 5 the rectangle's sides at -x and +x, 6 and 7 those at -y and +y.
  std::size_t line;
};

/// An area that is being clipped, in order around its boundary.
struct ClipArea {
  /// A parallelogram has four corners, and each side of a rectangle adds at most one.
  static constexpr std::size_t kMostCorners = 8;

  std::size_t count = 0;                         ///< how many corners are used
  std::array<ClipCorner, kMostCorners> corners;  ///< the first `count`
};

/// Cuts off what sticks out of the rectangle |x| <= half_x, |y| <= half_y around the origin.
///
/// Each line bounds the result at most once, so the two lines that meet in a corner, the one on
/// which the boundary comes and the one on which it goes, name that corner uniquely.
/// \param area     in: the four corners of a parallelogram with lines 0 to 3; out: undefined
/// \param half_x   [m] half size of the rectangle
/// \param half_y   [m] half size of the rectangle
/// \return the rest, in the same sense of rotation: one of the two arguments
const ClipArea& clip_to_rectangle(ClipArea& area, ClipArea& scratch, double half_x, double half_y);

}  // namespace tumble
