/// \file
/// \brief Swept boxes, and the bound that conservative advancement needs.
#include "tumble/geometry/swept.hpp"

#include "tumble/base/tolerances.hpp"

namespace tumble {
namespace {

constexpr int kAxes = 15;
constexpr double kNever = std::numeric_limits<double>::infinity();

// One of the 15 axes, of length 1, or zero for the cross product of parallel edges: the face axes
// stand in for it.
Vec3 axis_of(const Box& first, const Box& second, AxisIndex axis) {
  if (axis < 3) return first.axes_w.col(axis);
  if (axis < 6) return second.axes_w.col(axis - 3);
  const Vec3 n = first.axes_w.col((axis - 6) / 3).cross(second.axes_w.col((axis - 6) % 3));
  const double length = n.norm();
  return length < tolerance::parallel_edges ? Vec3(Vec3::Zero()) : Vec3(n / length);
}

}  // namespace

SweepResult sweep(const Box& first, const Vec3& displacement_first_w, const Box& second,
                  const Vec3& displacement_second_w) {
  require::finite(displacement_first_w, "displacement_first_w");
  require::finite(displacement_second_w, "displacement_second_w");
  const Vec3 d = second.center_w - first.center_w;
  const Vec3 u = displacement_second_w - displacement_first_w;

  double last_enter = -kNever;  // latest beginning of the 15 intervals
  double first_leave = kNever;  // earliest end
  double least_overlap = kNever;
  SweepResult entering;  // normal and axis at the last_enter
  SweepResult inside;    // normal and axis of least overlap at the start
  for (AxisIndex axis = 0; axis < kAxes; ++axis) {
    Vec3 n = axis_of(first, second, axis);
    if (n.isZero(0.0)) continue;
    if (n.dot(d) < 0.0) n = -n;  // from the first box to the second
    const double distance = n.dot(d);
    const double speed = n.dot(u);
    const double r = reach(first, n) + reach(second, n);

    // Apart along this axis and not getting closer: nothing else matters.
    if (distance > r && speed >= 0.0) return {};
    if (r - distance < least_overlap) {
      least_overlap = r - distance;
      inside.normal_w = n;
      inside.axis = axis;
    }
    if (speed == 0.0) continue;  // overlap along this axis for ever: no constraint

    // The interval of |distance + t speed| <= r.
    const double far = speed < 0.0 ? -r : r;
    first_leave = std::min(first_leave, (far - distance) / speed);
    const double enter = (-far - distance) / speed;
    if (enter > last_enter) {
      last_enter = enter;
      entering.normal_w = n;
      entering.axis = axis;
    }
  }

  if (least_overlap >= 0.0) {
    inside.status = SweepStatus::overlapping_at_start;
    inside.enter = 0.0;
    inside.leave = first_leave;
    return inside;
  }
  if (last_enter > first_leave || last_enter > 1.0) return {};
  entering.status = SweepStatus::hit;
  entering.enter = last_enter;
  entering.leave = first_leave;
  return entering;
}

double safe_time(double distance, const ClosingBound& bound) {
  const double u = bound.speed;
  const double a = bound.acceleration;
  // The first root of a τ²/2 + u τ = distance, in the form without cancellation.
  const double squared = u * u + 2.0 * a * distance;
  if (squared < 0.0) return kNever;  // turns back before it gets there
  if (u > 0.0) return 2.0 * distance / (u + std::sqrt(squared));
  return a > 0.0 ? (std::sqrt(squared) - u) / a : kNever;
}

}  // namespace tumble
