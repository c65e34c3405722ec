/// \file
/// \brief Normals by the closest face and by the gradient of a distance.
#include "tumble/geometry/overlap_normals.hpp"

#include "tumble/base/tolerances.hpp"
#include "tumble/geometry/signed_distance.hpp"

#include <algorithm>
#include <cmath>

namespace tumble {
namespace {

// s(n) along a face axis, 0 to 5, with the normal from the first box to the second.
Separation along_face(const Box& first, const Box& second, AxisIndex axis) {
  const Vec3 n_w = axis < 3 ? first.axes_w.col(axis) : second.axes_w.col(axis - 3);
  const double along = n_w.dot(second.center_w - first.center_w);
  return Separation{std::abs(along) - reach(first, n_w) - reach(second, n_w),
                    along < 0.0 ? Vec3(-n_w) : n_w, axis};
}

// A surface point of one box, and the other box's distance there.
struct Probe {
  double distance = 0.0;  // [m] of the deepest point found so far; 0: none is inside
  AxisIndex axis = kNoAxis;
  Vec3 outward_w = Vec3::Zero();
};

// Looks at 26 points of `probing` from the distance function of `box`, whose axes have the numbers
// base to base + 2. A point must be deeper than what was found by more than a tie.
void probe(const Box& probing, const Box& box, AxisIndex base, double tie, Probe& deepest) {
  for (int i = 0; i < 27; ++i) {
    const Vec3 unit(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
    if (unit.isZero(0.0)) continue;
    const Vec3 point_w = probing.center_w + probing.axes_w * unit.cwiseProduct(probing.half);
    const SignedDistance found = signed_distance(box, point_w);
    if (!(found.distance < deepest.distance - tie)) continue;
    int axis = 0;  // inside, the gradient is one of the box's axes
    (box.axes_w.transpose() * found.gradient_w).cwiseAbs().maxCoeff(&axis);
    deepest = Probe{found.distance, base + axis, found.gradient_w};
  }
}

}  // namespace

Separation closest_face(const Box& first, const Box& second) {
  const double tie = tolerance::face_tie * std::min(first.half.minCoeff(), second.half.minCoeff());
  Separation best = along_face(first, second, 0);
  for (AxisIndex axis = 1; axis < 6; ++axis) {
    const Separation found = along_face(first, second, axis);
    if (found.distance > best.distance + tie) best = found;
  }
  return best;
}

Separation deepest_gradient(const Box& first, const Box& second) {
  const double tie = tolerance::face_tie * std::min(first.half.minCoeff(), second.half.minCoeff());
  Probe deepest;
  probe(second, first, 0, tie, deepest);
  const AxisIndex of_first = deepest.axis;
  probe(first, second, 3, tie, deepest);
  if (deepest.axis == kNoAxis) return {};
  // The second box leaves the first along the first one's gradient, or against its own.
  const Vec3 normal_w = deepest.axis == of_first ? deepest.outward_w : Vec3(-deepest.outward_w);
  const double along = normal_w.dot(second.center_w - first.center_w);
  return Separation{along - reach(first, normal_w) - reach(second, normal_w), normal_w,
                    deepest.axis};
}

}  // namespace tumble
