/// \file
/// \brief Joint forces against closed forms; redundant joints.
#include "tumble/exterior_rotation/joint_forces.hpp"

#include "tumble/base/error.hpp"
#include "tumble/exterior_rotation/tolerances.hpp"

#include "exterior_rotation/cases.hpp"
#include "support/test.hpp"

namespace {

// Joint forces of a world at rest, with the joints found at its start.
struct Held {
  explicit Held(const World& world) : Held(world, find_joints(world, tolerance::glue_margin)) {}
  Held(const World& world, std::vector<Joint> those) : joints(std::move(those)) {
    load_moving_bodies(world, moving);
    forces.hold(world, moving, joints, wrenches);
  }
  std::vector<Joint> joints;
  std::vector<MovingBody> moving;
  std::vector<Wrench> wrenches;
  JointForces forces;

  // Acceleration of a body's centre, and its angular acceleration.
  [[nodiscard]] Acceleration of(const World& world, std::size_t body) const {
    const MovingBody& m = moving[body];
    const Vec3& momentum_w = world.states()[body].angular_momentum_w;
    return {
        m.inverse_mass.cwiseProduct(wrenches[body].force_w),
        m.inverse_inertia_w * (wrenches[body].torque_w - m.angular_velocity_w.cross(momentum_w))};
  }
};

// [N] Joint forces on a group, without gravity.
double largest_push(const Held& held) {
  double worst = 0.0;
  for (std::size_t j = 0; j < held.joints.size(); ++j) {
    const Wrench& push = held.forces.on_second(static_cast<int>(j));
    worst = std::max({worst, push.force_w.norm(), push.torque_w.norm()});
  }
  return worst;
}

World boxes(const std::vector<Vec3>& places, const Vec3& spin_w, const Vec3& gravity_w) {
  World world;
  world.gravity_w = gravity_w;
  const BodyProperties cube = box_properties(Vec3::Ones(), 1.0);
  for (const Vec3& place_w : places)
    world.add(cube, place_w, Quat::Identity(), spin_w.cross(place_w), spin_w);
  return world;
}

}  // namespace

TEST_CASE("Pivot forces of the glued column are those of the closed form",
          "[exact][exterior_rotation]") {
  const double rate2 =
      1.5 * kGravity / std::sqrt(4.25);  // twice the square of 1.889 rad/s: R = √17/2
  for (const double start : {0.1, 0.3})
    for (const double angle : {start, 0.5, 0.9}) {
      const double spin = std::sqrt(rate2 * (std::cos(start) - std::cos(angle)));
      const World world =
          world_of("fig6_1", {{"angle", std::to_string(angle)}, {"spin", shortest_text(spin)}});
      const Held held(world);
      REQUIRE(held.joints.size() == 4);
      const double weight = 4.0 * kGravity;
      const double c = std::cos(angle);
      const double s = std::sin(angle);
      const double fallen = 1.5 * (std::cos(start) - c);
      const Wrench& push = held.forces.on_second(0);
      // [-] of the weight: rounding, measured 4e-15
      CHECK(push.force_w.y() / weight == near(1.0 - 0.75 * s * s - fallen * c, 1e-13));
      CHECK(push.force_w.x() / weight == near(0.75 * s * c - fallen * s, 1e-13));
      CHECK(std::abs(push.force_w.z()) / weight <= 1e-13);
      CHECK(push.torque_w.norm() / weight <= 1e-13);
    }
  const Held rest(world_of("fig6_1", {{"angle", "0.3"}}));
  CHECK(rest.forces.on_second(0).force_w.y() / (4.0 * kGravity) == near(0.9345008556, 1e-10));
  CHECK(rest.forces.on_second(0).force_w.x() / (4.0 * kGravity) == near(0.2117409275, 1e-10));
}

TEST_CASE("Joint forces of a released column are those of the closed form",
          "[exact][exterior_rotation]") {
  const World world = world_of("fig6_1", {{"angle", "0.3"}});
  const Held held(world);
  // Shear, pressure and its centre from the pivot's side, from statics with the column's acceleration.
  const std::array<Vec3, 3> expected = {Vec3(7.346365955, 26.74874999, 0.1866083421),
                                        Vec3(3.842891773, 17.8325, 0.3337873452),
                                        Vec3(1.394103122, 8.91625, 0.4415370095)};
  for (std::size_t k = 0; k < 3; ++k) {
    const int joint = static_cast<int>(k) + 1;
    const Quat& turn = world.states()[k + 2].orientation_wb;
    const Vec3 force = turn.conjugate() * held.forces.on_second(joint).force_w;
    const Vec3 torque = turn.conjugate() * held.forces.on_second(joint).torque_w;
    INFO("joint " << joint << ": " << force.transpose() << ", " << torque.transpose());
    CHECK(std::abs(force.x()) == near(expected[k].x(), 1e-8));  // [N] as many digits
    CHECK(force.y() == near(expected[k].y(), 1e-5));
    // The pivot is below the right side: 0.5 - x.
    CHECK(0.5 - torque.z() / force.y() == near(expected[k].z(), 1e-8));
  }
}

