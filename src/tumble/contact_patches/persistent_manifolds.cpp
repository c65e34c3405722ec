/// \file
/// \brief The contact patches of a step, kept while bodies rest.
#include "tumble/contact_patches/persistent_manifolds.hpp"

#include "tumble/base/index.hpp"
#include "tumble/contact/gather.hpp"
#include "tumble/contact/meeting.hpp"
#include "tumble/contact/movable_edge.hpp"
#include "tumble/contact_patches/grazed_edges.hpp"
#include "tumble/contact_patches/tolerances.hpp"
#include "tumble/geometry/nearest_point.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace tumble {
namespace {

// The small rotation from one orientation to another, as a vector. A quaternion and its negative are the same.
Vec3 small_rotation(const Quat& from, const Quat& to) {
  const Quat change = to * from.conjugate();
  return (change.w() < 0.0 ? -2.0 : 2.0) * change.vec();
}

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

// The velocity of a stopped body: that of immovable bodies, or if there are none the mean one, since
// bodies that all move together are at rest.
Vec3 velocity_of_rest(std::span<const MovingBody> bodies) {
  Vec3 sum_w = Vec3::Zero();
  for (const MovingBody& body : bodies) {
    if (body.inverse_mass.x() == 0.0) return Vec3::Zero();
    sum_w += body.velocity_w;
  }
  return bodies.empty() ? sum_w : Vec3(sum_w / static_cast<double>(bodies.size()));
}

// How far two bodies can approach each other by moving, in any direction. Other bodies may stop one of the two
// within the step, so that its own velocity does not count.
double approach_of_pair(const Vec3& rest_w, const MovingBody& first, const MovingBody& second,
                        double dt) {
  return dt * std::max({(second.velocity_w - first.velocity_w).norm(),
                        (first.velocity_w - rest_w).norm(), (second.velocity_w - rest_w).norm()});
}

// The same along a normal.
double approach_along(const Vec3& normal_w, const Vec3& rest_w, const MovingBody& first,
                      const MovingBody& second, double dt) {
  const double v = normal_w.dot(first.velocity_w - rest_w);
  const double w = normal_w.dot(rest_w - second.velocity_w);
  return dt * std::max({v + w, v, w, 0.0});
}

// All points at which a pair could come together within the step. Returns whether there are any.
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

// Indices and targets of a patch in this step.
void set_for_step(const IndexPair& pair, std::span<const MovingBody> bodies, double dt,
                  ContactPatch& patch) {
  patch.first = pair.first;
  patch.second = pair.second;
  set_targets(tolerance::contact_slop * patch.size, dt, patch);
  correct_targets_for_rotation(bodies[idx(pair.first)], bodies[idx(pair.second)], dt, patch);
}

// Whether its bodies overlap at the end of the step.
bool will_overlap(const ContactPatch& patch, std::span<const MovingBody> bodies, double dt) {
  const Six u = motion_of(patch, bodies[idx(patch.first)], bodies[idx(patch.second)]);
  return std::any_of(patch.used().begin(), patch.used().end(), [&](const ContactPatchPoint& p) {
    const double end = p.gap + dt * velocity_at(p.along, p.across, u).z();
    return end < -tolerance::contact_slop * patch.size;
  });
}

// Patches are in the order of the ids of their bodies.
bool comes_before(const ContactPatch& patch, BodyId first, BodyId second) {
  return patch.first_id != first ? patch.first_id < first : patch.second_id < second;
}

bool belongs_to(const ContactPatch& patch, BodyId first, BodyId second) {
  return patch.first_id == first && patch.second_id == second;
}

bool has_point_within(const Manifold& found, double reach) {
  return std::any_of(found.points.begin(), found.points.begin() + found.count,
                     [&](const ManifoldPoint& p) { return p.distance <= reach; });
}

}  // namespace

// The patch that a pair had in the step before, or nullptr. Pairs must come in ascending order.
ContactPatch* PersistentManifolds::previous_patch(BodyId first, BodyId second) {
  while (next_ < previous_.size() && comes_before(previous_[next_], first, second)) ++next_;
  const bool found = next_ < previous_.size() && belongs_to(previous_[next_], first, second);
  return found ? &previous_[next_++] : nullptr;
}

