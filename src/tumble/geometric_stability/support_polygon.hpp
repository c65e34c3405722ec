/// \file
/// \brief Outlines and supports as seen from above (thesis 5.4).
#pragma once

#include "tumble/geometry/box.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace tumble {

/// The corners of the lowest face of a box, seen from above: the face whose normal is nearest to down.
/// \return [m] x and z of each, in order around the face
[[nodiscard]] std::array<Vec2, 4> lower_corners(const Box& box);

/// The bits of all four lower corners.
inline constexpr std::uint8_t kAllCorners = 0b1111;

/// All corners of a box, seen from above.
/// \param corners  out: [m] x and z of each, in the order of Box
void corners_from_above(const Box& box, std::vector<Vec2>& corners);

/// The convex hull of points in a plane (Andrew's monotone chain).
/// \param points  in any order; sorted on return
/// \param hull    out: its corners, counterclockwise, without those within an edge
void convex_hull(std::vector<Vec2>& points, std::vector<Vec2>& hull);

/// Distance of a point from a convex polygon.
/// \param hull   from convex_hull(); may be a line or a point
/// \param point  [m]
/// \return [m] 0 inside, infinity for an empty hull
[[nodiscard]] double distance_to_hull(std::span<const Vec2> hull, const Vec2& point);

/// Whether a point lies in a convex polygon, or within a margin around it.
/// \param margin  [m] at least 0
/// \return false for an empty hull
[[nodiscard]] bool hull_contains(std::span<const Vec2> hull, const Vec2& point, double margin);

}  // namespace tumble
