/// \file
/// \brief Whether two boxes that close their gap overlap.
#include "tumble/contact/meeting.hpp"

#include "tumble/base/index.hpp"
#include "tumble/contact/flush_edges.hpp"
#include "tumble/contact/tolerances.hpp"
#include "tumble/math/rotation.hpp"

#include <algorithm>

namespace tumble {
namespace {

double least_gap(const Manifold& found) {
  double gap = found.points[0].distance;
  for (int i = 1; i < found.count; ++i) gap = std::min(gap, found.points[idx(i)].distance);
  return gap;
}

// A box that has turned for a time as its body does.
Box turned_box(const Box& box, const MovingBody& body, double time) {
  Box out = box;
  out.axes_w = rotation_from_vector(time * body.angular_velocity_w) * box.axes_w;
  return out;
}

}  // namespace

MeetingFound find_meeting(const World& world, const IndexPair& pair, const Manifold& found,
                          double size, double touching, std::span<const MovingBody> bodies,
                          double dt) {
  const BodyProperties& a = world.bodies()[idx(pair.first)];
  const BodyProperties& b = world.bodies()[idx(pair.second)];
  if (a.shape == Shape::ground || b.shape == Shape::ground) return {};
  const double least = -tolerance::flush_height * size;
  const double gap = least_gap(found);
  const Box first = box_of(a, world.states()[idx(pair.first)]);
  Box second = box_of(b, world.states()[idx(pair.second)]);
  const Vec3 start_w = second.center_w;
  const Vec3 closer_w = -tolerance::flush_overlap * size * found.normal_w;
  const Separation straight = closed_along(first, second, found.normal_w, gap, size);
  if (straight.distance < least) return {};
  if (gap <= touching)
    return straight.distance < -least ? MeetingFound{Meeting::graze, straight.normal_w}
                                      : MeetingFound{};
  // As the bodies moved before the step, and turned: when they meet along the normal, and at the end of the step.
  const auto velocity_before = [&](int body) {
    const MovingBody& moving = bodies[idx(body)];
    return moving.inverse_mass.x() == 0.0 ? moving.velocity_w
                                          : Vec3(moving.velocity_w - dt * world.gravity_w);
  };
  const Vec3 velocity_w = velocity_before(pair.second) - velocity_before(pair.first);
  const double speed = -found.normal_w.dot(velocity_w);
  const double meets = speed > 0.0 ? gap / speed : dt;
  const auto overlap_after = [&](double time) {
    const double turns = std::min(time, dt);
    second.center_w = start_w + time * velocity_w + closer_w;
    return separation(turned_box(first, bodies[idx(pair.first)], turns),
                      turned_box(second, bodies[idx(pair.second)], turns))
               .distance < least;
  };
  if (overlap_after(meets) || (meets < dt && overlap_after(dt))) return {};
  return {Meeting::pass};
}

}  // namespace tumble