// Whether a patch can be kept; if so its gaps follow from how the bodies have moved since it was built.
bool PersistentManifolds::still_valid(const World& world, const IndexPair& pair,
                                      const MovingBody& first, const MovingBody& second,
                                      double reach, ContactPatch& patch) {
  if (first.inverse_mass.x() != patch.built_inverse_mass[0] ||
      second.inverse_mass.x() != patch.built_inverse_mass[1] ||
      !(reach <= tolerance::kept_reach * patch.built_reach))
    return false;
  std::array<Vec3, 2> moved_w;
  std::array<Vec3, 2> turned_w;
  const std::array<int, 2> body = {pair.first, pair.second};
  for (std::size_t k = 0; k < 2; ++k) {
    const BodyState& now = world.states()[idx(body[k])];
    moved_w[k] = now.position_w - patch.built_position_w[k];
    const double far = tolerance::kept_motion * patch.size;
    if (!(moved_w[k].squaredNorm() <= far * far)) return false;
    turned_w[k] = small_rotation(patch.built_orientation_wb[k], now.orientation_wb);
    if (!(turned_w[k].squaredNorm() <= tolerance::kept_motion * tolerance::kept_motion))
      return false;
  }
  const Vec3 move =
      patch.frame_w.transpose() * (moved_w[1] + turned_w[1].cross(patch.second_arm_w) - moved_w[0] -
                                   turned_w[0].cross(patch.first_arm_w));
  const Vec3 turn = patch.frame_w.transpose() * (turned_w[1] - turned_w[0]);
  for (ContactPatchPoint& p : patch.used()) {
    p.gap = p.built_gap + move[2] + turn[0] * p.across - turn[1] * p.along;
  }
  return true;
}

ContactPatch& PersistentManifolds::add_patch(const World& world, const IndexPair& pair,
                                             const Manifold& manifold, const MovingBody& first,
                                             const MovingBody& second, double reach) {
  const BodyProperties& a = world.bodies()[idx(pair.first)];
  const BodyProperties& b = world.bodies()[idx(pair.second)];
  const BodyState& first_state = world.states()[idx(pair.first)];
  const BodyState& second_state = world.states()[idx(pair.second)];
  ContactPatch& patch = patches_.emplace_back();
  patch.first_id = world.ids()[idx(pair.first)];
  patch.second_id = world.ids()[idx(pair.second)];
  patch.size = movable_edge(a, b);
  patch.stamp = ++built_;
  patch.friction = std::sqrt(a.friction * b.friction);
  patch.restitution = std::max(a.restitution, b.restitution);
  patch.built_position_w = {first_state.position_w, second_state.position_w};
  patch.built_orientation_wb = {first_state.orientation_wb, second_state.orientation_wb};
  patch.built_inverse_mass = {first.inverse_mass.x(), second.inverse_mass.x()};
  patch.built_reach = reach;
  build_patch(manifold, first, second, patch);
  return patch;
}

// Looks where a pair can come together within the step. If it can, a patch is added at the end. A pair that was pushed together
// in the step before has one although it would pass if nothing stopped it: what pushed it mostly does so again.
bool PersistentManifolds::look_for_patch(const World& world, const IndexPair& pair,
                                         std::span<const MovingBody> bodies, const Vec3& rest_w,
                                         const Vec3& gained_w, double dt,
                                         const ContactPatch* previous) {
  const MovingBody& first = bodies[idx(pair.first)];
  const MovingBody& second = bodies[idx(pair.second)];
  const double margin = margin_of(world, pair, bodies, dt);
  const double reach = approach_of_pair(rest_w, first, second, dt) + margin;
  Manifold manifold;
  const AxisIndex axis = previous != nullptr ? previous->axis : kNoAxis;
  if (!find_points_ahead(world, pair, reach, axis, manifold)) return false;
  const double approach = approach_along(manifold.normal_w, rest_w, first, second, dt);
  if (!has_point_within(manifold, approach + margin)) return false;
  const double size =
      movable_edge(world.bodies()[idx(pair.first)], world.bodies()[idx(pair.second)]);
  const MeetingFound met = find_meeting(world, pair, manifold, size, tolerance::contact_slop * size,
                                        bodies, gained_w, dt);
  const bool pushed = previous != nullptr && impulse_of(*previous)[six::normal] > 0.0;
  if (met.meeting == Meeting::pass && !pushed) return false;
  add_patch(world, pair, manifold, first, second, reach).flat_w = met.flat_w;
  return true;
}

