/// \file
/// \brief Ball joints, hinges and fixed joints of a scene under `glued`: closed forms and second opinions.
#include "tumble/base/random.hpp"
#include "tumble/dynamics/energy.hpp"
#include "tumble/exterior_rotation/glued.hpp"
#include "tumble/math/rotation.hpp"
#include "tumble/scenes/simulation.hpp"

#include "previous_work/articulated_body.hpp"
#include "support/catch.hpp"
#include "support/scenes.hpp"

#include <Eigen/Dense>

#include <numbers>

namespace {

using namespace tumble;
using namespace tumble::test;

// The largest distance of a joint's two sides, at its corners.
double apart(const Simulation& run) {
  double most = 0.0;
  for (const BodyJoint& joint : run.world().joints())
    most = std::max(most, gap_of(joint_of(run.world(), joint), run.world().states()).apart);
  return most;
}

// Two boxes in flight without gravity, joined where they touch.
Simulation flying_pair(JointKind kind) {
  Scene scene;
  scene.gravity_w.setZero();
  SceneBox a;
  a.name = "a";
  a.size = Vec3(1.0, 0.4, 0.6);
  a.mass = 2.0;
  a.angular_velocity_w = Vec3(0.7, 2.0, -1.1);
  SceneBox b = a;
  b.name = "b";
  b.size = Vec3(0.5, 0.8, 0.3);
  b.mass = 1.0;
  b.position_w = Vec3(0.75, 0.0, 0.0);
  b.orientation_wb = rotation_from_vector(Vec3(0.3, 0.0, 0.0));
  const Vec3 anchor_w(0.5, 0.0, 0.0), axis_w(0.6, 0.0, 0.8);
  if (kind == JointKind::hinge) b.angular_velocity_w += 3.0 * axis_w;
  b.velocity_w =
      a.angular_velocity_w.cross(anchor_w) + b.angular_velocity_w.cross(b.position_w - anchor_w);
  scene.boxes = {a, b};
  scene.joints = {
      {"", kind, "a", "b", anchor_w, kind == JointKind::hinge ? axis_w : Vec3(Vec3::Zero())}};
  return Simulation(scene, "glued");
}

}  // namespace

TEST_CASE("A link on a hinge swings with the period of a physical pendulum", "[exact][joints]") {
  constexpr double amplitude = 0.02;  // [rad]
  constexpr double length = 0.5, thick = 0.1;
  Simulation run(built("pendulum", {{"count", "1"}, {"angle", "0.02"}}), "glued");
  constexpr double dt = 1.0 / 240.0;
  // When the spin changes its sign: half a period each.
  std::vector<double> turns;
  double before = 0.0;
  while (turns.size() < 21) {
    run.step(dt);
    const double now = run.body("link1").angular_velocity_w().z();
    if (before != 0.0 && (now > 0.0) != (before > 0.0))
      turns.push_back(run.world().time() - dt * now / (now - before));
    before = now;
  }
  const double inertia = (length * length + thick * thick) / 12.0 + 0.25 * length * length;
  const double period = 2.0 * std::numbers::pi * std::sqrt(inertia / (kGravity * 0.5 * length)) *
                        (1.0 + amplitude * amplitude / 16.0);
  // Measured: 4e-8, mostly of the sign change by a straight line.
  CHECK((turns.back() - turns.front()) / 10.0 == near(period).epsilon(1e-6));
}

TEST_CASE("A double pendulum keeps its energy to the fourth order of the step", "[exact][joints]") {
  const auto error = [](int rate) {
    Simulation run(built("pendulum", {}), "glued");
    const double start = energy_of(run.world()).total();
    double most = 0.0;
    for (int k = 0; k < 2 * rate; ++k) {
      run.step(1.0 / rate);
      most = std::max(most, std::abs(energy_of(run.world()).total() - start));
    }
    return most / (kGravity * 0.5);  // over m g L
  };
  const double coarse = error(120), fine = error(240);
  CHECK(coarse < 1e-3);  // measured: 5.8e-4, where the links fold
  CHECK(fine < coarse / 10.0);
}

TEST_CASE("A hinge leaves one of three turns free", "[exact][joints]") {
  Simulation run = flying_pair(JointKind::hinge);
  const BodyJoint joint = run.world().joints()[0];
  const auto across = [&] {
    const Vec3 first_w = run.body("a").orientation_wb() * joint.axes_b[0];
    return first_w.cross(run.body("b").orientation_wb() * joint.axes_b[1]).norm();
  };
  const auto along = [&] {
    const Vec3 first_w = run.body("a").orientation_wb() * joint.axes_b[0];
    return (run.body("b").angular_velocity_w() - run.body("a").angular_velocity_w()).dot(first_w);
  };
  double most = 0.0;
  for (int k = 0; k < 240; ++k) {
    run.step(1.0 / 120.0);
    most = std::max(most, across());
  }
  CHECK(most < 1e-12);  // [rad] measured: 3e-15
  CHECK(std::abs(along()) > 0.5);
  CHECK(apart(run) < 1e-12);
}

