/// \file
/// \brief Boxes for tests of geometry: by hand, at random, and cut by rays.
#pragma once

#include "tumble/base/random.hpp"
#include "tumble/geometry/separation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace tumble::test {

// A rotation.
// axis: [any] of any length
// angle: [rad]
// Returns [-] length 1
inline Quat about(const Vec3& axis, double angle) {
  return Quat(Eigen::AngleAxisd(angle, axis.normalized()));
}

// A cube of 1 m.
// center_w: [m]
inline Box cube_at(const Vec3& center_w, const Quat& orientation_wb = Quat::Identity()) {
  return make_box(center_w, orientation_wb, Vec3::Ones());
}

// A box along the axes of the world.
// center_w: [m]
// size: [m] full edges
inline Box upright(const Vec3& center_w, const Vec3& size) {
  return make_box(center_w, Quat::Identity(), size);
}

// A box anywhere in a cube, at any orientation.
// spread: [m] half the edge of the cube
// most: [m] by how much an edge may be longer than the shortest
// least: [m] the shortest edge
inline Box random_box(Random& random, double spread, double most, double least) {
  const Vec3 center = random.in_cube(spread);
  const Quat orientation = random.orientation();
  const Vec3 size = random.in_cube(most).cwiseAbs() + Vec3::Constant(least);
  return make_box(center, orientation, size);
}

// Where a ray is inside a box.
struct Stretch {
  double enter = -std::numeric_limits<double>::infinity();  // [-] in lengths of the direction
  double leave = std::numeric_limits<double>::infinity();   // [-] ditto
  // Whether the ray misses the box.
  [[nodiscard]] bool empty() const { return enter > leave || leave < 0.0; }
};

// Cuts a ray with the three slabs of a box.
// origin: [m] where the ray begins
// direction: [m] of any length
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

// Three sticks in the plane across the view, each over the next one at one end: they lean on each
// other like the flaps of a closed box.
inline std::vector<Box> ring_of_sticks() {
  std::vector<Box> sticks;
  for (int k = 0; k < 3; ++k) {
    const double angle = 2.0 * 3.14159265358979323846 / 3.0 * k;
    const Vec3 outwards(std::cos(angle), std::sin(angle), 0.0);
    const Vec3 along(-std::sin(angle), std::cos(angle), 0.0);
    // Tilted: one end is nearer to the viewer, at +z, than the other.
    const Vec3 axis = (along + 0.3 * Vec3::UnitZ()).normalized();
    Box stick{.center_w = 0.5 * outwards};
    stick.axes_w.col(0) = axis;
    stick.axes_w.col(1) = outwards;
    stick.axes_w.col(2) = axis.cross(outwards);
    stick.half = Vec3(1.5, 0.1, 0.05);
    sticks.push_back(stick);
  }
  return sticks;
}

}  // namespace tumble::test
