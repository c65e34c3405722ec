/// \file
/// \brief For how long two bodies in flight surely stay apart (thesis 3.2, 5.1).
#include "tumble/dynamics/safe_flight.hpp"

#include "tumble/base/index.hpp"
#include "tumble/base/tolerances.hpp"

#include <algorithm>
#include <array>

namespace tumble {
namespace {

// A body that turns at a constant rate.
struct Turning {
  bool constant = false;                   // whether it does
  Vec3 position_w = Vec3::Zero();          // [m]
  Vec3 angular_velocity_w = Vec3::Zero();  // [rad/s]
  Mat3 axes_w = Mat3::Identity();
  std::array<Vec3, 8> arms_w;  // [m] of its corners
  std::size_t corners = 0;     // 1, of no length, for the ground: the plane does not leave it
  double radius = 0.0;         // [m] length of an arm
};

Turning turning_of(const Flight& flight, int body, double time) {
  Turning out;
  const BodyProperties& properties = flight.bodies[idx(body)];
  out.constant = turns_evenly(properties, flight.states[idx(body)], flight.rule);
  if (!out.constant) return out;
  const BodyState state = state_at(flight, body, time);
  out.position_w = state.position_w;
  if (properties.shape == Shape::ground) {
    out.arms_w[out.corners++].setZero();
    return out;
  }
  if (properties.movable()) out.angular_velocity_w = angular_velocity(properties, state);
  const Box box = box_of(properties, state);
  out.axes_w = box.axes_w;
  for (const Vec3& corner_w : corners_of(box))
    out.arms_w[out.corners++] = corner_w - state.position_w;
  out.radius = 0.5 * properties.size.norm();
  return out;
}

// How the plane between two bodies turns: with the face that it lies in, or so that it holds an edge
// of each.
Vec3 turning_of_plane(const Turning& first, const Turning& second, const Separation& gap) {
  if (gap.axis == kNoAxis) return Vec3::Zero();
  const Vec3& n = gap.normal_w;
  Vec3 rate_w = gap.axis < 3 ? first.angular_velocity_w : second.angular_velocity_w;
  if (gap.axis >= 6) {
    // An edge e of a body that turns at ω stays in the plane if n·((ω - ν) × e) = 0, that is, if
    // ν·m = ω·m with m = e × n. Two edges, and no spin about n.
    const int i = (gap.axis - 6) / 3;
    const int j = (gap.axis - 6) % 3;
    const Vec3 m1 = first.axes_w.col(i).cross(n);
    const Vec3 m2 = second.axes_w.col(j).cross(n);
    const double a = m1.squaredNorm();
    const double b = m1.dot(m2);
    const double c = m2.squaredNorm();
    const double det = a * c - b * b;
    if (!(det > tolerance::parallel_edges * a * c)) return Vec3::Zero();
    const double r1 = m1.dot(first.angular_velocity_w);
    const double r2 = m2.dot(second.angular_velocity_w);
    rate_w = ((c * r1 - b * r2) * m1 + (a * r2 - b * r1) * m2) / det;
  }
  return rate_w - n.dot(rate_w) * n;
}

// Corners as seen from the plane: how far behind the foremost one each is, and how fast it comes
// forward.
struct Corner {
  double behind = 0.0;  // [m]
  double speed = 0.0;   // [m/s] against the centre
};

std::size_t corners_along(const Turning& body, const Vec3& direction_w, const Vec3& plane_rate_w,
                          std::array<Corner, 8>& out) {
  double foremost = body.arms_w[0].dot(direction_w);
  for (std::size_t k = 1; k < body.corners; ++k)
    foremost = std::max(foremost, body.arms_w[k].dot(direction_w));
  const Vec3 relative_w = body.angular_velocity_w - plane_rate_w;
  for (std::size_t k = 0; k < body.corners; ++k)
    out[k] = {foremost - body.arms_w[k].dot(direction_w),
              direction_w.dot(relative_w.cross(body.arms_w[k]))};
  return body.corners;
}

}  // namespace

double safe_flight(const Flight& flight, const IndexPair& pair, const Separation& gap, double time,
                   double end) {
  const Vec3& n = gap.normal_w;
  const double rough = safe_time(gap.distance, closing_bound(flight, pair, n, time, end));
  if (time + rough >= end) return rough;
  const Turning first = turning_of(flight, pair.first, time);
  const Turning second = turning_of(flight, pair.second, time);
  if (!first.constant || !second.constant) return rough;

  const Vec3 plane_rate_w = turning_of_plane(first, second, gap);
  const double rate = plane_rate_w.norm();
  const Vec3 d_w = second.position_w - first.position_w;
  const Vec3 speed_w =
      velocity_at(flight, pair.second, time) - velocity_at(flight, pair.first, time);
  const double acceleration =
      (acceleration_of(flight, pair.second) - acceleration_of(flight, pair.first)).norm();
  const double left = end - time;
  const double fastest = speed_w.norm() + acceleration * left;
  double curvature = acceleration;
  if (rate > 0.0) curvature += rate * rate * (d_w.norm() + fastest * left) + 2.0 * rate * fastest;
  for (const Turning* body : {&first, &second}) {
    const double both = body->angular_velocity_w.norm() + rate;
    curvature += both * both * body->radius;
  }

  std::array<Corner, 8> ahead;
  std::array<Corner, 8> facing;
  const std::size_t count_ahead = corners_along(first, n, plane_rate_w, ahead);
  const std::size_t count_facing = corners_along(second, -n, plane_rate_w, facing);
  const double closing = -n.dot(speed_w) - plane_rate_w.cross(n).dot(d_w);
  double shortest = std::numeric_limits<double>::infinity();
  for (std::size_t a = 0; a < count_ahead; ++a)
    for (std::size_t b = 0; b < count_facing; ++b)
      shortest =
          std::min(shortest, safe_time(gap.distance + ahead[a].behind + facing[b].behind,
                                       {closing + ahead[a].speed + facing[b].speed, curvature}));
  return std::max(rough, shortest);
}

}  // namespace tumble