TEST_CASE("A fixed joint makes one body of two", "[exact][joints]") {
  Simulation run = flying_pair(JointKind::fixed);
  const auto relative = [&] {
    return Quat(run.body("a").orientation_wb().conjugate() * run.body("b").orientation_wb());
  };
  const Quat start = relative();
  const auto spin = [&] {  // about the origin
    Vec3 sum_w = Vec3::Zero();
    for (const BodyState& s : run.world().states())
      sum_w += s.angular_momentum_w + s.position_w.cross(s.linear_momentum_w);
    return sum_w;
  };
  const Vec3 spin_w = spin();
  double most = 0.0;
  for (int k = 0; k < 240; ++k) {
    run.step(1.0 / 120.0);
    most = std::max(most, angle_between(start, relative()));
  }
  CHECK(most < 1e-7);  // [rad] the root of a rounding, as angles between quaternions are
  CHECK(apart(run) < 1e-12);
  CHECK((run.body("a").angular_velocity_w() - run.body("b").angular_velocity_w()).norm() < 1e-12);
  CHECK((spin() - spin_w).norm() < 1e-6 * spin_w.norm());
}

TEST_CASE("Anchors of a chain stay together to rounding", "[exact][joints]") {
  Simulation run(built("chain", {}), "glued");
  double most = 0.0;
  for (int k = 0; k < 180; ++k) {
    run.step();
    most = std::max(most, apart(run));
  }
  CHECK(most < 1e-11);  // [m]
}

TEST_CASE("Each joint of a chain that hangs carries the weight below it", "[exact][joints]") {
  Simulation run(built("chain", {{"count", "20"}, {"angle", "0"}}), "glued");
  run.step();
  const auto records = run.technique().contacts();
  REQUIRE(records.size() == 20);
  for (std::size_t k = 0; k < records.size(); ++k) {
    const double below = static_cast<double>(records.size() - k) * kGravity;
    CHECK((records[k].push_w - Vec3(0.0, below, 0.0)).norm() < 1e-9 * below);
    CHECK_FALSE(records[k].is_impulse);
  }
}

TEST_CASE("Joints of all kinds give the accelerations of a dense solve", "[exact][joints]") {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    Random chance(seed);
    World world;
    constexpr int kBodies = 10;
    const BodyProperties wall = fixed_box_properties(Vec3::Ones());
    world.add(wall, make_state(wall, Vec3::Zero()));
    std::vector<std::pair<int, int>> rows_of;  // first row and count of each joint
    for (int k = 1; k < kBodies; ++k) {
      const BodyProperties box = box_properties(Vec3(1.0, 0.5, 0.7), chance.uniform(0.5, 3.0));
      const Vec3 place_w = chance.in_cube(2.0);
      const Quat turn = chance.orientation();
      const BodyId id = world.add(box, make_state(box, place_w, turn));
      const int parent = static_cast<int>(chance.uniform(0.0, 0.999) * k);
      const JointKind kind = joint_kinds()[static_cast<std::size_t>(chance.uniform(0.0, 2.999))];
      const Vec3 anchor_w = chance.in_cube(2.0);
      const Vec3 axis_w = chance.in_cube(1.0);
      world.join(kind, world.ids()[static_cast<std::size_t>(parent)], id, anchor_w,
                 kind == JointKind::hinge ? axis_w : Vec3(Vec3::Zero()));
    }
    // J of all joints at rest, and J a = 0 with M a = f + J' λ.
    Eigen::MatrixXd J = Eigen::MatrixXd::Zero(6 * kBodies, 6 * kBodies);
    Eigen::Index row = 0;
    for (const BodyJoint& joint : world.joints()) {
      const int a = world.index_of(joint.bodies[0]), b = world.index_of(joint.bodies[1]);
      const BodyState& sa = world.states()[static_cast<std::size_t>(a)];
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
    Eigen::MatrixXd W = Eigen::MatrixXd::Zero(6 * kBodies, 6 * kBodies);
    Eigen::VectorXd f = Eigen::VectorXd::Zero(6 * kBodies);
    std::vector<MovingBody> moving;
    load_moving_bodies(world, moving);
    for (int k = 0; k < kBodies; ++k) {
      const MovingBody& m = moving[static_cast<std::size_t>(k)];
      W.block<3, 3>(6 * k, 6 * k) = m.inverse_mass.asDiagonal();
      W.block<3, 3>(6 * k + 3, 6 * k + 3) = m.inverse_inertia_w;
      if (k > 0)
        f.segment<3>(6 * k) = world.bodies()[static_cast<std::size_t>(k)].mass * world.gravity_w;
    }
    const Eigen::MatrixXd A = J * W * J.transpose();
    const Eigen::VectorXd force =
        A.completeOrthogonalDecomposition().solve(Eigen::VectorXd(-J * W * f));
    const Eigen::VectorXd exact = W * (f + J.transpose() * force);
    std::vector<Joint> joints;
    for (const BodyJoint& joint : world.joints()) joints.push_back(joint_of(world, joint));
    JointForces forces;
    std::vector<Wrench> rates;
    forces.hold(world, moving, joints, rates);
    const double scale = exact.cwiseAbs().maxCoeff();
    CAPTURE(seed);
    for (int k = 1; k < kBodies; ++k) {
      const MovingBody& m = moving[static_cast<std::size_t>(k)];
      const Wrench& push = rates[static_cast<std::size_t>(k)];
      CHECK((m.inverse_mass.cwiseProduct(push.force_w) - exact.segment<3>(6 * k)).norm() <
            1e-10 * scale);
      CHECK((m.inverse_inertia_w * push.torque_w - exact.segment<3>(6 * k + 3)).norm() <
            1e-10 * scale);
    }
  }
}

