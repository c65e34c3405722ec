/// \file
/// \brief Corners, reach and bounds of a box.
#include "tumble/geometry/box.hpp"

#include "tumble/base/error.hpp"

#include <cmath>

namespace tumble {

Box make_box(const Vec3& center_w, const Quat& orientation_wb, const Vec3& size) {
  require::finite(center_w, "center_w");
  require::unit(orientation_wb, "orientation_wb");
  require::positive(size.x(), "size.x");
  require::positive(size.y(), "size.y");
  require::positive(size.z(), "size.z");
  return Box{center_w, orientation_wb.toRotationMatrix(), 0.5 * size};
}

Vec3 corner_of(const Box& box, int corner) {
  Vec3 p = box.center_w;
  for (int i = 0; i < 3; ++i) {
    const double sign = (corner >> i & 1) != 0 ? 1.0 : -1.0;
    p += sign * box.half[i] * box.axes_w.col(i);
  }
  return p;
}

std::array<Vec3, 8> corners_of(const Box& box) {
  std::array<Vec3, 8> out;
  for (int k = 0; k < 8; ++k) out[static_cast<std::size_t>(k)] = corner_of(box, k);
  return out;
}

double reach(const Box& box, const Vec3& direction_w) {
  double sum = 0.0;
  for (int i = 0; i < 3; ++i) sum += box.half[i] * std::abs(box.axes_w.col(i).dot(direction_w));
  return sum;
}

Bounds bounds_of(const Box& box, double margin) {
  Vec3 extent;
  for (int k = 0; k < 3; ++k) {
    extent[k] = margin;
    for (int i = 0; i < 3; ++i) extent[k] += box.half[i] * std::abs(box.axes_w(k, i));
  }
  return Bounds{box.center_w - extent, box.center_w + extent};
}

}  // namespace tumble
