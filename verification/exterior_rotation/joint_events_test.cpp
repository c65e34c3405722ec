/// \file
/// \brief Joints without glue: opening, separation, closing, and the energy lost.
#include "tumble/exterior_rotation/joint_events.hpp"

#include "tumble/dynamics/energy.hpp"
#include "tumble/exterior_rotation/tolerances.hpp"

#include "exterior_rotation/cases.hpp"
#include "support/catch.hpp"

using namespace tumble;
using namespace tumble::test;

namespace {

constexpr double kStep = 1.0 / 60.0;  // [s]

// A cube of 2 kg and half a metre that stands on a fixed box, its centre this far to the right of the
// middle. The fixed box ends at x = 1.
World cube_at(double x, bool cube_first = false) {
  World world;
  const BodyProperties base = fixed_box_properties(Vec3(2.0, 1.0, 2.0));
  const BodyProperties cube = box_properties(Vec3::Constant(0.5), 2.0);
  if (cube_first) world.add(cube, make_state(cube, Vec3(x, 0.75, 0.0)));
  world.add(base, make_state(base, Vec3::Zero()));
  if (!cube_first) world.add(cube, make_state(cube, Vec3(x, 0.75, 0.0)));
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
    CHECK(margin.value ==
          near((1.0 - std::abs(x)) / 0.5).margin(1e-11));  // a face is cut to 1e-12 m
    CHECK(margin.change.joint == 0);
    CHECK(margin.change.hold == JointHold::edge);
    // It would turn about the side at the end of the fixed box.
    for (const int corner : {margin.change.side, margin.change.side + 1})
      CHECK(corner_of(joints[0], corner, world.states()).first_w.x() ==
            near(std::copysign(1.0, x)).margin(1e-11));
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
    for (int n = 0; n < 12; ++n) changes += glued.step(world, kStep).events;
    CHECK(changes == 1);
    REQUIRE(notes.events.size() == 1);
    CHECK(notes.events[0].time == 0.0);
    CHECK(notes.events[0].second == world.ids()[1]);
    CHECK(glued.joints()[0].hold == JointHold::edge);
    // It tips to the right, and its energy stays.
    CHECK(world.states()[1].angular_momentum_w.z() < -0.05);
    CHECK(energy_of(world).total() == near(start).margin(1e-9));
    CHECK(held_point(glued.joints()[0], world.states()).second_w.x() == near(1.0).margin(1e-9));
  }
}

TEST_CASE("A box whose centre is within the face that it stands on never opens",
          "[unit][exterior_rotation]") {
  World world = cube_at(0.99);
  Glued glued(pressing(GluedScheme::dormand_prince));
  const World start = world;
  for (int n = 0; n < 120; ++n) CHECK(glued.step(world, kStep).events == 0);
  CHECK(glued.joints()[0].hold == JointHold::area);
  CHECK((world.states()[1].position_w - start.states()[1].position_w).norm() < 1e-12);
}

TEST_CASE("An open joint and a world without joints need no change", "[unit][exterior_rotation]") {
  const World world = cube_at(1.1);
  std::vector<Joint> joints = joints_of(world);
  joints[0].hold = JointHold::nothing;
  CHECK(margin_of(world, joints).value == 1.0);
  CHECK(margin_of(world, joints).change.joint == -1);
  CHECK(margin_of(world, {}).value == 1.0);
}

TEST_CASE("A joint without glue that is pulled comes apart, and the box flies off",
          "[exact][exterior_rotation]") {
  // Gravity upwards: the face would have to pull, then the remaining edge.
  World world = cube_at(0.3);
  world.gravity_w = -world.gravity_w;
  const Margin face = margin_of(world, joints_of(world));
  CHECK(face.value < 0.0);
  std::vector<Joint> edge = joints_of(world);
  edge[0].hold = JointHold::edge;
  CHECK(margin_of(world, edge).change.hold == JointHold::nothing);

  Glued glued(pressing(GluedScheme::dormand_prince));
  std::int64_t changes = 0;
  for (int n = 0; n < 30; ++n) changes += glued.step(world, kStep).events;
  CHECK(changes == 2);
  CHECK(glued.joints()[0].hold == JointHold::nothing);
  CHECK(glued.contacts().empty());
  // Free flight for half a second, except for the time of the edge: 1e-12 of a step.
  const Vec3 flown_w = Vec3(0.3, 0.75 + 0.5 * kGravity * 0.25, 0.0);
  CHECK((world.states()[1].position_w - flown_w).norm() < 1e-9);  // [m]
  // With glue it stays at rest.
  World held = cube_at(0.3);
  held.gravity_w = -held.gravity_w;
  Glued glue{GluedOptions{}};
  for (int n = 0; n < 30; ++n) glue.step(held, kStep);
  CHECK((held.states()[1].position_w - Vec3(0.3, 0.75, 0.0)).norm() < 1e-12);
}

