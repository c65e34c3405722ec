/// \file
/// \brief Bodies that turn about the points on which they stand.
#include "tumble/contact/pivot_update.hpp"

#include "tumble/base/error.hpp"
#include "tumble/base/index.hpp"
#include "tumble/contact/effective_mass.hpp"
#include "tumble/contact/tolerances.hpp"
#include "tumble/math/elementary.hpp"
#include "tumble/math/rotation.hpp"

#include <algorithm>
#include <cmath>

namespace tumble {
namespace {

bool stays(const MovingBody& body) { return body.inverse_mass.isZero(0.0); }

// How fast turning moves the ends of a body.
double end_speed(const BodyProperties& body, const MovingBody& moving) {
  return stays(moving) ? 0.0 : 0.5 * body.size.norm() * moving.angular_velocity_w.norm();
}

}  // namespace

std::optional<PushedPair> pushed_pair(const Contact& contact) {
  PushedPair pair{contact.first, contact.second, Vec3::Zero(), contact.normal_w};
  double weight = 0.0;
  for (int k = 0; k < contact.count; ++k) {
    const ContactPoint& point = contact.points[idx(k)];
    if (!(point.normal_impulse > 0.0)) continue;
    pair.point_w += point.normal_impulse * point.position_w;
    weight += point.normal_impulse;
  }
  if (!(weight > 0.0)) return std::nullopt;
  pair.point_w /= weight;
  return pair;
}

void PivotUpdate::clear() {
  nodes_.clear();
  node_of_.clear();
  carried_.clear();
  groups_.clear();
  slides_.clear();
  placed_at_ = std::numeric_limits<double>::quiet_NaN();
}

void PivotUpdate::find(std::span<const BodyProperties> bodies, std::span<const MovingBody> moving,
                       std::span<const PushedPair> pairs, RigidAt rigid_at) {
  require::that(moving.size() == bodies.size(), "moving: one entry for each body is needed");
  clear();
  rigid_at_ = rigid_at;
  if (pairs.empty()) return;
  node_of_.assign(bodies.size(), -1);
  sort_pairs(bodies, moving, pairs);

  // [S6.2:standing]
  // Bodies that stand: breadth first from the immovable ones. Then the others,
  // each group from its first body.
  queue_.clear();
  for (std::size_t b = 0; b < bodies.size(); ++b)
    if (stays(moving[b])) queue_.push_back(static_cast<int>(b));
  grow(bodies, moving, pairs, -1);
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const bool alone = stuck_start_[b] == stuck_start_[b + 1] && on_wall_[b] == 0;
    if (node_of_[b] >= 0 || stays(moving[b]) || alone) continue;
    const int group = static_cast<int>(groups_.size());
    groups_.emplace_back();
    add_node(bodies[b], moving[b], static_cast<int>(b), group);
    queue_.assign(1, static_cast<int>(b));
    grow(bodies, moving, pairs, group);
  }
  // [S6.2:standing]

  for (std::size_t k = 0; k < pairs.size(); ++k) {
    if (sticks_[k] != 0) continue;
    const bool first_stays = stays(moving[idx(pairs[k].first)]);
    if (first_stays == stays(moving[idx(pairs[k].second)])) continue;
    const int body = first_stays ? pairs[k].second : pairs[k].first;
    const int node = node_of_[idx(body)];
    if (nodes_[idx(node)].group < 0) continue;  // it stands elsewhere
    groups_[idx(nodes_[idx(node)].group)].slides = true;
    slides_.push_back({node, pairs[k].point_w - moving[idx(body)].position_w, pairs[k].normal_w});
  }
  weigh_groups();
}

