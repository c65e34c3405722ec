/// \file
/// \brief The contact areas of a step, kept while bodies rest.
#include "tumble/contact_damped/persistent_manifolds.hpp"

#include "tumble/base/index.hpp"
#include "tumble/contact_damped/tolerances.hpp"
#include "tumble/geometry/ground.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace tumble {
namespace {

// The small rotation from one orientation to another, as a vector; the sign of a quaternion is no matter.
Vec3 small_rotation(const Quat& from, const Quat& to) {
  const Quat change = to * from.conjugate();
  return (change.w() < 0.0 ? -2.0 : 2.0) * change.vec();
}

double half_diagonal(const BodyProperties& body) {
  return body.movable() ? 0.5 * body.size.norm() : 0.0;
}

// Shortest edge of the movable bodies of a pair.
double size_of(const BodyProperties& a, const BodyProperties& b) {
  if (!a.movable()) return b.size.minCoeff();
  if (!b.movable()) return a.size.minCoeff();
  return std::min(a.size.minCoeff(), b.size.minCoeff());
}

// How far points of two bodies can come by turning in a step, and a margin that keeps a resting contact.
double margin_of(const BodyProperties& a, const BodyProperties& b, const MovingBody& first,
                 const MovingBody& second, double size, double dt) {
  return dt * (half_diagonal(a) * first.angular_velocity_w.norm() +
               half_diagonal(b) * second.angular_velocity_w.norm()) +
         tolerance::kept_margin * size;
}

// The velocity of who has been stopped: that of immovable bodies, or if there are none the mean one, since
// then all that moves together is at rest.
Vec3 still_of(std::span<const MovingBody> bodies) {
  Vec3 sum_w = Vec3::Zero();
  for (const MovingBody& body : bodies) {
    if (body.inverse_mass.x() == 0.0) return Vec3::Zero();
    sum_w += body.velocity_w;
  }
  return bodies.empty() ? sum_w : Vec3(sum_w / static_cast<double>(bodies.size()));
}

// How far two bodies can come towards each other by moving, in any direction. One of them may be stopped by
// others meanwhile, so that its own way does not count.
double way_of(const Vec3& still_w, const MovingBody& first, const MovingBody& second, double dt) {
  return dt * std::max({(second.velocity_w - first.velocity_w).norm(),
                        (first.velocity_w - still_w).norm(), (second.velocity_w - still_w).norm()});
}

// The same along a normal.
double way_along(const Vec3& normal_w, const Vec3& still_w, const MovingBody& first,
                 const MovingBody& second, double dt) {
  const double v = normal_w.dot(first.velocity_w - still_w);
  const double w = normal_w.dot(still_w - second.velocity_w);
  return dt * std::max({v + w, v, w, 0.0});
}

bool within(const Manifold& found, double reach) {
  return std::any_of(found.points.begin(), found.points.begin() + found.count,
                     [&](const ManifoldPoint& p) { return p.distance <= reach; });
}

bool touch(const World& world, const IndexPair& pair, double reach, AxisIndex remembered,
           Manifold& out) {
  const BodyProperties& a = world.bodies()[at(pair.first)];
  const BodyProperties& b = world.bodies()[at(pair.second)];
  if (a.shape == Shape::ground)
    return collide_with_ground(box_of(b, world.states()[at(pair.second)]), reach, out);
  const Box box = box_of(a, world.states()[at(pair.first)]);
  if (b.shape == Shape::ground) {
    const bool found = collide_with_ground(box, reach, out);
    flip(out);
    return found;
  }
  return collide(box, box_of(b, world.states()[at(pair.second)]), reach, remembered, out);
}

}  // namespace

// The area that a pair had in the step before, or nullptr. Pairs are asked for in ascending order.
ContactPatch* PersistentManifolds::take_old(BodyId first, BodyId second) {
  const auto before = [&](const ContactPatch& block) {
    return block.first_id != first ? block.first_id < first : block.second_id < second;
  };
  for (; next_ < before_.size() && before(before_[next_]); ++next_) {
  }
  const bool found = next_ < before_.size() && before_[next_].first_id == first &&
                     before_[next_].second_id == second;
  return found ? &before_[next_++] : nullptr;
}