TEST_CASE("A joint that has opened closes when the box turns back, and books what is lost",
          "[exact][exterior_rotation]") {
  for (const GluedScheme scheme : {GluedScheme::dormand_prince, GluedScheme::rk4}) {
    World world = cube_at(0.0);
    Glued glued(pressing(scheme));
    // Pushed to the right for a tenth of a second: a cube tips under a force above its weight.
    world.gravity_w = Vec3(1.4 * kGravity, -kGravity, 0.0);
    for (int n = 0; n < 6; ++n) glued.step(world, kStep);
    REQUIRE(glued.joints()[0].hold == JointHold::edge);
    CHECK(opened(glued.joints()[0], world.states()) > 1e-3);  // [m] measured 4e-3
    world.gravity_w = Vec3(0.0, -kGravity, 0.0);
    const double tipped = energy_of(world).total();
    double booked = 0.0;
    int closings = 0;
    for (int n = 0; n < 60; ++n) {
      const StepReport report = glued.step(world, kStep);
      booked += report.energy.restitution;
      if (report.energy.restitution < 0.0) ++closings;
    }
    CHECK(closings == 1);
    CHECK(glued.joints()[0].hold == JointHold::area);
    // It stands as before, at rest: the energy lost is booked.
    CHECK((world.states()[1].position_w - Vec3(0.0, 0.75, 0.0)).norm() < 1e-6);  // [m]
    CHECK(world.states()[1].linear_momentum_w.norm() < 1e-12);
    CHECK(world.states()[1].angular_momentum_w.norm() < 1e-12);
    CHECK(booked < -0.1);  // [J] measured 0.26
    CHECK(energy_of(world).total() - tipped == near(booked).margin(1e-6));
  }
}

TEST_CASE("The moment of an opening does not depend on the steps if it is located",
          "[exact][exterior_rotation]") {
  // Three cubes fall over an edge; the upper two separate first.
  const auto moment = [](GluedEvents events, int rate) {
    World world;
    const BodyProperties base = fixed_box_properties(Vec3(4.0, 2.0, 4.0));
    world.add(base, make_state(base, Vec3(-1.9, -1.0, 0.0)));
    const double tilt = 0.5;
    const Quat turned(std::cos(0.5 * tilt), 0.0, 0.0, -std::sin(0.5 * tilt));
    const BodyProperties cube = box_properties(Vec3::Ones(), 1.0);
    for (const double y : {0.5, 1.5, 2.5})
      world.add(cube, make_state(cube, turned * Vec3(-0.5, y, 0.0), turned));
    Glued glued(pressing(GluedScheme::dormand_prince, events));
    Listener notes;
    glued.observe(&notes);
    for (int n = 0; n < 2 * rate; ++n) glued.step(world, 1.0 / rate);
    REQUIRE(!notes.events.empty());
    CHECK(notes.events[0].first == world.ids()[2]);
    return notes.events[0].time;
  };
  const double located = moment(GluedEvents::located, 60);
  CHECK(moment(GluedEvents::located, 47) == near(located).margin(1e-9));
  CHECK(moment(GluedEvents::located, 20) == near(located).margin(1e-9));
  for (const int rate : {20, 60, 240}) {
    const double late = moment(GluedEvents::step_end, rate) - located;
    CHECK(late > 0.0);
    CHECK(late <= 1.0 / rate);
  }
}

TEST_CASE("Accuracies that no error-controlled step without glue can have are refused",
          "[unit][exterior_rotation]") {
  GluedOptions options;
  options.joints = GluedJoints::unilateral;
  for (const double accuracy : {0.0, -1e-9, 1e-15, 2.0, std::numeric_limits<double>::infinity(),
                                std::numeric_limits<double>::quiet_NaN()}) {
    options.accuracy = accuracy;
    CHECK_THROWS_AS(Glued(options), std::invalid_argument);
  }
  Glued glued(pressing(GluedScheme::dormand_prince));
  World world = cube_at(0.0);
  for (const double dt : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()})
    CHECK_THROWS_AS(glued.step(world, dt), std::invalid_argument);
}
