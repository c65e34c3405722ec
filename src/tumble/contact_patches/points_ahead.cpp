/// \file
/// \brief Points at which two bodies can come together within a step.
#include "tumble/contact_patches/points_ahead.hpp"

#include "tumble/base/index.hpp"
#include "tumble/contact/gather.hpp"
#include "tumble/contact/movable_edge.hpp"
#include "tumble/contact_patches/tolerances.hpp"
#include "tumble/geometry/nearest_point.hpp"

#include <algorithm>

namespace tumble {
namespace {

double half_diagonal(const BodyProperties& body) {
  return body.movable() ? 0.5 * body.size.norm() : 0.0;
}

// How far points of two bodies can come by turning in a step, and a margin that keeps a resting contact.
double margin_of(const World& world, const IndexPair& pair, std::span<const MovingBody> bodies,
                 double dt) {
  const BodyProperties& a = world.bodies()[idx(pair.first)];
  const BodyProperties& b = world.bodies()[idx(pair.second)];
  return dt * (half_diagonal(a) * bodies[idx(pair.first)].angular_velocity_w.norm() +
               half_diagonal(b) * bodies[idx(pair.second)].angular_velocity_w.norm()) +
         tolerance::kept_margin * movable_edge(a, b);
}

}  // namespace

Vec3 velocity_of_rest(std::span<const MovingBody> bodies) {
  Vec3 sum_w = Vec3::Zero();
  for (const MovingBody& body : bodies) {
    if (body.inverse_mass.x() == 0.0) return Vec3::Zero();
    sum_w += body.velocity_w;
  }
  return bodies.empty() ? sum_w : Vec3(sum_w / static_cast<double>(bodies.size()));
}

double reach_of_pair(const World& world, const IndexPair& pair, std::span<const MovingBody> bodies,
                     const Vec3& rest_w, double dt) {
  const Vec3& first_w = bodies[idx(pair.first)].velocity_w;
  const Vec3& second_w = bodies[idx(pair.second)].velocity_w;
  const double fastest = std::max(
      {(second_w - first_w).norm(), (first_w - rest_w).norm(), (second_w - rest_w).norm()});
  return dt * fastest + margin_of(world, pair, bodies, dt);
}

bool find_points_ahead(const World& world, const IndexPair& pair, double reach, AxisIndex axis,
                       Manifold& manifold) {
  const bool found = touch_pair(world, world.states(), pair, reach, axis, manifold);
  const BodyProperties& a = world.bodies()[idx(pair.first)];
  const BodyProperties& b = world.bodies()[idx(pair.second)];
  const double nearer = tolerance::corner_beside * movable_edge(a, b);
  const bool fast = reach > nearer;
  if (a.shape == Shape::ground || b.shape == Shape::ground || !(found || fast)) return found;
  const Box first = box_of(a, world.states()[idx(pair.first)]);
  const Box second = box_of(b, world.states()[idx(pair.second)]);
  if (found) add_face_points(first, second, reach, manifold);  // of the faces beside two edges
  if (fast) add_nearest_point(first, second, reach, nearer, manifold);  // of a corner beside a face
  return manifold.count > 0;
}

bool can_meet(const World& world, const IndexPair& pair, std::span<const MovingBody> bodies,
              const Vec3& rest_w, const Manifold& manifold, double dt) {
  const double v = manifold.normal_w.dot(bodies[idx(pair.first)].velocity_w - rest_w);
  const double w = manifold.normal_w.dot(rest_w - bodies[idx(pair.second)].velocity_w);
  const double near = dt * std::max({v + w, v, w, 0.0}) + margin_of(world, pair, bodies, dt);
  return std::any_of(manifold.points.begin(), manifold.points.begin() + manifold.count,
                     [&](const ManifoldPoint& p) { return p.distance <= near; });
}

}  // namespace tumble