// Which pairs stick, the places of each body's among them, and which bodies slide on something immovable.
void PivotUpdate::sort_pairs(std::span<const BodyProperties> bodies,
                             std::span<const MovingBody> moving,
                             std::span<const PushedPair> pairs) {
  sticks_.assign(pairs.size(), 0);
  on_wall_.assign(bodies.size(), 0);
  stuck_start_.assign(bodies.size() + 1, 0);
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const PushedPair& pair = pairs[k];
    const auto count = static_cast<int>(bodies.size());
    require::that(std::min(pair.first, pair.second) >= 0 &&
                      std::max(pair.first, pair.second) < count && pair.first != pair.second,
                  "pairs: expected two bodies of the world each");
    const MovingBody& first = moving[idx(pair.first)];
    const MovingBody& second = moving[idx(pair.second)];
    if (stays(first) && stays(second)) continue;
    const double ends = std::max(end_speed(bodies[idx(pair.first)], first),
                                 end_speed(bodies[idx(pair.second)], second));
    const double slip = relative_velocity(first, second, pair.point_w).norm();
    if (slip <= tolerance::carried_slip * ends && pair.state != PushedState::slips) {
      sticks_[k] = 1;
      ++stuck_start_[idx(pair.first)];
      ++stuck_start_[idx(pair.second)];
    } else if (stays(first) || stays(second)) {
      on_wall_[idx(stays(first) ? pair.second : pair.first)] = 1;
    }
  }
  int sum = 0;
  for (int& start : stuck_start_) {
    sum += start;
    start = sum;
  }
  stuck_.resize(idx(sum));
  for (std::size_t k = pairs.size(); k-- > 0;) {  // backwards, so that places end ascending
    if (sticks_[k] == 0) continue;
    stuck_[idx(--stuck_start_[idx(pairs[k].first)])] = static_cast<int>(k);
    stuck_[idx(--stuck_start_[idx(pairs[k].second)])] = static_cast<int>(k);
  }
}

// Everything that sticks to the bodies of the queue, directly or over others.
void PivotUpdate::grow(std::span<const BodyProperties> bodies, std::span<const MovingBody> moving,
                       std::span<const PushedPair> pairs, int group) {
  for (std::size_t next = 0; next < queue_.size(); ++next) {
    const int here = queue_[next];
    for (int k = stuck_start_[idx(here)]; k < stuck_start_[idx(here) + 1]; ++k) {
      const PushedPair& pair = pairs[idx(stuck_[idx(k)])];
      const int other = pair.first == here ? pair.second : pair.first;
      if (node_of_[idx(other)] >= 0 || stays(moving[idx(other)])) continue;
      add_node(bodies[idx(other)], moving[idx(other)], other, group);
      Node& node = nodes_.back();
      node.parent = node_of_[idx(here)];
      node.arm_w = moving[idx(other)].position_w - pair.point_w;
      node.joint_w = pair.point_w - moving[idx(here)].position_w;
      if (pair.state == PushedState::held)
        node.slip_w = relative_velocity(moving[idx(here)], moving[idx(other)], pair.point_w);
      queue_.push_back(other);
    }
  }
}

void PivotUpdate::add_node(const BodyProperties& body, const MovingBody& moving, int index,
                           int group) {
  node_of_[idx(index)] = static_cast<int>(nodes_.size());
  carried_.push_back(index);
  Node& node = nodes_.emplace_back();
  node.body = index;
  node.group = group;
  node.mass = body.mass;
  node.velocity_w = moving.velocity_w;
  node.spin_w = moving.angular_velocity_w;
}

std::optional<Vec3> PivotUpdate::arm_w(int body) const {
  if (!carries(body)) return std::nullopt;
  const Node& node = nodes_[idx(node_of_[idx(body)])];
  if (node.parent < 0 && node.group >= 0) return std::nullopt;
  return node.arm_w;
}

void PivotUpdate::accelerate(std::span<const Acceleration> rates) {
  for (Node& node : nodes_) node.rate = rates[idx(node.body)];
  weigh_groups();
}

void PivotUpdate::set_velocities(std::span<const MovingBody> moving) {
  for (Node& node : nodes_) {
    node.velocity_w = moving[idx(node.body)].velocity_w;
    node.spin_w = moving[idx(node.body)].angular_velocity_w;
  }
  weigh_groups();
}

void PivotUpdate::set_velocity(int body, const MovingBody& moving) {
  const std::size_t k = idx(node_of_[idx(body)]);
  Node& node = nodes_[k];
  node.velocity_w = moving.velocity_w;
  if (std::isnan(placed_at_) || node.spin_w == moving.angular_velocity_w) return;
  offsets_w_[k] -= bend(node, turns_[k], placed_at_, node.arm_w);
  node.spin_w = moving.angular_velocity_w;
  turns_[k] = turn_of(node, placed_at_);
  offsets_w_[k] += bend(node, turns_[k], placed_at_, node.arm_w);
}

// Masses of groups, and how their centres move.
void PivotUpdate::weigh_groups() {
  placed_at_ = std::numeric_limits<double>::quiet_NaN();
  for (Group& group : groups_) group = Group{.slides = group.slides};
  for (const Node& node : nodes_) {
    if (node.group < 0) continue;
    Group& group = groups_[idx(node.group)];
    group.mass += node.mass;
    group.velocity_w += node.mass * node.velocity_w;
    group.acceleration_w += node.mass * node.rate.linear_w;
  }
  for (Group& group : groups_) {
    group.velocity_w /= group.mass;
    group.acceleration_w /= group.mass;
  }
}

