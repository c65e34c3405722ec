/// \file
/// \brief Cases that once broke contact_damped: large friction, worlds that are changed, sleep, fast spin.
#include "tumble/contact_patches/point_friction.hpp"
#include "tumble/dynamics/event_log.hpp"

#include "contact_damped/helpers.hpp"
#include "support/pose.hpp"
#include "support/test.hpp"

namespace {

const BodyProperties kCube = box_properties(Vec3::Ones(), 1.0);

}  // namespace

TEST_CASE("A box that is thrown to the ground, fast and spinning, does not sink into it",
          "[unit][contact_damped]") {
  // Each corner that hits makes the box turn by radians within the step. Edges from 5 cm to 1 m.
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    Random random(seed);
    const auto vector = [&](double low, double high) {
      const double x = random.uniform(low, high);
      const double y = random.uniform(low, high);
      return Vec3(x, y, random.uniform(low, high));
    };
    SceneBox box{.name = "thrown"};
    box.size = vector(-1.3, 0.0).unaryExpr([](double power) { return std::pow(10.0, power); });
    box.mass = 500.0 * box.size.prod();
    box.orientation_wb = rotation_from_vector(vector(-3.0, 3.0));
    box.position_w = Vec3(0.0, 1.0 + 0.5 * box.size.norm(), 0.0);
    box.velocity_w = vector(-10.0, 10.0) - Vec3(0.0, 10.0, 0.0);
    box.angular_velocity_w = vector(-40.0, 40.0);
    box.restitution = seed % 2 == 0 ? 0.0 : 0.4;
    Simulation simulation(Scene{.ground = SceneGround{}, .boxes = {box}});
    double deepest = 0.0;  // [m]
    for (int k = 0; k < 60; ++k) deepest = std::max(deepest, simulation.step().deepest_overlap);
    INFO("seed " << seed);
    CHECK(deepest < 0.03 * box.size.minCoeff());
  }
}

TEST_CASE("No friction is too large for a box, a leaning plank or a see-saw",
          "[unit][contact_damped]") {
  BOTH_POSES;
  for (const char* friction : {"3", "10"}) {
    for (const char* scene : {"leaning", "seesaw", "stack"}) {
      World world = world_of(scene, {{"friction", friction}});
      const Course course = run(world, *contact_damped(), 3.0);
      INFO(scene << ", friction " << friction);
      CHECK(course.failed == 0);
      CHECK(course.overlap < 0.03);  // [m] a see-saw of friction 10 settles for the whole time
    }
  }
  for (const double friction : {1e3, 1e6}) {
    World world = ground_world(friction, 0.0);
    const Quat tilt = rotation_from_vector(Vec3(0.3, 0.2, 0.1));
    world.add(box_properties(Vec3::Ones(), 1.0, friction, 0.0), Vec3(0.0, 1.2, 0.0), tilt,
              Vec3(1.0, -3.0, 0.5));
    const Course course = run(world, *contact_damped(), 3.0);
    CHECK(course.failed == 0);
    CHECK(world.states()[1].position_w.y() == near(0.5, 1e-4));  // [m] on a face
  }
}

TEST_CASE("A point without friction does not pull", "[exact][contact_damped]") {
  CHECK(into_cone(Vec3(0.0, 0.0, -1.0), 0.0).isZero(0.0));
  CHECK(into_cone(Vec3(0.0, 0.0, 1.0), 0.0) == Vec3(0.0, 0.0, 1.0));
}

TEST_CASE("A copy of the technique reports the same contacts", "[unit][contact_damped]") {
  BOTH_POSES;
  World world = stack_of(2);
  const std::unique_ptr<Technique> technique = contact_damped();
  run(world, *technique, 0.1);
  const std::unique_ptr<Technique> copy = technique->clone();
  REQUIRE(copy->contacts().size() == technique->contacts().size());
  for (std::size_t k = 0; k < copy->contacts().size(); ++k)
    CHECK(copy->contacts()[k].point_w == technique->contacts()[k].point_w);
}

