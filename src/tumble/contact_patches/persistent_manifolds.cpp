/// \file
/// \brief The contact patches of a step, kept while bodies rest.
#include "tumble/contact_patches/persistent_manifolds.hpp"

#include "tumble/base/index.hpp"
#include "tumble/contact/meeting.hpp"
#include "tumble/contact/movable_edge.hpp"
#include "tumble/contact_patches/grazed_edges.hpp"
#include "tumble/contact_patches/points_ahead.hpp"
#include "tumble/contact_patches/tolerances.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace tumble {
namespace {

// [-] Cosine of the angle (60 degrees) below which two contacts of a pair are on the same side. Reason: a box that slides off the
// top of a tile is beside it next, at a right angle; one that rolls turns by less in a step. (3.2)
constexpr double kSameSide = 0.5;

// The small rotation from one orientation to another, as a vector. A quaternion and its negative are the same.
Vec3 small_rotation(const Quat& from, const Quat& to) {
  const Quat change = to * from.conjugate();
  return (change.w() < 0.0 ? -2.0 : 2.0) * change.vec();
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

ContactPatch PersistentManifolds::make_patch(const World& world, const IndexPair& pair,
                                             const Manifold& manifold, const MovingBody& first,
                                             const MovingBody& second, double reach) {
  const BodyProperties& a = world.bodies()[idx(pair.first)];
  const BodyProperties& b = world.bodies()[idx(pair.second)];
  const BodyState& first_state = world.states()[idx(pair.first)];
  const BodyState& second_state = world.states()[idx(pair.second)];
  ContactPatch patch;
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
// in the step before, on the same side, has one although it would pass if nothing stopped it, and its edge has a height: what
// pushed it mostly does so again.
bool PersistentManifolds::look_for_patch(const World& world, const IndexPair& pair,
                                         std::span<const MovingBody> bodies, const Vec3& rest_w,
                                         const Vec3& gained_w, double dt,
                                         const ContactPatch* previous) {
  const MovingBody& first = bodies[idx(pair.first)];
  const MovingBody& second = bodies[idx(pair.second)];
  const double reach = reach_of_pair(world, pair, bodies, rest_w, dt);
  Manifold manifold;
  const AxisIndex axis = previous != nullptr ? previous->axis : kNoAxis;
  if (!find_points_ahead(world, pair, reach, axis, manifold)) return false;
  if (!can_meet(world, pair, bodies, rest_w, manifold, dt)) return false;
  const double size =
      movable_edge(world.bodies()[idx(pair.first)], world.bodies()[idx(pair.second)]);
  const MeetingFound met = find_meeting(world, pair, manifold, size, tolerance::contact_slop * size,
                                        bodies, gained_w, dt);
  const bool pushed = previous != nullptr && impulse_of(*previous)[six::normal] > 0.0 &&
                      previous->frame_w.col(2).dot(manifold.normal_w) > kSameSide;
  if (met.meeting == Meeting::pass && !pushed) return false;
  patches_.push_back(make_patch(world, pair, manifold, first, second, reach));
  if (!pushed) patches_.back().flat_w = met.flat_w;
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
    const double reach = reach_of_pair(world, pair, bodies, rest_w, dt);
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
    patch.steps_since_impact = std::min(patch.steps_since_impact + 1, ContactPatch::kNoImpact);
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

bool PersistentManifolds::add_points(const World& world, std::span<const MovingBody> bodies,
                                     double dt, ContactPatch& patch) {
  const IndexPair pair{patch.first, patch.second};
  const MovingBody& first = bodies[idx(pair.first)];
  const MovingBody& second = bodies[idx(pair.second)];
  const double reach = reach_of_pair(world, pair, bodies, velocity_of_rest(bodies), dt);
  Manifold manifold;
  if (!(reach > patch.built_reach) ||
      !find_points_ahead(world, pair, reach, patch.axis, manifold) || manifold.count <= patch.count)
    return false;
  ContactPatch more = make_patch(world, pair, manifold, first, second, reach);
  more.flat_w = patch.flat_w;
  more.carried_impulse = patch.carried_impulse;
  transfer_impulses(patch, more);
  set_for_step(pair, bodies, dt, more);
  patch = more;
  return true;
}

}  // namespace tumble
