/// \file
/// \brief Joint forces in linear time, against a dense solver and against Featherstone's articulated bodies.
#include "tumble/previous_work/joint_tree.hpp"

#include "tumble/exterior_rotation/glued.hpp"
#include "tumble/exterior_rotation/joint_forces.hpp"

#include "impulse_damped/scene_runs.hpp"
#include "previous_work/articulated_body.hpp"
#include "support/dense_solve.hpp"
#include "support/test.hpp"

namespace {

// Bodies of chance in joints of chance, each with an earlier one; the first may be immovable.
struct RandomTree {
  std::vector<MovingBody> bodies;
  std::vector<JointRows> joints;

  RandomTree(std::uint64_t seed, int count, bool on_wall) {
    Random chance(seed);
    for (int k = 0; k < count; ++k) {
      const BodyProperties box = box_properties(Vec3(1.0, 0.5, 2.0), chance.uniform(0.5, 4.0));
      const Vec3 place_w = chance.in_cube(1.0);
      const Quat turn = chance.orientation();
      bodies.push_back(moving_body_of(box, make_state(box, place_w, turn)));
    }
    if (on_wall) bodies[0].inverse_mass.setZero();
    if (on_wall) bodies[0].inverse_inertia_w.setZero();
    for (int k = 1; k < count; ++k) {
      const int other = static_cast<int>(chance.uniform(0.0, 0.999) * k);
      join(chance, other, k, 1 + static_cast<int>(chance.uniform(0.0, 5.999)));
    }
  }
  void join(Random& chance, int first, int second, int rows) {
    JointRows joint{.first = first, .second = second, .count = rows};
    const Mat3 axes = chance.orientation().toRotationMatrix();
    const Vec3 arm_first = chance.in_cube(1.0);
    const Vec3 arm_second = chance.in_cube(1.0);
    for (int i = 0; i < rows; ++i) {  // a point along three axes, then angles about them
      const Vec3 axis = axes.col(i % 3);
      const Vec3 along = i < 3 ? axis : Vec3(Vec3::Zero());
      joint.on_first.row(i) << -along.transpose(),
          -(i < 3 ? arm_first.cross(axis) : axis).transpose();
      joint.on_second.row(i) << along.transpose(),
          (i < 3 ? arm_second.cross(axis) : axis).transpose();
    }
    joints.push_back(joint);
  }
};

bool movable(const MovingBody& body) { return !body.inverse_mass.isZero(0.0); }

// M a - J' λ = f, -J a = c by a dense factorisation with pivots. Returns a and λ, six numbers for each.
VecX dense_answer(const RandomTree& tree, const std::vector<Vec6>& body_part,
                  const std::vector<Vec6>& joint_part) {
  const auto bodies = static_cast<Eigen::Index>(6 * tree.bodies.size());
  const auto all = bodies + static_cast<Eigen::Index>(6 * tree.joints.size());
  MatX H = MatX::Identity(all, all);
  VecX right = VecX::Zero(all);
  for (std::size_t k = 0; k < tree.bodies.size(); ++k) {
    if (!movable(tree.bodies[k])) continue;
    const auto at = static_cast<Eigen::Index>(6 * k);
    H.block<6, 6>(at, at) = mass_of(tree.bodies[k]);
    right.segment<6>(at) = body_part[k];
  }
  for (std::size_t j = 0; j < tree.joints.size(); ++j) {
    const JointRows& joint = tree.joints[j];
    const auto at = bodies + static_cast<Eigen::Index>(6 * j);
    for (int i = 0; i < joint.count; ++i) {
      H(at + i, at + i) = 0.0;
      right[at + i] = joint_part[j][i];
      for (const auto& [body, rows] :
           {std::pair{joint.first, &joint.on_first}, std::pair{joint.second, &joint.on_second}}) {
        if (!movable(tree.bodies[idx(body)])) continue;
        H.block<1, 6>(at + i, 6 * body) = -rows->row(i);
        H.block<6, 1>(6 * body, at + i) = -rows->row(i).transpose();
      }
    }
  }
  return dense_solve(H, right);
}

}  // namespace

TEST_CASE("Forces of trees in linear time are those of a dense solver", "[exact][articulated]") {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const RandomTree tree(seed, 12, seed % 2 == 0);
    Random chance(100 + seed);
    std::vector<Vec6> body_part(tree.bodies.size()), joint_part(tree.joints.size(), Vec6::Zero());
    for (Vec6& v : body_part)
      for (int i = 0; i < 6; ++i) v[i] = chance.uniform(-1.0, 1.0);
    for (std::size_t j = 0; j < joint_part.size(); ++j)
      for (int i = 0; i < tree.joints[j].count; ++i) joint_part[j][i] = chance.uniform(-1.0, 1.0);
    const VecX exact = dense_answer(tree, body_part, joint_part);
    JointTree solver;
    solver.arrange(tree.bodies, tree.joints);
    CHECK(solver.loops().empty());
    REQUIRE(solver.factor(tree.bodies, tree.joints));
    solver.solve(body_part, joint_part);
    const double scale = exact.cwiseAbs().maxCoeff();
    CAPTURE(seed);
    for (std::size_t k = 0; k < tree.bodies.size(); ++k)
      if (movable(tree.bodies[k]))
        CHECK((body_part[k] - exact.segment<6>(static_cast<Eigen::Index>(6 * k)))
                  .cwiseAbs()
                  .maxCoeff() < 1e-10 * scale);
    for (std::size_t j = 0; j < tree.joints.size(); ++j)
      for (int i = 0; i < tree.joints[j].count; ++i)
        CHECK(std::abs(joint_part[j][i] -
                       exact[static_cast<Eigen::Index>(6 * (tree.bodies.size() + j)) + i]) <
              1e-10 * scale);
  }
}

