/// \file
/// \brief Forces in ball joints, hinges and fixed joints, against a dense solver and against Featherstone's articulated bodies.
#include "tumble/exterior_rotation/joint_forces.hpp"

#include "previous_work/articulated_body.hpp"
#include "support/dense_solve.hpp"
#include "support/test.hpp"

TEST_CASE("Joints of all kinds give the accelerations of a dense solve", "[exact][joints]") {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    Random chance(seed);
    World world;
    constexpr int kBodies = 10;
    const BodyProperties wall = fixed_box_properties(Vec3::Ones());
    world.add(wall, Vec3::Zero());
    std::vector<std::pair<int, int>> rows_of;  // first row and count of each joint
    for (int k = 1; k < kBodies; ++k) {
      const BodyProperties box = box_properties(Vec3(1.0, 0.5, 0.7), chance.uniform(0.5, 3.0));
      const Vec3 place_w = chance.in_cube(2.0);
      const Quat turn = chance.orientation();
      const BodyId id = world.add(box, place_w, turn);
      const int parent = static_cast<int>(chance.uniform(0.0, 0.999) * k);
      const JointKind kind = joint_kinds()[static_cast<std::size_t>(chance.uniform(0.0, 2.999))];
      const Vec3 anchor_w = chance.in_cube(2.0);
      const Vec3 axis_w = chance.in_cube(1.0);
      world.join(kind, world.ids()[idx(parent)], id, anchor_w,
                 kind == JointKind::hinge ? axis_w : Vec3(Vec3::Zero()));
    }
    // J of all joints at rest, and J a = 0 with M a = f + J' λ.
    MatX J = MatX::Zero(6 * kBodies, 6 * kBodies);
    Eigen::Index row = 0;
    for (const BodyJoint& joint : world.joints()) {
      const int a = world.index_of(joint.bodies[0]), b = world.index_of(joint.bodies[1]);
      const BodyState& sa = world.states()[idx(a)];
      const BodyState& sb = world.states()[static_cast<std::size_t>(b)];
      const Mat3 arm_a = cross_matrix(sa.orientation_wb * joint.anchors_b[0]);
      const Mat3 arm_b = cross_matrix(sb.orientation_wb * joint.anchors_b[1]);
      J.block<3, 3>(row, 6 * a) = -Mat3::Identity();
      J.block<3, 3>(row, 6 * a + 3) = arm_a;
      J.block<3, 3>(row, 6 * b) = Mat3::Identity();
      J.block<3, 3>(row, 6 * b + 3) = -arm_b;
      row += 3;
      if (joint.kind == JointKind::ball) continue;
      Mat3 held = Mat3::Identity();
      if (joint.kind == JointKind::hinge) {
        const Vec3 axis_w = sa.orientation_wb * joint.axes_b[0];
        held -= axis_w * axis_w.transpose();
      }
      J.block<3, 3>(row, 6 * a + 3) = -held;
      J.block<3, 3>(row, 6 * b + 3) = held;
      row += 3;
    }
    MatX W = MatX::Zero(6 * kBodies, 6 * kBodies);
    VecX f = VecX::Zero(6 * kBodies);
    std::vector<MovingBody> moving = moving_bodies(world);
    for (int k = 0; k < kBodies; ++k) {
      const MovingBody& m = moving[idx(k)];
      W.block<3, 3>(6 * k, 6 * k) = m.inverse_mass.asDiagonal();
      W.block<3, 3>(6 * k + 3, 6 * k + 3) = m.inverse_inertia_w;
      if (k > 0) f.segment<3>(6 * k) = world.bodies()[idx(k)].mass * world.gravity_w;
    }
    const MatX JW = product(J, W);
    const VecX force = dense_solve(product(JW, J.transpose()), -product(JW, f));
    const VecX exact = product(W, f + product(J.transpose(), force));
    std::vector<Joint> joints;
    for (const BodyJoint& joint : world.joints()) joints.push_back(joint_of(world, joint));
    JointForces forces;
    std::vector<Wrench> rates;
    forces.hold(world, moving, joints, rates);
    const double scale = exact.cwiseAbs().maxCoeff();
    CAPTURE(seed);
    for (int k = 1; k < kBodies; ++k) {
      const MovingBody& m = moving[idx(k)];
      const Wrench& push = rates[idx(k)];
      CHECK((m.inverse_mass.cwiseProduct(push.force_w) - exact.segment<3>(6 * k)).norm() <
            1e-10 * scale);
      CHECK((m.inverse_inertia_w * push.torque_w - exact.segment<3>(6 * k + 3)).norm() <
            1e-10 * scale);
    }
  }
}

TEST_CASE("Balls and hinges in motion give Featherstone's accelerations", "[reference][joints]") {
  for (const int children : {1, 2}) {
    CAPTURE(children);
    CHECK(off_featherstone(HungBoxes(idx(children), 20, children, true)) < 1e-9);
  }
}