// By how much the end of an arm leaves the way that its velocity predicts.
Vec3 PivotUpdate::bend(const Node& node, const Turn& turn, double time, const Vec3& arm_w) const {
  const Vec3 across_w = turn.vector_w.cross(arm_w);
  const Vec3 inwards_w = turn.cosine * turn.vector_w.cross(across_w);
  const Vec3 arc_w = (turn.sine - 1.0) * across_w + inwards_w;
  if (rigid_at_ == RigidAt::start)
    return arc_w + 0.5 * time * time * node.rate.angular_w.cross(arm_w);
  return arc_w - time * node.spin_w.cross(turn.sine * across_w + inwards_w);
}

PivotUpdate::Turn PivotUpdate::turn_of(const Node& node, double time) {
  Turn turn;
  turn.vector_w = time * node.spin_w + 0.5 * time * time * node.rate.angular_w;
  const double angle = turn.vector_w.norm();
  const double half = elementary::sinc(0.5 * angle);
  turn.sine = elementary::sinc(angle);
  turn.cosine = 0.5 * half * half;
  return turn;
}

// [S6.2:moving]
// Where everybody is at a time: parents first, then groups as wholes.
void PivotUpdate::place(double time) const {
  if (placed_at_ == time) return;
  const double half_square = 0.5 * time * time;
  placed_ = groups_;
  for (Group& group : placed_) group.shift_w = half_square * group.acceleration_w;
  turns_.resize(nodes_.size());
  offsets_w_.resize(nodes_.size());
  for (std::size_t k = 0; k < nodes_.size(); ++k) {
    const Node& node = nodes_[k];
    turns_[k] = turn_of(node, time);
    offsets_w_[k] = bend(node, turns_[k], time, node.arm_w) - time * node.slip_w;
    if (node.parent >= 0) {
      const std::size_t p = idx(node.parent);
      offsets_w_[k] += offsets_w_[p] + bend(nodes_[p], turns_[p], time, node.joint_w);
    }
    if (node.group >= 0)
      placed_[idx(node.group)].shift_w -= node.mass / placed_[idx(node.group)].mass * offsets_w_[k];
  }
  for (const Slide& slide : slides_) {
    const std::size_t k = idx(slide.node);
    Vec3& shift_w = placed_[idx(nodes_[k].group)].shift_w;
    const Vec3 off_w = offsets_w_[k] + shift_w + bend(nodes_[k], turns_[k], time, slide.joint_w);
    shift_w -= slide.normal_w.dot(off_w) * slide.normal_w;
  }
  for (std::size_t k = 0; k < nodes_.size(); ++k) {
    if (nodes_[k].group >= 0) offsets_w_[k] += placed_[idx(nodes_[k].group)].shift_w;
    offsets_w_[k] -= half_square * nodes_[k].rate.linear_w;
  }
  placed_at_ = time;
}
// [S6.2:moving]

Vec3 PivotUpdate::offset_w(int body, double time) const {
  place(time);
  return offsets_w_[idx(node_of_[idx(body)])];
}

void PivotUpdate::carry(int body, double time, BodyState& state) const {
  place(time);
  const std::size_t k = idx(node_of_[idx(body)]);
  const Node& node = nodes_[k];
  if (!turns_[k].vector_w.isZero(0.0))
    state.orientation_wb =
        normalised(rotation_from_vector(turns_[k].vector_w) * state.orientation_wb);
  state.position_w += offsets_w_[k];
  if (node.group < 0 || groups_[idx(node.group)].slides) return;
  const Group& group = groups_[idx(node.group)];
  const Vec3 common_w = group.velocity_w + time * group.acceleration_w;
  state.angular_momentum_w -= offsets_w_[k].cross(state.linear_momentum_w - node.mass * common_w);
}

double PivotUpdate::move(int body, double time, World& world) const {
  const BodyProperties& constant = world.bodies()[idx(body)];
  BodyState& state = world.states()[idx(body)];
  state.position_w += time * (constant.inverse_mass * state.linear_momentum_w);
  const Vec3 straight_w = state.position_w;
  const Vec3 spin_w = state.angular_momentum_w;
  carry(body, time, state);
  const Vec3 more_w = state.angular_momentum_w - spin_w;
  const double turning =
      0.5 * more_w.dot(inverse_inertia_w(constant, state.orientation_wb) * (2.0 * spin_w + more_w));
  return turning - constant.mass * world.gravity_w.dot(state.position_w - straight_w);
}

}  // namespace tumble
