/// \file
/// \brief The corners of a box that touch the ground.
#include "tumble/geometry/ground.hpp"

#include "tumble/base/error.hpp"

#include <cmath>

namespace tumble {

bool collide_with_ground(const Box& box, double margin, Manifold& out) {
  require::not_negative(margin, "margin");
  out.normal_w = Vec3::UnitY();
  out.axis = kNoAxis;
  out.count = 0;

  // The face that looks down most, at one end of axis m: only its corners can touch.
  int m = 0;
  for (int i = 1; i < 3; ++i)
    if (std::abs(box.axes_w(1, i)) > std::abs(box.axes_w(1, m))) m = i;
  const int k = (m + 1) % 3, l = (m + 2) % 3;
  const int on_face = box.axes_w(1, m) > 0.0 ? 0 : 1 << m;

  // Around it: neither k nor l positive, k, both, l.
  for (const int offset : {0, 1 << k, 1 << k | 1 << l, 1 << l}) {
    const int corner = on_face | offset;
    const Vec3 position_w = corner_of(box, corner);
    const double height = position_w.y();
    if (height > margin) continue;
    ManifoldPoint& point = out.points[static_cast<std::size_t>(out.count++)];
    point.position_w = Vec3(position_w.x(), 0.5 * height, position_w.z());
    point.distance = height;
    point.feature = static_cast<FeatureId>(corner);
  }
  return out.count > 0;
}

}  // namespace tumble