TEST_CASE("Balls and hinges in motion give Featherstone's accelerations", "[reference][joints]") {
  for (const int children : {1, 2}) {
    Random chance(static_cast<std::uint64_t>(children));
    World world;
    const BodyProperties wall = fixed_box_properties(Vec3::Ones());
    world.add(wall, make_state(wall, Vec3::Zero()));
    std::vector<HungLink> links;
    std::vector<Vec3> spin_w{Vec3::Zero()}, speed_w{Vec3::Zero()};
    for (int k = 1; k <= 20; ++k) {
      const int parent = k == 1 ? 0 : 1 + (k - 2) / children;
      const auto p = static_cast<std::size_t>(parent);
      const BodyState& on = world.states()[p];
      const Vec3 anchor_w = on.position_w + on.orientation_wb * chance.in_cube(0.5);
      const Quat turn = chance.orientation();
      const Vec3 arm_w = chance.in_cube(0.6);
      const Vec3 turning_w = chance.in_cube(2.0);
      const bool hinge = k % 2 == 0;
      spin_w.push_back(spin_w[p] + turning_w);
      const Vec3 at_anchor_w = speed_w[p] + spin_w[p].cross(anchor_w - on.position_w);
      speed_w.push_back(at_anchor_w + spin_w.back().cross(arm_w));
      const BodyProperties box = box_properties(Vec3(1.0, 0.4, 0.7), chance.uniform(0.5, 2.0));
      const BodyId id =
          world.add(box, make_state(box, anchor_w + arm_w, turn, speed_w.back(), spin_w.back()));
      world.join(hinge ? JointKind::hinge : JointKind::ball, world.ids()[p], id, anchor_w,
                 hinge ? turning_w : Vec3(Vec3::Zero()));
      links.push_back({parent - 1, anchor_w, {Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()}});
      if (hinge) links.back().axes_w = {turning_w.normalized()};
    }
    std::vector<MovingBody> moving;
    load_moving_bodies(world, moving);
    const std::vector<Spatial> exact =
        articulated_accelerations(links, {moving.begin() + 1, moving.end()}, world.gravity_w);
    std::vector<Joint> joints;
    for (const BodyJoint& joint : world.joints()) joints.push_back(joint_of(world, joint));
    JointForces forces;
    std::vector<Wrench> rates;
    forces.hold(world, moving, joints, rates);
    double scale = 0.0;
    for (const Spatial& a : exact) scale = std::max(scale, a.cwiseAbs().maxCoeff());
    for (std::size_t k = 1; k < moving.size(); ++k) {
      const MovingBody& m = moving[k];
      const Vec3& momentum_w = world.states()[k].angular_momentum_w;
      const Vec3 linear_w = m.inverse_mass.cwiseProduct(rates[k].force_w);
      const Vec3 angular_w =
          m.inverse_inertia_w * (rates[k].torque_w - m.angular_velocity_w.cross(momentum_w));
      CAPTURE(children, k);
      CHECK((linear_w - exact[k - 1].tail<3>()).norm() < 1e-9 * scale);
      CHECK((angular_w - exact[k - 1].head<3>()).norm() < 1e-9 * scale);
    }
  }
}

TEST_CASE("A bridge of planks in hinges is a loop that stays closed and keeps its energy",
          "[exact][joints]") {
  Scene scene = built("plank_bridge", {});
  scene.boxes.pop_back();  // without the load
  Simulation run(scene, "glued");
  const double start = energy_of(run.world()).total();
  double most = 0.0, gained = 0.0;
  for (int k = 0; k < 120; ++k) {
    run.step();
    most = std::max(most, apart(run));
    gained = std::max(gained, std::abs(energy_of(run.world()).total() - start));
  }
  CHECK(most < 1e-11);                                // [m]
  CHECK(gained < 1e-4 * 8.0 * 5.0 * kGravity * 0.5);  // [J] of eight planks, half a metre
}

TEST_CASE("Velocities that a joint forbids end in the first step", "[unit][joints]") {
  Scene scene = built("pendulum", {{"count", "1"}, {"angle", "0"}});
  scene.boxes[1].velocity_w = Vec3(0.0, 1.0, 2.0);
  Simulation run(scene, "glued");
  const StepReport report = run.step(1e-6);
  CHECK(run.body("link1").velocity_w().norm() < 1e-4);
  CHECK(report.energy.restitution == near(-2.5).epsilon(1e-4));
}
