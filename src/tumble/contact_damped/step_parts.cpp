/// \file
/// \brief The parts into which the default technique divides a step in which bodies move far.
#include "tumble/contact_damped/step_parts.hpp"

#include "tumble/base/index.hpp"
#include "tumble/contact_damped/tolerances.hpp"
#include "tumble/dynamics/pair_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tumble {
namespace {

// [-] How closely the time of a fast meeting is found, as a share of the step. Reason: with 2^-14 a slider that crosses a tile in
// a step sinks in by two slops, with this by one. A share does not depend on the unit of time. (3.2)
constexpr double kMeetingResolution = 0x1p-16;

// Whether no two boxes can move by a share of their shortest edge against each other in a step, as at rest.
bool all_are_slow(const World& world, std::span<const MovingBody> bodies, double dt) {
  double edge = std::numeric_limits<double>::infinity();
  double speed = 0.0;
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    const BodyProperties& body = world.bodies()[k];
    if (body.shape != Shape::box) continue;
    edge = std::min(edge, body.size.minCoeff());
    if (!body.movable()) continue;
    speed = std::max(speed,
                     fastest_point_speed(body, bodies[k].velocity_w, bodies[k].angular_velocity_w));
  }
  return 2.0 * dt * speed <= tolerance::fast_way * edge;
}

// How far points of two boxes move against each other in a step, at most, as a share of the shortest edge.
double way_of_pair(const World& world, const IndexPair& pair, std::span<const MovingBody> bodies,
                   double dt) {
  const BodyProperties& a = world.bodies()[idx(pair.first)];
  const BodyProperties& b = world.bodies()[idx(pair.second)];
  if (a.shape == Shape::ground || b.shape == Shape::ground || !(a.movable() || b.movable()))
    return 0.0;
  const MovingBody& first = bodies[idx(pair.first)];
  const MovingBody& second = bodies[idx(pair.second)];
  const double speed =
      fastest_point_speed(a, second.velocity_w - first.velocity_w, first.angular_velocity_w) +
      fastest_point_speed(b, Vec3::Zero(), second.angular_velocity_w);
  return dt * speed / std::min(a.size.minCoeff(), b.size.minCoeff());
}

}  // namespace

int parts_of_motion(std::span<const ContactPatch> patches, std::span<const MovingBody> free,
                    double dt, int allowed) {
  if (allowed == 1) return 1;
  double most = 0.0;  // [-] way of a point in the step, as a share of the shortest edge
  for (const ContactPatch& patch : patches) {
    Six u = motion_of(patch, free[idx(patch.first)], free[idx(patch.second)]);
    if (patch.axis < 6) u[0] = u[1] = u[5] = 0.0;  // a face, or the ground
    for (const ContactPatchPoint& p : patch.used()) {
      const Vec3 way = dt * velocity_at(p.along, p.across, u);
      if (-way.z() > p.gap) most = std::max(most, way.norm() / patch.size);
    }
  }
  return static_cast<int>(
      std::clamp(std::ceil(most / tolerance::way_at_once), 1.0, static_cast<double>(allowed)));
}

double farthest_turn(std::span<const ContactPatch> patches, std::span<const MovingBody> bodies,
                     double dt) {
  double square = 0.0;
  for (const ContactPatch& patch : patches)
    for (const int body : {patch.first, patch.second})
      square = std::max(square, bodies[idx(body)].angular_velocity_w.squaredNorm());
  return dt * std::sqrt(square);
}

double time_to_fast_meeting(const World& world, std::span<const MovingBody> bodies,
                            std::span<const IndexPair> candidates, RotationRule rule, double dt) {
  if (all_are_slow(world, bodies, dt)) return dt;
  Flight flight;
  flight.bodies = world.bodies();
  flight.states = world.states();
  flight.gravity_w = world.gravity_w;
  flight.rule = rule;
  SearchOptions search;
  search.method = SearchMethod::conservative;
  search.resolution = kMeetingResolution * dt;
  double first = dt;
  for (const IndexPair& pair : candidates) {
    const double way = way_of_pair(world, pair, bodies, first);
    if (!(way > tolerance::fast_way)) continue;
    const PairCollision met = find_collision(flight, pair, 0.0, first, search);
    if (met.status != CollisionStatus::found) continue;
    const double at_once = first * tolerance::fast_way / way;
    first = std::min(first, met.time > 0.1 * at_once ? met.time : at_once);
  }
  return first;
}

}  // namespace tumble
