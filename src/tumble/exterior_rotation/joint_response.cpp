/// \file
/// \brief Effects of joints on pushes and on gaps: loops, responses, closing.
#include "tumble/base/index.hpp"
#include "tumble/exterior_rotation/joint_forces.hpp"
#include "tumble/exterior_rotation/tolerances.hpp"
#include "tumble/math/rotation.hpp"

#include <algorithm>
#include <cmath>

namespace tumble {

// What a row of a loop does to all of them, with the tree held, is a column of a matrix. Rows that depend on the tree
// or on earlier ones are left out.
void JointForces::factor_loops(std::span<const MovingBody> bodies) {
  const int n = static_cast<int>(loop_rows_.size());
  if (A_.rows() != n) A_.resize(n, n);
  std::vector<double> alone(loop_rows_.size());  // what a row does to itself without joints
  for (int j = 0; j < n; ++j) {
    const Row& row = rows_[idx(loop_rows_[idx(j)])];
    body_part_.assign(bodies.size(), Vec6::Zero());
    joint_part_.assign(blocks_.size(), Vec6::Zero());
    apply(row, 1.0);
    for (const int body : {row.first, row.second}) {
      const MovingBody& m = bodies[idx(body)];
      const Vec6& push = body_part_[idx(body)];
      alone[idx(j)] += push.head<3>().dot(m.inverse_mass.cwiseProduct(push.head<3>())) +
                       push.tail<3>().dot(m.inverse_inertia_w * push.tail<3>());
      if (m.inverse_mass.isZero(0.0)) body_part_[idx(body)].setZero();
    }
    tree_.solve(body_part_, joint_part_);
    for (int i = 0; i < n; ++i) A_(i, j) = seen_by(rows_[idx(loop_rows_[idx(i)])]);
  }
  // Scaled by a power of two, exactly, so that roots do not depend on the unit of mass.
  int exponent = 0;
  std::frexp(alone[0], &exponent);
  scale_ = std::ldexp(1.0, -exponent);
  for (int j = 0; j < n; ++j)
    for (int i = 0; i <= j; ++i) A_(i, j) = A_(j, i) = 0.5 * scale_ * (A_(i, j) + A_(j, i));
  factor_.clear(n);
  for (int i = 0; i < n; ++i)
    if (factor_.consider(A_, i) > tolerance::redundant_row * scale_ * alone[idx(i)])
      factor_.append_considered();
}

// Forces of the rows of loops, with what acts on the bodies in `body_part_`, and b.
void JointForces::find_loop_forces() {
  solve_tree();
  for (const int i : factor_.indices()) {
    const std::size_t row = idx(loop_rows_[idx(i)]);
    answer_.push_back(-scale_ * (b_[row] + seen_by(rows_[row])));
  }
  factor_.solve(answer_);
}

void JointForces::take(std::span<const MovingBody> bodies, std::span<const Joint> joints,
                       std::span<const BodyState> states) {
  assemble(bodies, joints, states);
  factor(bodies);
  b_.assign(rows_.size(), 0.0);
  immovable_.resize(bodies.size());
  for (std::size_t k = 0; k < bodies.size(); ++k)
    immovable_[k] = bodies[k].inverse_mass.isZero(0.0) ? 1 : 0;
}

void JointForces::respond(std::span<Vec6> parts) {
  const auto end_immovable = [&] {
    for (std::size_t k = 0; k < parts.size(); ++k)
      if (immovable_[k] != 0) body_part_[k].setZero();
  };
  body_part_.assign(parts.begin(), parts.end());
  end_immovable();
  if (!loop_rows_.empty()) {
    answer_.clear();
    find_loop_forces();
    body_part_.assign(parts.begin(), parts.end());
    for (std::size_t k = 0; k < answer_.size(); ++k)
      apply(rows_[idx(loop_rows_[idx(factor_.indices()[k])])], answer_[k]);
  }
  solve_tree();
  end_immovable();
  std::copy(body_part_.begin(), body_part_.end(), parts.begin());
}

void JointForces::close(std::span<const Joint> joints, World& world) {
  load_moving_bodies(world, closing_);
  assemble(closing_, joints, world.states());
  b_.assign(rows_.size(), 0.0);
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const Row& row = rows_[i];
    const Joint& joint = joints[idx(row.joint)];
    if (!joint.of_scene) continue;
    b_[i] = row.along_w.dot(row.point.second_w - row.point.first_w);
    if (joint.count > 1) b_[i] += row.about_w.dot(turned_in(joint, world.states()));
  }
  solve(closing_);
  body_part_.resize(closing_.size());  // the answer: displacements
  for (std::size_t k = 0; k < closing_.size(); ++k) {
    if (!world.bodies()[k].movable()) continue;
    BodyState& state = world.states()[k];
    state.position_w += body_part_[k].head<3>();
    state.orientation_wb =
        normalised(rotation_from_vector(body_part_[k].tail<3>()) * state.orientation_wb);
  }
}

}  // namespace tumble
