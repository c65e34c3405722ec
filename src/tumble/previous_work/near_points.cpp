/// \file
/// \brief Points near each other, and the move, of methods that move bodies by trust regions.
#include "tumble/previous_work/near_points.hpp"

#include "tumble/base/index.hpp"
#include "tumble/contact/repair.hpp"
#include "tumble/math/rotation.hpp"
#include "tumble/previous_work/tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace tumble {
namespace {

// Where edges cross, bodies turn so far in a step that the faces beside them go in: their corners are points too.
void add_corners(const World& world, double margin, Contact& contact) {
  if (contact.axis == kNoAxis) return;  // one of the two is the ground
  const IndexPair pair{contact.first, contact.second};
  Manifold manifold;
  if (!touch_pair(world, world.states(), pair, margin, contact.axis, manifold)) return;
  const auto box = [&](int k) { return box_of(world.bodies()[idx(k)], world.states()[idx(k)]); };
  add_face_points(box(pair.first), box(pair.second), margin, manifold);
  set_points(manifold, contact);
}

}  // namespace

void NearPoints::find(const World& world, std::span<const MovingBody> bodies, double margin,
                      StepReport& report) {
  std::swap(previous_, contacts_);
  repair_bounds(world, margin, bounds_);
  near_.find_pairs(bounds_, pairs_);
  const GatherReport found = gather_contacts(world, bodies, pairs_, margin, previous_, contacts_);
  report.pair_tests += found.pair_tests;
  report.deepest_overlap = found.deepest_overlap;
  for (Contact& contact : contacts_) add_corners(world, margin, contact);
  carry_over_impulses(previous_, contacts_);
  gaps_.clear();
  for (const Contact& contact : contacts_)
    for (int k = 0; k < contact.count; ++k) gaps_.push_back(contact.points[idx(k)].distance);
}

void NearPoints::scale_impulses(double factor) { tumble::scale_impulses(factor, contacts_); }

double meeting_margin(const World& world, std::span<const MovingBody> bodies, double dt) {
  double fastest = 0.0, edge = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    const BodyProperties& body = world.bodies()[k];
    if (!body.movable()) continue;
    fastest = std::max(fastest, bodies[k].velocity_w.norm() + dt * world.gravity_w.norm() +
                                    0.5 * body.size.norm() * bodies[k].angular_velocity_w.norm());
    edge = std::min(edge, body.size.minCoeff());
  }
  return std::isfinite(edge) ? std::min(2.0 * dt * fastest, tolerance::faure_reach * edge) : 0.0;
}

double farthest_move(const World& world, std::span<const MovingBody> moving) {
  double farthest = 0.0;
  for (std::size_t k = 0; k < moving.size(); ++k)
    farthest = std::max(farthest, fastest_point_speed(world.bodies()[k], moving[k].velocity_w,
                                                      moving[k].angular_velocity_w));
  return farthest;
}

void move_bodies(std::span<const MovingBody> moving, double share, World& world) {
  for (std::size_t k = 0; k < moving.size(); ++k) {
    if (!world.bodies()[k].movable()) continue;
    BodyState& state = world.states()[k];
    state.position_w += share * moving[k].velocity_w;
    state.orientation_wb = turned(state.orientation_wb, moving[k].angular_velocity_w, share);
  }
}

}  // namespace tumble
