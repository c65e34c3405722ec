/// \file
/// \brief The distance function of a box.
#include "tumble/geometry/signed_distance.hpp"

#include "tumble/base/error.hpp"

namespace tumble {

SignedDistance signed_distance(const Box& box, const Vec3& point_w) {
  require::finite(point_w, "point_w");

  // [S3.3.2]
  // By symmetry it is enough to look at the octant of positive coordinates; the signs come back
  // at the end. A coordinate of 0 counts as positive, whichever zero it is.
  const Vec3 p = box.axes_w.transpose() * (point_w - box.center_w);
  const Vec3 side(p.x() < 0.0 ? -1.0 : 1.0, p.y() < 0.0 ? -1.0 : 1.0, p.z() < 0.0 ? -1.0 : 1.0);
  const Vec3 q = p.cwiseAbs() - box.half;

  // Outside: only the coordinates beyond their face count; the others are those of the nearest
  // point of the box as well.
  const Vec3 beyond = q.cwiseMax(0.0);
  const double distance = beyond.norm();
  if (distance > 0.0) return {distance, box.axes_w * side.cwiseProduct(beyond / distance)};

  // Inside: the nearest face is the one with the largest q, which is negative. maxCoeff takes the
  // lowest of equal ones.
  int nearest = 0;
  q.maxCoeff(&nearest);
  return {q[nearest], side[nearest] * box.axes_w.col(nearest)};
  // [S3.3.2]
}

}  // namespace tumble
