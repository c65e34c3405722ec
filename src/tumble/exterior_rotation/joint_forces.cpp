/// \file
/// \brief Joint forces.
#include "tumble/exterior_rotation/joint_forces.hpp"

#include "tumble/base/error.hpp"
#include "tumble/base/index.hpp"
#include "tumble/contact/effective_mass.hpp"
#include "tumble/dynamics/step_mistakes.hpp"

#include <string>

namespace tumble {
namespace {

// Centripetal acceleration of a point of a body whose centre does not accelerate.
Vec3 centripetal(const MovingBody& body, const Vec3& point_w) {
  const Vec3& omega_w = body.angular_velocity_w;
  return omega_w.cross(omega_w.cross(point_w - body.position_w));
}

constexpr std::size_t kMostLoopRows = 600;  // a tenth of a second for each solve

}  // namespace

// The rows of all joints. The held point: relative velocity along the axes
// of the world. An edge: rotation except about itself. An area: all rotation.
void JointForces::assemble(std::span<const MovingBody> bodies, std::span<const Joint> joints,
                           std::span<const BodyState> states) {
  rows_.clear();
  pushes_.assign(joints.size(), Wrench{});
  // Sets of bodies united by areas. Any further joint between two of them is redundant and is left out:
  // once steps have opened a gap, its rows no longer depend exactly on others, and would get forces that
  // grow as one over the square of the gap.
  BodySets one(bodies, sets_);
  ties_.assign(joints.size(), 0);
  for (std::size_t j = 0; j < joints.size(); ++j)
    if (joints[j].hold == JointHold::area && one.join(joints[j].first, joints[j].second))
      ties_[j] = 1;
  for (std::size_t j = 0; j < joints.size(); ++j) {
    const Joint& joint = joints[j];
    if (joint.hold == JointHold::nothing) continue;
    if (ties_[j] == 0 && one.same(joint.first, joint.second)) continue;
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

// The rows as blocks. Joints that tie come first, so that they are in trees.
void JointForces::collect(std::span<const MovingBody> bodies) {
  blocks_.clear();
  at_.clear();
  for (const char ties : {char{1}, char{0}}) {
    for (std::size_t i = 0; i < rows_.size();) {
      const std::size_t begin = i;
      const int joint = rows_[begin].joint;
      JointRows block{.first = rows_[begin].first, .second = rows_[begin].second};
      for (; i < rows_.size() && rows_[i].joint == joint; ++i, ++block.count) {
        block.on_second.row(block.count) << rows_[i].along_w.transpose(),
            rows_[i].turn_second_w.transpose();
        block.on_first.row(block.count) << -rows_[i].along_w.transpose(),
            -rows_[i].turn_first_w.transpose();
      }
      if (ties_[idx(joint)] != ties) continue;
      blocks_.push_back(block);
      at_.push_back(begin);
    }
  }
  tree_.arrange(bodies, blocks_);
  loop_rows_.clear();
  for (const int loop : tree_.loops())
    for (int i = 0; i < blocks_[idx(loop)].count; ++i)
      loop_rows_.push_back(static_cast<int>(at_[idx(loop)]) + i);
  if (loop_rows_.size() > kMostLoopRows)
    refuse_step(std::to_string(loop_rows_.size()) + " rows of joints close loops: expected " +
                std::to_string(kMostLoopRows) + " at most; leave out joints that close loops");
}

// The force of a row on its bodies.
void JointForces::apply(const Row& row, double factor) {
  Vec6& first = body_part_[idx(row.first)];
  Vec6& second = body_part_[idx(row.second)];
  first.head<3>() -= factor * row.along_w;
  first.tail<3>() -= factor * row.turn_first_w;
  second.head<3>() += factor * row.along_w;
  second.tail<3>() += factor * row.turn_second_w;
}

// What a row sees of the accelerations.
double JointForces::seen_by(const Row& row) const {
  const Vec6& first = body_part_[idx(row.first)];
  const Vec6& second = body_part_[idx(row.second)];
  return row.along_w.dot(second.head<3>() - first.head<3>()) +
         row.turn_second_w.dot(second.tail<3>()) - row.turn_first_w.dot(first.tail<3>());
}

// Accelerations and forces with what the bodies feel in `body_part_`, and b for the joints of the tree.
void JointForces::solve_tree() {
  joint_part_.assign(blocks_.size(), Vec6::Zero());
  for (std::size_t j = 0; j < blocks_.size(); ++j)
    for (int i = 0; i < blocks_[j].count; ++i) joint_part_[j][i] = b_[at_[j] + idx(i)];
  tree_.solve(body_part_, joint_part_);
}

void JointForces::factor(std::span<const MovingBody> bodies) {
  ++solves_;
  collect(bodies);
  if (!tree_.factor(bodies, blocks_)) refuse_step("joint: its rows depend on one another");
  if (!loop_rows_.empty()) factor_loops(bodies);
}

// J W J' x = -b.
void JointForces::solve(std::span<const MovingBody> bodies) {
  factor(bodies);
  answer_.clear();
  if (!loop_rows_.empty()) {
    body_part_.assign(bodies.size(), Vec6::Zero());
    find_loop_forces();
  }
  // [S6.2:tree]
  // Forces of loops act on the bodies; the tree holds the rest.
  body_part_.assign(bodies.size(), Vec6::Zero());
  for (std::size_t k = 0; k < answer_.size(); ++k)
    apply(rows_[idx(loop_rows_[idx(factor_.indices()[k])])], answer_[k]);
  solve_tree();
  // [S6.2:tree]
  for (std::size_t j = 0; j < blocks_.size(); ++j)
    for (int i = 0; i < blocks_[j].count; ++i) b_[at_[j] + idx(i)] = joint_part_[j][i];
  for (const int row : loop_rows_) b_[idx(row)] = 0.0;
  for (std::size_t k = 0; k < answer_.size(); ++k)
    b_[idx(loop_rows_[idx(factor_.indices()[k])])] = answer_[k];
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const Row& row = rows_[i];
    pushes_[idx(row.joint)].force_w += b_[i] * row.along_w;
    pushes_[idx(row.joint)].torque_w += b_[i] * row.about_w;
  }
}

void JointForces::hold(const World& world, std::span<const MovingBody> bodies,
                       std::span<const Joint> joints, std::vector<Wrench>& rates,
                       std::span<const Wrench> pushes) {
  assemble(bodies, joints, world.states());
  rates.assign(bodies.size(), Wrench{});
  for (std::size_t k = 0; k < bodies.size(); ++k)
    if (world.bodies()[k].movable()) rates[k].force_w = world.bodies()[k].mass * world.gravity_w;
  for (std::size_t k = 0; k < pushes.size(); ++k) {
    if (!world.bodies()[k].movable()) continue;
    rates[k].force_w += pushes[k].force_w;
    rates[k].torque_w += pushes[k].torque_w;
  }

  // J a + dJ/dt v without joints. A free body: W g, and ω' = I^-1 (L x ω).
  const auto alone = [&](int body) {
    const MovingBody& m = bodies[idx(body)];
    const Vec3& momentum_w = world.states()[idx(body)].angular_momentum_w;
    Vec3 torque_w = momentum_w.cross(m.angular_velocity_w);
    if (!pushes.empty()) torque_w += pushes[idx(body)].torque_w;
    return Vec3(m.inverse_inertia_w * torque_w);
  };
  b_.assign(rows_.size(), 0.0);
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const Row& row = rows_[i];
    const MovingBody& first = bodies[idx(row.first)];
    const MovingBody& second = bodies[idx(row.second)];
    const auto falls = [&](int body) -> Vec3 {
      const BodyProperties& falling = world.bodies()[idx(body)];
      if (!falling.movable()) return Vec3::Zero();
      if (pushes.empty()) return world.gravity_w;
      return world.gravity_w + falling.inverse_mass * pushes[idx(body)].force_w;
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