ManifoldsFound PersistentManifolds::find(const World& world, std::span<const MovingBody> bodies,
                                         std::span<const IndexPair> candidates, double dt,
                                         double impulse_ratio) {
  ManifoldsFound found;
  std::swap(patches_, previous_);
  patches_.clear();
  next_ = 0;
  // At rest all patches are kept. They stay where they are then, and are copied from the first change on.
  std::size_t same = 0;
  bool all_kept = true;
  const auto copy_kept = [&] {
    if (!all_kept) return;
    all_kept = false;
    const auto begin = previous_.begin();
    patches_.insert(patches_.begin(), begin, begin + static_cast<std::ptrdiff_t>(same));
  };
  const Vec3 rest_w = velocity_of_rest(bodies);
  const Vec3 gained_w = dt * world.gravity_w;
  for (const IndexPair& pair : candidates) {
    const MovingBody& first = bodies[idx(pair.first)];
    const MovingBody& second = bodies[idx(pair.second)];
    if (!world.bodies()[idx(pair.first)].movable() && !world.bodies()[idx(pair.second)].movable())
      continue;
    const double reach =
        approach_of_pair(rest_w, first, second, dt) + margin_of(world, pair, bodies, dt);
    // [S6.3.1:kept]
    ContactPatch* const previous =
        previous_patch(world.ids()[idx(pair.first)], world.ids()[idx(pair.second)]);
    if (previous != nullptr && still_valid(world, pair, first, second, reach, *previous)) {
      if (previous != &previous_[same]) copy_kept();
      if (all_kept)
        ++same;
      else
        patches_.push_back(*previous);
    } else {
      ++found.pair_tests;
      if (!look_for_patch(world, pair, bodies, rest_w, gained_w, dt, previous)) continue;
      copy_kept();
      if (previous != nullptr) transfer_impulses(*previous, patches_.back());
    }
    // [S6.3.1:kept]
    ContactPatch& patch = all_kept ? previous_[same - 1] : patches_.back();
    set_for_step(pair, bodies, dt, patch);
    scale_impulses(impulse_ratio, patch);
    patch.carried_impulse = impulse_of(patch)[six::normal];
    for (const ContactPatchPoint& p : patch.used())
      found.deepest_overlap = std::max(found.deepest_overlap, -p.gap);
  }
  if (all_kept) {
    previous_.resize(same);
    std::swap(patches_, previous_);
  }
  drop_grazed_edges(bodies, patches_);
  for (const ContactPatch& patch : patches_) found.points += patch.count;
  return found;
}

void PersistentManifolds::shorten(std::span<const MovingBody> bodies, double dt, double ratio) {
  for (ContactPatch& patch : patches_) {
    set_for_step({patch.first, patch.second}, bodies, dt, patch);
    scale_impulses(ratio, patch);
    patch.carried_impulse *= ratio;
  }
}

int PersistentManifolds::add_missed(const World& world, std::span<const MovingBody> bodies,
                                    std::span<const IndexPair> candidates, double dt) {
  const std::size_t found = patches_.size();
  const std::uint64_t last = built_;
  const Vec3 rest_w = velocity_of_rest(bodies);
  const auto stays = [&](int body) { return bodies[idx(body)].inverse_mass.x() == 0.0; };
  // A sleeping body has to wake up first, in the next step.
  const auto sleeps = [&](int body) { return world.bodies()[idx(body)].movable() && stays(body); };
  std::size_t next = 0;
  for (const IndexPair& pair : candidates) {
    const BodyId first_id = world.ids()[idx(pair.first)];
    const BodyId second_id = world.ids()[idx(pair.second)];
    while (next < found && comes_before(patches_[next], first_id, second_id)) ++next;
    if (next < found && belongs_to(patches_[next], first_id, second_id)) continue;
    if ((stays(pair.first) && stays(pair.second)) || sleeps(pair.first) || sleeps(pair.second))
      continue;
    if (!look_for_patch(world, pair, bodies, rest_w, Vec3::Zero(), dt, nullptr)) continue;
    set_for_step(pair, bodies, dt, patches_.back());
    if (!will_overlap(patches_.back(), bodies, dt)) patches_.pop_back();
  }
  if (patches_.size() == found) return 0;
  std::inplace_merge(patches_.begin(), patches_.begin() + static_cast<std::ptrdiff_t>(found),
                     patches_.end(), [](const ContactPatch& a, const ContactPatch& b) {
                       return comes_before(a, b.first_id, b.second_id);
                     });
  drop_grazed_edges(bodies, patches_, last);
  return static_cast<int>(patches_.size() - found);
}

}  // namespace tumble
