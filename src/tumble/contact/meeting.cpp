/// \file
/// \brief Whether two boxes that close their gap overlap.
#include "tumble/contact/meeting.hpp"

#include "tumble/base/index.hpp"
#include "tumble/contact/flush_edges.hpp"
#include "tumble/contact/tolerances.hpp"
#include "tumble/math/rotation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tumble {
namespace {

double least_gap(const Manifold& found) {
  double gap = found.points[0].distance;
  for (int i = 1; i < found.count; ++i) gap = std::min(gap, found.points[idx(i)].distance);
  return gap;
}

// A body as a box that moves and turns evenly.
struct MovingBox {
  Box box;
  Vec3 velocity_w;
  Vec3 spin_w;

  [[nodiscard]] Box turned(double time) const {
    return {box.center_w, rotation_from_vector(time * spin_w) * box.axes_w, box.half};
  }
  [[nodiscard]] Box moved(double time) const {
    Box out = turned(time);
    out.center_w += time * velocity_w;
    return out;
  }
  [[nodiscard]] double turning_speed() const { return spin_w.norm() * box.half.norm(); }
};

// Whether their motion alone would close the gap at a point within the step, as seen along the normal.
bool closes(const Manifold& found, const MovingBox& first, const MovingBox& second, double touching,
            double dt) {
  const auto last = found.points.begin() + found.count;
  return std::any_of(found.points.begin(), last, [&](const ManifoldPoint& p) {
    const Vec3 velocity_w = second.velocity_w - first.velocity_w +
                            second.spin_w.cross(p.position_w - second.box.center_w) -
                            first.spin_w.cross(p.position_w - first.box.center_w);
    return p.distance + dt * found.normal_w.dot(velocity_w) < -touching;
  });
}

// Whether two boxes never overlap by more than a slop within the step. The axis that separates them does so at least until
// their motion has closed the gap along it; then it has to be another one.
bool pass_each_other(const MovingBox& first, const MovingBox& second, double slop, double dt) {
  if (separation(first.moved(dt), second.moved(dt)).distance < -slop) return false;
  const SeparationOptions best{.prefer_faces = false,
                               .enough = std::numeric_limits<double>::infinity()};
  const double turning = first.turning_speed() + second.turning_speed();
  double time = 0.0;
  for (int k = 0; k < tolerance::passing_axes; ++k) {
    const Separation apart = separation(first.moved(time), second.moved(time), best);
    if (apart.distance < -0.99 * slop) return false;
    const double closing = turning - apart.normal_w.dot(second.velocity_w - first.velocity_w);
    if (!(dt * closing > apart.distance + slop)) return true;
    time += (apart.distance + slop) / closing;
    if (time >= dt) return true;
  }
  return false;
}

// Edges that lie on each other: beside two faces of the first box the boxes do not overlap by more than a height.
MeetingFound graze_beside_two_faces(const Box& first, const Box& second, double height) {
  MeetingFound met;
  std::size_t count = 0;
  for (int k = 0; k < 3 && count < 2; ++k) {
    const Vec3 axis_w = first.axes_w.col(k);
    const double apart = std::abs(axis_w.dot(second.center_w - first.center_w));
    if (apart - reach(first, axis_w) - reach(second, axis_w) > -height)
      met.flat_w[count++] = axis_w;
  }
  if (count < 2) return {};
  met.meeting = Meeting::graze;
  return met;
}

}  // namespace

MeetingFound find_meeting(const World& world, const IndexPair& pair, const Manifold& found,
                          double size, double touching, std::span<const MovingBody> bodies,
                          const Vec3& gained_w, double dt) {
  const BodyProperties& a = world.bodies()[idx(pair.first)];
  const BodyProperties& b = world.bodies()[idx(pair.second)];
  if (a.shape == Shape::ground || b.shape == Shape::ground) return {};
  const double height = tolerance::flush_height * size;
  const double gap = least_gap(found);
  const auto moving_box = [&](const BodyProperties& body, int k) {
    const MovingBody& moving = bodies[idx(k)];
    return MovingBox{box_of(body, world.states()[idx(k)]), moving.velocity_w,
                     moving.angular_velocity_w};
  };
  MovingBox first = moving_box(a, pair.first), second = moving_box(b, pair.second);
  bool pass =
      closes(found, first, second, touching, dt) && pass_each_other(first, second, touching, dt);
  // The same as the bodies moved before the step.
  if (bodies[idx(pair.first)].inverse_mass.x() != 0.0) first.velocity_w -= gained_w;
  if (bodies[idx(pair.second)].inverse_mass.x() != 0.0) second.velocity_w -= gained_w;
  pass = pass && pass_each_other(first, second, touching, dt);
  if (pass) return {Meeting::pass};
  if (gap <= height && found.axis >= 6) {
    const MeetingFound edges = graze_beside_two_faces(first.box, second.box, height);
    if (edges.meeting == Meeting::graze) return edges;
  }
  const Separation straight = closed_along(first.box, second.box, found.normal_w, gap, size);
  if (straight.distance < -height) return {};
  // It has no height if something holds the bodies where they are.
  const MeetingFound met = straight.distance < height
                               ? MeetingFound{Meeting::graze, {straight.normal_w, Vec3::Zero()}}
                               : MeetingFound{};
  if (gap <= touching) return met;
  // When they meet along the normal, and at the end of the step. Where they meet later other contacts close the gap.
  const double speed = -found.normal_w.dot(second.velocity_w - first.velocity_w);
  const double meets = speed > 0.0 ? std::min(gap / speed, dt) : dt;
  const double left = speed > 0.0 ? gap - meets * speed : 0.0;
  const auto overlap_after = [&](double time, double closed) {
    Box other = second.turned(time);
    other.center_w += time * (second.velocity_w - first.velocity_w) -
                      (closed + tolerance::flush_overlap * size) * found.normal_w;
    return separation(first.turned(time), other).distance < -height;
  };
  if (overlap_after(meets, left) || (meets < dt && overlap_after(dt, 0.0))) return met;
  return {Meeting::pass};
}

}  // namespace tumble
