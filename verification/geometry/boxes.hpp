/// \file
/// \brief Boxes for tests of geometry: by hand, at random, and cut by rays.
#pragma once

#include "tumble/base/random.hpp"
#include "tumble/geometry/separation.hpp"

#include <algorithm>
#include <limits>
#include <vector>

namespace tumble::test {

/// A rotation.
/// \param axis   [any] of any length
/// \param angle  [rad]
/// \return [-] length 1
inline Quat about(const Vec3& axis, double angle) {
  return Quat(Eigen::AngleAxisd(angle, axis.normalized()));
}

/// A cube of 1 m.
/// \param center_w        [m]
/// \param orientation_wb  [-]
/// \return it
inline Box cube_at(const Vec3& center_w, const Quat& orientation_wb = Quat::Identity()) {
  return make_box(center_w, orientation_wb, Vec3::Ones());
}

/// A box along the axes of the world.
/// \param center_w  [m]
/// \param size      [m] full edges
/// \return it
inline Box upright(const Vec3& center_w, const Vec3& size) {
  return make_box(center_w, Quat::Identity(), size);
}

/// A box anywhere in a cube, at any orientation.
/// \param random  where the numbers come from
/// \param spread  [m] half the edge of the cube
/// \param most    [m] by how much an edge may be longer than the shortest
/// \param least   [m] the shortest edge
/// \return it
inline Box random_box(Random& random, double spread, double most, double least) {
  const Vec3 center = random.in_cube(spread);
  const Quat orientation = random.orientation();
  const Vec3 size = random.in_cube(most).cwiseAbs() + Vec3::Constant(least);
  return make_box(center, orientation, size);
}

/// Where a ray is inside a box.
struct Stretch {
  double enter = -std::numeric_limits<double>::infinity();  ///< [-] in lengths of the direction
  double leave = std::numeric_limits<double>::infinity();   ///< [-] ditto
  /// Whether the ray misses the box.
  /// \return also for a box behind the eye
  [[nodiscard]] bool empty() const { return enter > leave || leave < 0.0; }
};

/// Cuts a ray with the three slabs of a box.
/// \param box        the box
/// \param origin     [m] where the ray begins
/// \param direction  [m] of any length
/// \return where it is inside
inline Stretch stretch_in(const Box& box, const Vec3& origin, const Vec3& direction) {
  const Vec3 o = box.axes_w.transpose() * (origin - box.center_w);
  const Vec3 d = box.axes_w.transpose() * direction;
  Stretch out;
  for (int k = 0; k < 3; ++k) {
    const double t1 = (-box.half[k] - o[k]) / d[k], t2 = (box.half[k] - o[k]) / d[k];
    out.enter = std::max(out.enter, std::min(t1, t2));
    out.leave = std::min(out.leave, std::max(t1, t2));
  }
  return out;
}

}  // namespace tumble::test
