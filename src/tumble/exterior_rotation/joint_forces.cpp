/// \file
/// \brief Joint forces.
#include "tumble/exterior_rotation/joint_forces.hpp"

#include "tumble/base/index.hpp"
#include "tumble/contact/effective_mass.hpp"
#include "tumble/exterior_rotation/tolerances.hpp"

#include <algorithm>
#include <cmath>

namespace tumble {
namespace {

// Centripetal acceleration of a point of a body whose centre does not accelerate.
Vec3 centripetal(const MovingBody& body, const Vec3& point_w) {
  const Vec3& omega_w = body.angular_velocity_w;
  return omega_w.cross(omega_w.cross(point_w - body.position_w));
}

// Sets of bodies united by areas. Any further joint between two of them is redundant and is left out:
// once steps have opened a gap, its rows no longer depend exactly on others, and would get forces that
// grow as one over the square of the gap.
class OneBody {
 public:
  explicit OneBody(std::span<const MovingBody> bodies) : parent_(bodies.size()) {
    int wall = -1;  // all immovable bodies are one set
    for (std::size_t k = 0; k < bodies.size(); ++k) {
      const bool movable = !bodies[k].inverse_mass.isZero(0.0);
      if (!movable && wall < 0) wall = static_cast<int>(k);
      parent_[k] = movable ? static_cast<int>(k) : wall;
    }
  }
  // Whether the two were separate until now.
  bool join(int a, int b) {
    a = root_of(a);
    b = root_of(b);
    parent_[idx(std::max(a, b))] = std::min(a, b);
    return a != b;
  }
  [[nodiscard]] bool same(int a, int b) const { return root_of(a) == root_of(b); }

 private:
  [[nodiscard]] int root_of(int body) const {
    while (parent_[idx(body)] != body) body = parent_[idx(body)];
    return body;
  }
  std::vector<int> parent_;
};

}  // namespace

// The rows of all joints. The held point: relative velocity along the axes
// of the world. An edge: rotation except about itself. An area: all rotation.
void JointForces::assemble(std::span<const MovingBody> bodies, std::span<const Joint> joints,
                           std::span<const BodyState> states) {
  rows_.clear();
  pushes_.assign(joints.size(), Wrench{});
  OneBody one(bodies);
  std::vector<bool> ties(joints.size());  // unites two bodies
  for (std::size_t j = 0; j < joints.size(); ++j)
    ties[j] = joints[j].hold == JointHold::area && one.join(joints[j].first, joints[j].second);
  for (std::size_t j = 0; j < joints.size(); ++j) {
    const Joint& joint = joints[j];
    if (joint.hold == JointHold::nothing) continue;
    if (!ties[j] && one.same(joint.first, joint.second)) continue;
    Row row;
    row.point = held_point(joint, states);
    const JointPoint& point = row.point;
    row.joint = static_cast<int>(j);
    row.first = joint.first;
    row.second = joint.second;
    // [S6.2:rows]
    for (int axis = 0; axis < 3; ++axis) {
      row.along_w = Vec3::Unit(axis);
      row.turn_first_w = (point.first_w - bodies[idx(joint.first)].position_w).cross(row.along_w);
      row.turn_second_w =
          (point.second_w - bodies[idx(joint.second)].position_w).cross(row.along_w);
      rows_.push_back(row);
    }
    if (joint.hold == JointHold::corner) continue;
    row.along_w.setZero();
    const Mat3 first_wb = states[idx(joint.first)].orientation_wb.toRotationMatrix();
    Mat3 axes_w = first_wb;
    if (joint.hold == JointHold::edge) {  // two directions across the edge, fixed in the first body
      const std::size_t next = idx((joint.side + 1) % joint.count);
      const Tangents across = tangents_of(
          (joint.corners_first_b[next] - joint.corners_first_b[idx(joint.side)]).normalized());
      axes_w.col(0) = first_wb * across.first_w;
      axes_w.col(1) = first_wb * across.second_w;
    }
    const int held = joint.hold == JointHold::edge ? 2 : 3;
    for (int axis = 0; axis < held; ++axis) {
      row.about_w = row.turn_first_w = row.turn_second_w = axes_w.col(axis);
      rows_.push_back(row);
    }
    // [S6.2:rows]
  }
}

// J W J' x = -b; rows that depend on earlier ones are left out.
void JointForces::solve(std::span<const MovingBody> bodies) {
  const int n = static_cast<int>(rows_.size());
  ++solves_;
  if (A_.rows() != n) A_.resize(n, n);
  // Motion of row i for a unit force of row j, by way of one body.
  const auto seen = [&](const Row& i, const Row& j, int body, bool i_second, bool j_second) {
    const MovingBody& m = bodies[idx(body)];
    const Vec3& turn_i = i_second ? i.turn_second_w : i.turn_first_w;
    const Vec3& turn_j = j_second ? j.turn_second_w : j.turn_first_w;
    const double sign = i_second == j_second ? 1.0 : -1.0;
    return sign * (i.along_w.dot(m.inverse_mass.cwiseProduct(j.along_w)) +
                   turn_i.dot(m.inverse_inertia_w * turn_j));
  };
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j <= i; ++j) {
      const Row& a = rows_[idx(i)];
      const Row& b = rows_[idx(j)];
      double sum = 0.0;
      if (a.first == b.first) sum += seen(a, b, a.first, false, false);
      if (a.first == b.second) sum += seen(a, b, a.first, false, true);
      if (a.second == b.first) sum += seen(a, b, a.second, true, false);
      if (a.second == b.second) sum += seen(a, b, a.second, true, true);
      A_(i, j) = A_(j, i) = sum;
    }
  }
  // Scaled by a power of two, exactly, so that roots do not depend on the unit of mass.
  int exponent = 0;
  if (n > 0) std::frexp(A_(0, 0), &exponent);
  A_ *= std::ldexp(1.0, -exponent);
  factor_.clear(n);
  for (int i = 0; i < n; ++i)
    if (factor_.consider(A_, i) > tolerance::redundant_row * A_(i, i)) factor_.append_considered();
  answer_.clear();
  for (const int i : factor_.indices()) answer_.push_back(-b_[idx(i)]);
  factor_.solve(answer_);
  std::fill(b_.begin(), b_.end(), 0.0);
  for (std::size_t k = 0; k < answer_.size(); ++k)
    b_[idx(factor_.indices()[k])] = std::ldexp(answer_[k], -exponent);
  for (int i = 0; i < n; ++i) {
    const Row& row = rows_[idx(i)];
    pushes_[idx(row.joint)].force_w += b_[idx(i)] * row.along_w;
    pushes_[idx(row.joint)].torque_w += b_[idx(i)] * row.about_w;
  }
}

