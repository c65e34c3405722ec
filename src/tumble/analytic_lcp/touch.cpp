/// \file
/// \brief The state of a contact point: about to collide, colliding, at rest, or separating.
#include "tumble/analytic_lcp/touch.hpp"

#include "tumble/analytic_lcp/tolerances.hpp"
#include "tumble/base/index.hpp"
#include "tumble/base/tolerances.hpp"
#include "tumble/contact/effective_mass.hpp"
#include "tumble/contact/tolerances.hpp"
#include "tumble/geometry/bounding_tree.hpp"

#include <algorithm>
#include <cmath>

namespace tumble {
double pair_size(const World& world, int first, int second) {
  return shortest_edge(world.bodies()[idx(first)], world.bodies()[idx(second)]);
}

TouchScale touch_scale(const World& world, int first, int second, double dt) {
  TouchScale scale{.size = pair_size(world, first, second)};
  const double g = world.gravity_w.norm();
  scale.resting_speed = g > 0.0 ? tolerance::resting_speed * std::sqrt(g * scale.size)
                                : tolerance::resting_speed_weightless * (scale.size / dt);
  return scale;
}

PointMotion motion_of(const ContactPoint& point, const TouchScale& scale) {
  if (point.approach_speed > scale.resting_speed) return PointMotion::parts;
  if (point.approach_speed >= -scale.resting_speed) return PointMotion::rests;
  return point.distance > tolerance::contact_gap * scale.size ? PointMotion::waits
                                                              : PointMotion::collides;
}

GatherReport gather_near(const World& world, std::span<const MovingBody> bodies,
                         std::span<const IndexPair> candidates, std::span<const Contact> previous,
                         ContactList& out) {
  // One margin for all, that of the largest body; then each pair's own.
  double largest = 0.0;
  for (const BodyProperties& body : world.bodies())
    if (body.movable()) largest = std::max(largest, body.size.minCoeff());
  const GatherReport report = gather_contacts(world, bodies, candidates,
                                              tolerance::contact_margin * largest, previous, out);
  keep_points(out, [&](const Contact& contact, const ContactPoint& point) {
    return point.distance <=
           tolerance::contact_margin * pair_size(world, contact.first, contact.second);
  });
  carry_over_impulses(previous, out);
  return report;
}

void gather_near(const World& world, std::span<const MovingBody> bodies, ContactList& out) {
  // Each grown by its own margin, which is no less than that of any pair it is in.
  std::vector<Bounds> bounds;
  for (std::size_t b = 0; b < world.bodies().size(); ++b) {
    const BodyProperties& body = world.bodies()[b];
    bounds.push_back(
        bounds_of(body, world.states()[b], tolerance::contact_margin * body.size.norm()));
  }
  std::vector<IndexPair> pairs;
  BoundingTree().find_pairs(bounds, pairs);
  gather_near(world, bodies, pairs, {}, out);
}

void pairs_after(const World& world, std::span<const MovingBody> bodies,
                 std::span<const Contact> resting, std::span<const IndexPair> candidates,
                 double time, std::vector<IndexPair>& out) {
  out.clear();
  std::vector<int> sliders;
  for (const Contact& c : resting) {
    out.push_back({c.first, c.second});
    if (world.bodies()[idx(c.first)].shape == Shape::ground ||
        world.bodies()[idx(c.second)].shape == Shape::ground)
      continue;
    const double far = tolerance::far_slide * pair_size(world, c.first, c.second);
    const Vec3 u_w =
        relative_velocity(bodies[idx(c.first)], bodies[idx(c.second)], c.points[0].position_w);
    if (time * (u_w - c.normal_w.dot(u_w) * c.normal_w).norm() <= far) continue;
    sliders.push_back(c.first);
    sliders.push_back(c.second);
  }
  if (sliders.empty()) return;
  std::sort(sliders.begin(), sliders.end());
  const auto slides = [&](int body) {
    return std::binary_search(sliders.begin(), sliders.end(), body);
  };
  for (const IndexPair& pair : candidates)
    if (slides(pair.first) || slides(pair.second)) out.push_back(pair);
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
}

}  // namespace tumble
