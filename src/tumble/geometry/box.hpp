/// \file
/// \brief The one solid shape of the thesis (3.1): a box anywhere in space.
#pragma once

#include "tumble/base/types.hpp"

#include <array>

namespace tumble {

/// A box at one instant, in the form that all geometry works on.
///
/// Corner k has the body coordinates (±h_x, ±h_y, ±h_z): bit 0 of k set means +x, bit 1 +y,
/// bit 2 +z. Face 2i is the one at -axis i, face 2i+1 the one at +axis i.
struct Box {
  Vec3 center_w = Vec3::Zero();     ///< [m] world frame
  Mat3 axes_w = Mat3::Identity();   ///< [-] columns: the box's own x, y, z in the world frame
  Vec3 half = Vec3::Constant(0.5);  ///< [m] half edge lengths along its own axes
};

/// Builds a box and checks every value.
/// \param size            [m] full edge lengths, each above 0
/// \throws std::invalid_argument for a value that is not finite, a size not above 0 or a
///         quaternion that is not of length 1
Box make_box(const Vec3& center_w, const Quat& orientation_wb, const Vec3& size);

/// One corner of a box.
/// \param corner  0 to 7, see Box
/// \return [m] world frame
Vec3 corner_of(const Box& box, int corner);

/// All corners of a box [m], world frame, in the order of Box.
std::array<Vec3, 8> corners_of(const Box& box);

/// How far a box reaches along a direction from its centre: \f$\sum_i h_i |a_i \cdot n|\f$.
/// \param direction_w  [-] world frame, need not be of length 1
/// \return [m] times the length of the direction
double reach(const Box& box, const Vec3& direction_w);

/// An axis-aligned box in the world that bounds a body.
struct Bounds {
  Vec3 low = Vec3::Zero();   ///< [m] smallest coordinates
  Vec3 high = Vec3::Zero();  ///< [m] largest coordinates
};

/// The smallest axis-aligned bounds of a box, widened on all sides.
/// \param margin  [m] how far to widen, at least 0
Bounds bounds_of(const Box& box, double margin = 0.0);

/// Whether two bounds share a point; touching counts.
inline bool overlap(const Bounds& a, const Bounds& b) {
  return (a.low.array() <= b.high.array()).all() && (b.low.array() <= a.high.array()).all();
}

}  // namespace tumble
