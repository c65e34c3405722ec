/// \file
/// \brief Impulses in joints: invariants, and the motion that an edge and a corner leave free.
#include "tumble/exterior_rotation/joint_forces.hpp"
#include "tumble/exterior_rotation/tolerances.hpp"

#include "exterior_rotation/cases.hpp"
#include "support/test.hpp"

using namespace tumble;
using namespace tumble::test;

TEST_CASE("Impulses of joints keep momenta, take energy only, and end all relative motion",
          "[exact][exterior_rotation]") {
  Random random(11);
  for (int trial = 0; trial < 50; ++trial) {
    World world = flying_group(Vec3::Zero());
    const std::vector<Joint> joints = find_joints(world, tolerance::glue_margin);
    for (std::size_t k = 0; k < 3; ++k)
      world.states()[k] =
          make_state(world.bodies()[k], world.states()[k].position_w,
                     world.states()[k].orientation_wb, random.in_cube(3.0), random.in_cube(5.0));
    const Vec3 momentum_w = linear_momentum(world);
    const Vec3 turning_w = angular_momentum(world);
    const double energy = energy_of(world).kinetic;
    std::vector<MovingBody> moving = moving_bodies(world);
    const std::vector<MovingBody> start = moving;
    JointForces forces;
    forces.project(moving, joints, world.states());
    const std::vector<MovingBody> once = moving;
    World after = world;
    store_moving_bodies(moving, after);
    // [kg m/s], [kg m²/s], [J]: rounding of numbers up to 100
    CHECK((linear_momentum(after) - momentum_w).norm() <= 1e-12);
    CHECK((angular_momentum(after) - turning_w).norm() <= 1e-12);
    CHECK(energy_of(after).kinetic <= energy * (1.0 + 1e-14));
    for (std::size_t k = 1; k < 3; ++k) {  // one twist for all
      CHECK((once[k].angular_velocity_w - once[0].angular_velocity_w).norm() <= 1e-13);
      const Vec3 r = world.states()[k].position_w - world.states()[0].position_w;
      CHECK(
          (once[k].velocity_w - once[0].velocity_w - once[0].angular_velocity_w.cross(r)).norm() <=
          1e-13);
    }
    // The second time there is nothing to do.
    forces.project(moving, joints, world.states());
    for (std::size_t k = 0; k < 3; ++k) {
      CHECK((moving[k].velocity_w - once[k].velocity_w).norm() <= 1e-13);
      CHECK((moving[k].angular_velocity_w - once[k].angular_velocity_w).norm() <= 1e-13);
    }
    // Nearest: the velocity that was removed is orthogonal, in kinetic energy, to every motion of
    // the group as one. Six such motions span all.
    for (int axis = 0; axis < 6; ++axis) {
      double product = 0.0;
      for (std::size_t k = 0; k < 3; ++k) {
        const Vec3 spin_w = axis < 3 ? Vec3::Zero() : Vec3(Vec3::Unit(axis - 3));
        const Vec3 v =
            axis < 3 ? Vec3(Vec3::Unit(axis)) : Vec3(spin_w.cross(world.states()[k].position_w));
        const Vec3 lost = start[k].velocity_w - once[k].velocity_w;
        const Vec3 lost_spin = start[k].angular_velocity_w - once[k].angular_velocity_w;
        product += world.bodies()[k].mass * v.dot(lost) +
                   spin_w.dot(world.bodies()[k].inertia_b.cwiseProduct(lost_spin));
      }
      CHECK(std::abs(product) <= 1e-12);  // [kg m/s], [kg m²/s] rounding
    }
  }
}

TEST_CASE("An edge lets two bodies turn about itself only, a corner about every axis",
          "[exact][exterior_rotation]") {
  Random random(12);
  World world;
  const BodyProperties cube = box_properties(Vec3::Ones(), 1.0);
  world.gravity_w = Vec3::Zero();
  const Quat tilt = random.orientation();
  world.add(cube, Vec3::Zero(), tilt, random.in_cube(1.0), random.in_cube(1.0));
  world.add(cube, tilt * Vec3::UnitY(), tilt, random.in_cube(1.0), random.in_cube(1.0));
  Joint joint = find_joints(world, tolerance::glue_margin).at(0);
  for (const JointHold hold : {JointHold::edge, JointHold::corner}) {
    joint.hold = hold;
    for (joint.side = 0; joint.side < 4; ++joint.side) {
      std::vector<MovingBody> moving = moving_bodies(world);
      JointForces forces;
      forces.project(moving, {&joint, 1}, world.states());
      const Vec3 spin_w = moving[1].angular_velocity_w - moving[0].angular_velocity_w;
      const Vec3 point_w = held_point(joint, world.states()).first_w;
      const Vec3 end_w = corner_of(joint, joint.side + 1, world.states()).first_w;
      const Vec3 slip_w = moving[1].velocity_w - moving[0].velocity_w +
                          moving[1].angular_velocity_w.cross(point_w - moving[1].position_w) -
                          moving[0].angular_velocity_w.cross(point_w - moving[0].position_w);
      CHECK(slip_w.norm() <= 1e-14);  // [m/s] rounding
      CHECK(spin_w.norm() > 0.01);    // [rad/s] it still turns
      const Vec3 along_w = (end_w - point_w).normalized();
      if (hold == JointHold::edge) CHECK(spin_w.cross(along_w).norm() <= 1e-14);
      if (hold == JointHold::corner) CHECK(forces.on_second(0).torque_w.norm() == 0.0);
    }
  }
  joint.hold = JointHold::nothing;
  std::vector<MovingBody> moving = moving_bodies(world);
  JointForces forces;
  forces.project(moving, {&joint, 1}, world.states());
  CHECK_FALSE(moving[0].changed);
  CHECK(forces.on_second(0).force_w.norm() == 0.0);
}