TEST_CASE("Accelerations of chains are those of Featherstone's articulated bodies",
          "[reference][articulated]") {
  for (const int children : {1, 2})
    for (const int count : {1, 2, 10, 40}) {
      CAPTURE(children, count);
      CHECK(off_featherstone(HungBoxes(idx(count), count, children, false)) < 1e-9);
    }
}

TEST_CASE("A joint that closes a loop is named, and one with too many rows refused",
          "[unit][articulated]") {
  RandomTree tree(3, 5, false);
  Random chance(4);
  tree.join(chance, 1, 4, 3);
  JointTree solver;
  solver.arrange(tree.bodies, tree.joints);
  REQUIRE(solver.loops().size() == 1);
  CHECK(solver.loops()[0] == 4);
  tree.joints[0].count = 7;
  CHECK_THROWS_WITH(solver.arrange(tree.bodies, tree.joints),
                    "tumble: joint with 7 rows: expected 1 to 6");
  tree.joints[0].count = 2;
  tree.joints[0].on_first.row(1) = tree.joints[0].on_first.row(0);
  tree.joints[0].on_second.row(1) = tree.joints[0].on_second.row(0);
  solver.arrange(tree.bodies, tree.joints);
  CHECK_FALSE(solver.factor(tree.bodies, tree.joints));
}

TEST_CASE("A chain that closes a loop keeps all its joints together", "[exact][articulated]") {
  HungBoxes hung(5, 6, 1, false);
  Joint closing = hung.joints.back();  // of the last box and the wall, at the box's centre
  closing.first = 0;
  closing.corners_second_b[0].setZero();
  closing.corners_first_b[0] = hung.world.states()[6].position_w;
  hung.joints.push_back(closing);
  hung.joints.push_back(closing);  // a second time: rows that depend on others get no force
  std::vector<MovingBody> moving = moving_bodies(hung.world);
  JointForces forces;
  std::vector<Wrench> rates;
  forces.hold(hung.world, moving, hung.joints, rates);
  CHECK(forces.on_second(7).force_w.norm() == 0.0);
  CHECK(forces.on_second(6).force_w.norm() > 1.0);
  const auto acceleration = [&](int body, const Vec3& point_w) -> Vec3 {
    if (body == 0) return Vec3::Zero();
    const auto k = idx(body);
    const MovingBody& m = moving[k];
    const Vec3 spin_w = hung.world.states()[k].angular_momentum_w;
    const Vec3 turns_w =
        m.inverse_inertia_w * (rates[k].torque_w - m.angular_velocity_w.cross(spin_w));
    const Vec3 arm_w = point_w - m.position_w;
    return m.inverse_mass.cwiseProduct(rates[k].force_w) + turns_w.cross(arm_w) +
           m.angular_velocity_w.cross(m.angular_velocity_w.cross(arm_w));
  };
  for (const Joint& joint : hung.joints) {
    const JointPoint held = held_point(joint, hung.world.states());
    CHECK((acceleration(joint.second, held.second_w) - acceleration(joint.first, held.first_w))
              .norm() < 1e-9);  // [m/s²] measured: 1e-13
  }
}

TEST_CASE("A glued column of two hundred boxes turns as one", "[exact][articulated]") {
  World world;
  const BodyProperties cube = box_properties(Vec3::Ones(), 1.0);
  constexpr int kBoxes = 200;
  for (int k = 0; k < kBoxes; ++k) world.add(cube, Vec3(0.0, 0.5 + k, 0.0));
  world.states()[0].linear_momentum_w.x() = 1.0;
  Glued technique({.scheme = GluedScheme::semi_implicit});
  technique.step(world, 0.001);
  CHECK(technique.joints().size() == kBoxes - 1);
  // Measured: 3e-7; rounding grows with the fourth power of the length, to 1e-4 at a thousand.
  // A push at the lowest one turns all of them about their middle alike: ω = r × p / I.
  const double inertia = kBoxes * (kBoxes * kBoxes + 1.0) / 12.0;
  const double spin = 0.5 * (kBoxes - 1.0) / inertia;
  for (const std::size_t k : {std::size_t{0}, std::size_t{100}, std::size_t{199}})
    CHECK(angular_velocity(world.bodies()[k], world.states()[k]).z() == near(spin).epsilon(1e-5));
}