// Whether an area is still good; if so its gaps follow from how the bodies have moved since it was found.
bool PersistentManifolds::keep(const World& world, const IndexPair& pair, const MovingBody& first,
                               const MovingBody& second, double reach, ContactPatch& block) const {
  if (first.inverse_mass.x() != block.built_inverse_mass[0] ||
      second.inverse_mass.x() != block.built_inverse_mass[1] ||
      !(reach <= tolerance::kept_reach * block.built_reach))
    return false;
  std::array<Vec3, 2> moved_w;
  std::array<Vec3, 2> turned_w;
  const std::array<int, 2> body = {pair.first, pair.second};
  for (std::size_t k = 0; k < 2; ++k) {
    const BodyState& now = world.states()[at(body[k])];
    moved_w[k] = now.position_w - block.built_position_w[k];
    const double far = tolerance::kept_motion * block.size;
    if (!(moved_w[k].squaredNorm() <= far * far)) return false;
    turned_w[k] = small_rotation(block.built_orientation_wb[k], now.orientation_wb);
    if (!(turned_w[k].squaredNorm() <= tolerance::kept_motion * tolerance::kept_motion))
      return false;
  }
  const Vec3 move =
      block.frame_w.transpose() * (moved_w[1] + turned_w[1].cross(block.second_arm_w) - moved_w[0] -
                                   turned_w[0].cross(block.first_arm_w));
  const Vec3 turn = block.frame_w.transpose() * (turned_w[1] - turned_w[0]);
  for (std::size_t i = 0; i < at(block.count); ++i) {
    ContactPatchPoint& p = block.points[i];
    p.gap = p.built_gap + move[2] + turn[0] * p.across - turn[1] * p.along;
  }
  return true;
}

ManifoldsFound PersistentManifolds::find(const World& world, std::span<const MovingBody> bodies,
                                         std::span<const IndexPair> candidates, double dt,
                                         double impulses) {
  ManifoldsFound found;
  std::swap(blocks_, before_);
  blocks_.clear();
  next_ = 0;
  const Vec3 still_w = still_of(bodies);
  Manifold manifold;
  for (const IndexPair& pair : candidates) {
    const BodyProperties& a = world.bodies()[at(pair.first)];
    const BodyProperties& b = world.bodies()[at(pair.second)];
    if (!a.movable() && !b.movable()) continue;
    const BodyId first_id = world.ids()[at(pair.first)];
    const BodyId second_id = world.ids()[at(pair.second)];
    const MovingBody& first = bodies[at(pair.first)];
    const MovingBody& second = bodies[at(pair.second)];
    const double size = size_of(a, b);
    const double margin = margin_of(a, b, first, second, size, dt);
    const double reach = way_of(still_w, first, second, dt) + margin;
    ContactPatch* const old = take_old(first_id, second_id);
    if (old != nullptr && keep(world, pair, first, second, reach, *old)) {
      blocks_.push_back(*old);
    } else {
      ++found.pair_tests;
      const AxisIndex axis = old != nullptr ? old->axis : kNoAxis;
      if (!touch(world, pair, reach, axis, manifold) ||
          !within(manifold, way_along(manifold.normal_w, still_w, first, second, dt) + margin))
        continue;
      ContactPatch& block = blocks_.emplace_back();
      block.first_id = first_id;
      block.second_id = second_id;
      block.size = size;
      block.stamp = ++built_;
      block.friction = std::sqrt(a.friction * b.friction);
      block.restitution = std::max(a.restitution, b.restitution);
      block.built_position_w = {world.states()[at(pair.first)].position_w,
                                world.states()[at(pair.second)].position_w};
      block.built_orientation_wb = {world.states()[at(pair.first)].orientation_wb,
                                    world.states()[at(pair.second)].orientation_wb};
      block.built_inverse_mass = {first.inverse_mass.x(), second.inverse_mass.x()};
      block.built_reach = reach;
      build_patch(manifold, first, second, block);
      if (old != nullptr) inherit(*old, block);
    }
    ContactPatch& block = blocks_.back();
    block.first = pair.first;
    block.second = pair.second;
    set_targets(tolerance::contact_damped_slop * block.size, dt, block);
    follow_arcs(first, second, dt, block);
    block.along_impulse *= impulses;
    block.across_impulse *= impulses;
    block.twist_impulse *= impulses;
    for (std::size_t i = 0; i < at(block.count); ++i) {
      block.points[i].impulse *= impulses;
      block.points[i].given *= impulses;
      found.deepest_overlap = std::max(found.deepest_overlap, -block.points[i].gap);
    }
    found.points += block.count;
  }
  return found;
}

}  // namespace tumble