void JointForces::hold(const World& world, std::span<const MovingBody> bodies,
                       std::span<const Joint> joints, std::vector<Wrench>& rates) {
  assemble(bodies, joints, world.states());
  rates.assign(bodies.size(), Wrench{});
  for (std::size_t k = 0; k < bodies.size(); ++k)
    if (world.bodies()[k].movable()) rates[k].force_w = world.bodies()[k].mass * world.gravity_w;

  // J a + dJ/dt v without joints. A free body: W g, and ω' = I^-1 (L x ω).
  const auto alone = [&](int body) {
    const MovingBody& m = bodies[idx(body)];
    const Vec3& momentum_w = world.states()[idx(body)].angular_momentum_w;
    return Vec3(m.inverse_inertia_w * momentum_w.cross(m.angular_velocity_w));
  };
  b_.assign(rows_.size(), 0.0);
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const Row& row = rows_[i];
    const MovingBody& first = bodies[idx(row.first)];
    const MovingBody& second = bodies[idx(row.second)];
    const auto falls = [&](int body) -> Vec3 {
      return world.bodies()[idx(body)].movable() ? world.gravity_w : Vec3::Zero();
    };
    // [S6.2:arcs]
    b_[i] = row.along_w.dot(falls(row.second) + centripetal(second, row.point.second_w) -
                            falls(row.first) - centripetal(first, row.point.first_w)) +
            row.turn_second_w.dot(alone(row.second)) - row.turn_first_w.dot(alone(row.first)) +
            (second.angular_velocity_w - first.angular_velocity_w)
                .dot(first.angular_velocity_w.cross(row.about_w));
    // [S6.2:arcs]
  }
  solve(bodies);
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const Row& row = rows_[i];
    rates[idx(row.second)].force_w += b_[i] * row.along_w;
    rates[idx(row.second)].torque_w += b_[i] * row.turn_second_w;
    rates[idx(row.first)].force_w -= b_[i] * row.along_w;
    rates[idx(row.first)].torque_w -= b_[i] * row.turn_first_w;
  }
}

void JointForces::project(std::span<MovingBody> bodies, std::span<const Joint> joints,
                          std::span<const BodyState> states) {
  assemble(bodies, joints, states);
  b_.assign(rows_.size(), 0.0);
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const Row& row = rows_[i];
    const MovingBody& first = bodies[idx(row.first)];
    const MovingBody& second = bodies[idx(row.second)];
    b_[i] = row.along_w.dot(second.velocity_w - first.velocity_w) +
            row.turn_second_w.dot(second.angular_velocity_w) -
            row.turn_first_w.dot(first.angular_velocity_w);
  }
  solve(bodies);
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const Row& row = rows_[i];
    MovingBody& first = bodies[idx(row.first)];
    MovingBody& second = bodies[idx(row.second)];
    second.velocity_w += b_[i] * second.inverse_mass.cwiseProduct(row.along_w);
    second.angular_velocity_w += b_[i] * (second.inverse_inertia_w * row.turn_second_w);
    first.velocity_w -= b_[i] * first.inverse_mass.cwiseProduct(row.along_w);
    first.angular_velocity_w -= b_[i] * (first.inverse_inertia_w * row.turn_first_w);
    first.changed = second.changed = true;
  }
}

}  // namespace tumble