TEST_CASE("A box that is replaced by an immovable one in its place disturbs no other body",
          "[unit][contact_damped]") {
  BOTH_POSES;
  World world = stack_of(10);
  const std::unique_ptr<Technique> technique = contact_damped();
  run(world, *technique, 1.0);
  world.remove(world.ids()[10]);
  const BodyProperties fixed = fixed_box_properties(Vec3::Ones());
  world.add(fixed, Vec3(0.0, 9.5, 0.0));
  world.set_velocity(world.ids()[5], Vec3(0.02, 0.0, 0.01), Vec3(0.01, 0.0, 0.0));
  const Course course = run(world, *technique, 1.0);
  CHECK(course.failed == 0);
  for (int k = 1; k < 10; ++k) CHECK(world.states()[idx(k)].position_w.y() == near(k - 0.5, 1e-3));
}

TEST_CASE("A heavy box that drops on sleeping boxes meets bodies with their own masses",
          "[unit][contact_damped]") {
  BOTH_POSES;
  World world = stack_of(3);
  const std::unique_ptr<Technique> technique = contact_damped({{"sleeping", "on"}});
  run(world, *technique, 3.0);
  REQUIRE(world.sleep_states()[3].asleep);
  const BodyProperties heavy = box_properties(Vec3::Ones(), 100.0);
  world.add(heavy, Vec3(0.0, 3.7, 0.0));
  const Course course = run(world, *technique, 1.0);
  CHECK(course.overlap < 1e-3);
  CHECK(world.states()[4].position_w.y() == near(3.5, 1e-3));
}

TEST_CASE("A sleeping box into which an immovable one is put wakes and is pushed out",
          "[unit][contact_damped]") {
  BOTH_POSES;
  World world = stack_of(1);
  const std::unique_ptr<Technique> technique = contact_damped({{"sleeping", "on"}});
  run(world, *technique, 3.0);
  REQUIRE(world.sleep_states()[1].asleep);
  const BodyProperties fixed = fixed_box_properties(Vec3::Ones());
  world.add(fixed, Vec3(0.8, 0.5, 0.0));
  run(world, *technique, 2.0);
  CHECK(world.states()[1].position_w.x() == near(-0.2, 1e-3));
}

TEST_CASE("With sleeping off no body stays asleep", "[unit][contact_damped]") {
  BOTH_POSES;
  World world = stack_of(5);
  run(world, *contact_damped({{"sleeping", "on"}}), 3.0);
  REQUIRE(world.sleep_states()[1].asleep);
  world.remove(world.ids()[3]);
  const Course course = run(world, *contact_damped(), 2.0);
  CHECK(course.failed == 0);
  CHECK(world.states()[4].position_w.y() == near(3.5, 1e-3));  // came down by one
}

TEST_CASE("A box that spins in the air touches what it can reach and nothing else",
          "[exact][contact_damped]") {
  BOTH_POSES;
  for (const double spin : {40.0, 100.0}) {
    World world = ground_world();
    // Half a diagonal of a face is 0.7071 m.
    world.add(kCube, Vec3(0.0, 0.72, 0.0), Quat::Identity(), Vec3::Zero(), Vec3(0.0, 0.0, spin));
    contact_damped()->step(world, kFrame);
    CHECK(velocity(kCube, world.states()[1]).y() == near(-kGravity * kFrame, 1e-12));
  }
}

TEST_CASE("An event reports the whole impulse, with that of restitution",
          "[exact][contact_damped]") {
  BOTH_POSES;
  class ImpulseSum : public Observer {
   public:
    void on_event(const Event& event) override { sum += event.impulse_w; }
    Vec3 sum = Vec3::Zero();
  };
  World world = ground_world(0.5, 1.0);
  world.add(box_properties(Vec3::Ones(), 2.0, 0.5, 1.0), Vec3(0.0, 1.0, 0.0));
  const std::unique_ptr<Technique> technique = contact_damped();
  ImpulseSum impulse;
  technique->observe(&impulse);
  for (int k = 0; k < 60 && impulse.sum.isZero(0.0); ++k) {
    const double before = world.states()[1].linear_momentum_w.y();
    technique->step(world, kFrame);
    const double change = world.states()[1].linear_momentum_w.y() - before;
    if (!impulse.sum.isZero(0.0)) CHECK(impulse.sum.y() == near(change).epsilon(0.1));
  }
  CHECK(impulse.sum.y() > 10.0);  // [N s] 2 kg turned round at 3 m/s
}