TEST_CASE(
    "A box that hangs from its glue is pulled by its weight, and one that sticks to a wall "
    "is turned by it",
    "[exact][exterior_rotation]") {
  World world;
  const BodyProperties fixed = fixed_box_properties(Vec3::Ones());
  const BodyProperties box = box_properties(Vec3(1.0, 2.0, 1.0), 3.0);
  world.add(fixed, Vec3(0.0, 5.0, 0.0));
  world.add(box, Vec3(0.0, 3.5, 0.0));
  world.add(box, Vec3(1.0, 5.75, 0.0));
  const Held held(world);
  REQUIRE(held.joints.size() == 2);
  // [N], [N m]: rounding of 30
  CHECK((held.forces.on_second(0).force_w - Vec3(0.0, 3.0 * kGravity, 0.0)).norm() <= 1e-13);
  CHECK(held.forces.on_second(0).torque_w.norm() <= 1e-13);
  CHECK((held.forces.on_second(1).force_w - Vec3(0.0, 3.0 * kGravity, 0.0)).norm() <= 1e-13);
  // Its centre is half an edge beside the area.
  CHECK((held.forces.on_second(1).torque_w - Vec3(0.0, 0.0, 1.5 * kGravity)).norm() <= 1e-13);
  for (std::size_t k = 1; k < 3; ++k) {
    CHECK(held.wrenches[k].force_w.norm() <= 1e-13);
    CHECK(held.wrenches[k].torque_w.norm() <= 1e-13);
  }
}

TEST_CASE("A group in free flight accelerates as the one rigid body that it is",
          "[exact][exterior_rotation]") {
  const World world = flying_group(Vec3(0.0, -kGravity, 0.0));
  const Held held(world);
  REQUIRE(held.joints.size() >= 2);
  // As one body: moments of inertia by Steiner's theorem, angular acceleration by Euler's equation.
  double mass = 0.0;
  Vec3 centre_w = Vec3::Zero();
  for (std::size_t k = 0; k < 3; ++k) {
    mass += world.bodies()[k].mass;
    centre_w += world.bodies()[k].mass * world.states()[k].position_w;
  }
  centre_w /= mass;
  Mat3 inertia_w = Mat3::Zero();
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 r = world.states()[k].position_w - centre_w;
    inertia_w += Mat3(world.bodies()[k].inertia_b.asDiagonal());
    inertia_w += world.bodies()[k].mass * (r.squaredNorm() * Mat3::Identity() - r * r.transpose());
  }
  const Vec3 spin_w = held.moving[0].angular_velocity_w;
  const Vec3 change_w = inertia_w.inverse() * Vec3(-spin_w.cross(inertia_w * spin_w));
  for (std::size_t k = 0; k < 3; ++k) {
    const Acceleration is = held.of(world, k);
    const Vec3 r = world.states()[k].position_w - centre_w;
    // [rad/s²], [m/s²]: rounding of 10, measured 6e-15
    CHECK((is.angular_w - change_w).norm() <= 1e-13);
    CHECK((is.linear_w - Vec3(0.0, -kGravity, 0.0) - change_w.cross(r) -
           spin_w.cross(spin_w.cross(r)))
              .norm() <= 1e-13);
  }
}

TEST_CASE("Redundant joints give finite forces and the accelerations of those that suffice",
          "[exact][exterior_rotation]") {
  // A rotating ring of four boxes with one redundant joint; and the same box glued twice.
  const std::vector<Vec3> ring = {Vec3(-0.5, -0.5, 0.0), Vec3(0.5, -0.5, 0.0), Vec3(0.5, 0.5, 0.0),
                                  Vec3(-0.5, 0.5, 0.0)};
  const World world = boxes(ring, Vec3(0.5, -1.0, 2.0), Vec3(0.0, -kGravity, 0.0));
  const std::vector<Joint> all = find_joints(world, tolerance::glue_margin);
  std::vector<Joint> needed;  // faces only: diagonal neighbours share an edge
  std::vector<Joint> once;
  for (const Joint& joint : all)
    if (joint.is_area()) needed.push_back(joint);
  REQUIRE(needed.size() == 4);
  once.assign(needed.begin(), needed.begin() + 3);
  std::vector<Joint> twice = needed;
  twice.insert(twice.end(), needed.begin(), needed.end());
  const Held reference(world, once);
  for (const std::vector<Joint>& joints : {all, needed, twice}) {
    const Held held(world, joints);
    CHECK(largest_push(held) < 100.0);  // [N] the group weighs 40 N
    for (std::size_t k = 0; k < 4; ++k) {
      const Acceleration is = held.of(world, k);
      const Acceleration should = reference.of(world, k);
      // [m/s²], [rad/s²] rounding
      CHECK((is.linear_w - should.linear_w).norm() <= 1e-12);
      CHECK((is.angular_w - should.angular_w).norm() <= 1e-12);
    }
  }
}

TEST_CASE("Joints hold a body a million times as heavy on a light one and a light one on it",
          "[exact][exterior_rotation]") {
  for (const double mass : {1e-6, 1.0, 1e6}) {
    World world;
    const BodyProperties fixed = fixed_box_properties(Vec3::Ones());
    const BodyProperties below = box_properties(Vec3::Ones(), 1.0);
    const BodyProperties above = box_properties(Vec3::Ones(), mass);
    world.add(fixed, Vec3(0.0, 0.5, 0.0));
    world.add(below, Vec3(0.0, 1.5, 0.0));
    world.add(above, Vec3(0.2, 2.5, 0.0));
    const Held held(world);
    REQUIRE(held.joints.size() == 2);
    // [-] of the supported weight: rounding over a millionth
    CHECK(held.forces.on_second(1).force_w.y() / (mass * kGravity) == near(1.0, 1e-9));
    CHECK(held.forces.on_second(0).force_w.y() / ((1.0 + mass) * kGravity) == near(1.0, 1e-9));
    for (std::size_t k = 1; k < 3; ++k)
      CHECK(held.of(world, k).linear_w.norm() <= 1e-8);  // [m/s²] ditto
  }
}
