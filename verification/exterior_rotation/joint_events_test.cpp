/// \file
/// \brief Joints without glue: opening, separation, closing, and the energy lost; impulses in joints.
#include "tumble/exterior_rotation/joint_events.hpp"

#include "tumble/exterior_rotation/joint_forces.hpp"
#include "tumble/exterior_rotation/tolerances.hpp"

#include "exterior_rotation/cases.hpp"
#include "support/test.hpp"

namespace {

// A cube of 2 kg and half a metre that stands on a fixed box, its centre this far to the right of the
// middle. The fixed box ends at x = 1.
World cube_at(double x, bool cube_first = false) {
  World world;
  const BodyProperties base = fixed_box_properties(Vec3(2.0, 1.0, 2.0));
  const BodyProperties cube = box_properties(Vec3::Constant(0.5), 2.0);
  if (cube_first) world.add(cube, Vec3(x, 0.75, 0.0));
  world.add(base, Vec3::Zero());
  if (!cube_first) world.add(cube, Vec3(x, 0.75, 0.0));
  return world;
}

struct Margin {
  double value = 0.0;
  JointChange change;
};

Margin margin_of(const World& world, const std::vector<Joint>& joints) {
  std::vector<MovingBody> moving;
  std::vector<Wrench> rates;
  JointForces forces;
  load_moving_bodies(world, moving);
  forces.hold(world, moving, joints, rates);
  Margin margin;
  margin.value = joint_margin(joints, world, moving, forces, margin.change);
  return margin;
}

std::vector<Joint> joints_of(const World& world) {
  return find_joints(world, tolerance::glue_margin);
}

}  // namespace

TEST_CASE("The margin of a face is the distance of its centre of pressure from the edge, in edges",
          "[exact][exterior_rotation]") {
  // At x = 0.9 and at x = 1.1 the face ends at 1: the centre is 0.1 m within or beyond it,
  // whichever of the bodies is the first one.
  for (const double x : {0.8, 0.9, 0.99, 1.01, 1.1, 1.2, -0.8, -1.2}) {
    const World world = cube_at(x, std::abs(x) < 1.0);
    const std::vector<Joint> joints = joints_of(world);
    REQUIRE(joints.size() == 1);
    REQUIRE(joints[0].hold == JointHold::area);
    const Margin margin = margin_of(world, joints);
    CHECK(margin.value == near((1.0 - std::abs(x)) / 0.5, 1e-11));  // a face is cut to 1e-12 m
    CHECK(margin.change.joint == 0);
    CHECK(margin.change.hold == JointHold::edge);
    // It would turn about the side at the end of the fixed box.
    for (const int corner : {margin.change.side, margin.change.side + 1})
      CHECK(corner_of(joints[0], corner, world.states()).first_w.x() ==
            near(std::copysign(1.0, x), 1e-11));
  }
}

TEST_CASE("A box whose centre is beyond the edge that it stands on opens at once",
          "[exact][exterior_rotation]") {
  for (const GluedEvents events : {GluedEvents::located, GluedEvents::step_end}) {
    World world = cube_at(1.1);
    Glued glued(pressing(GluedScheme::dormand_prince, events));
    Listener notes;
    glued.observe(&notes);
    const double start = energy_of(world).total();
    std::int64_t changes = 0;
    for (int n = 0; n < 12; ++n) changes += glued.step(world, kFrame).events;
    CHECK(changes == 1);
    REQUIRE(notes.events.size() == 1);
    CHECK(notes.events[0].time == 0.0);
    CHECK(notes.events[0].second == world.ids()[1]);
    CHECK(glued.joints()[0].hold == JointHold::edge);
    // It tips to the right, and its energy stays.
    CHECK(world.states()[1].angular_momentum_w.z() < -0.05);
    CHECK(energy_of(world).total() == near(start, 1e-9));
    CHECK(held_point(glued.joints()[0], world.states()).second_w.x() == near(1.0, 1e-9));
  }
}

TEST_CASE("A box whose centre is within the face that it stands on never opens",
          "[unit][exterior_rotation]") {
  World world = cube_at(0.99);
  Glued glued(pressing(GluedScheme::dormand_prince));
  const World start = world;
  for (int n = 0; n < 120; ++n) CHECK(glued.step(world, kFrame).events == 0);
  CHECK(glued.joints()[0].hold == JointHold::area);
  CHECK((world.states()[1].position_w - start.states()[1].position_w).norm() < 1e-12);
}

TEST_CASE("Accuracies that no error-controlled step without glue can have are refused",
          "[unit][exterior_rotation]") {
  GluedOptions options{.joints = GluedJoints::unilateral};
  for (const double accuracy : {0.0, -1e-9, 1e-15, 2.0, kInfinity, kNan}) {
    options.accuracy = accuracy;
    CHECK_THROWS_AS(Glued(options), std::invalid_argument);
  }
  Glued glued(pressing(GluedScheme::dormand_prince));
  World world = cube_at(0.0);
  for (const double dt : {0.0, -1.0, kNan})
    CHECK_THROWS_AS(glued.step(world, dt), std::invalid_argument);
}

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
