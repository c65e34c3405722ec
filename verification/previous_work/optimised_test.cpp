/// \file
/// \brief Animation by optimisation against closed forms.
#include "tumble/previous_work/optimised.hpp"

#include "tumble/base/random.hpp"
#include "tumble/dynamics/energy.hpp"
#include "tumble/math/elementary.hpp"
#include "tumble/scenes/simulation.hpp"

#include "impulse_damped/scene_runs.hpp"
#include "support/catch.hpp"

namespace {

constexpr std::array<double, 3> kSteps{1.0 / 60.0, 0.25, 1.0};

// A cube on level ground, seen from above it.
World falling_cube(double height, double restitution) {
  World world = ground_world(0.5, restitution);
  const BodyProperties cube = box_properties(Vec3::Ones(), 2.0);
  world.add(cube, make_state(cube, Vec3(0.0, height, 0.0)));
  return world;
}

}  // namespace

TEST_CASE("A box that falls lands in one step of any length", "[exact][optimised]") {
  for (const double dt : kSteps) {
    CAPTURE(dt);
    World world =
        falling_cube(0.5 + 0.4 * kGravity * dt * dt, 0.0);  // lower than it falls in a step
    Optimised technique;
    const StepReport report = technique.step(world, dt);
    CHECK(report.status == StepStatus::done);
    CHECK(world.states()[1].position_w.y() == near(0.5).margin(1e-9));
    CHECK(world.states()[1].linear_momentum_w.norm() < 1e-9);
    CHECK(angle_between(world.states()[1].orientation_wb, Quat::Identity()) < 1e-9);
    double push = 0.0;
    for (const ContactRecord& contact : technique.contacts()) push += contact.push_w.y();
    CHECK(push == near(2.0 * kGravity * dt).epsilon(1e-5));  // all that gravity has given it
    CHECK(technique.work().poses > 0);
    CHECK(technique.work().momenta > 0);
  }
}

TEST_CASE(
    "Nearest poses of two boxes divide their overlap by their masses, and least energy makes them "
    "one",
    "[exact][optimised]") {
  World world = weightless_world();
  const BodyProperties light = box_properties(Vec3::Ones(), 1.0);
  const BodyProperties heavy = box_properties(Vec3::Ones(), 3.0);
  world.add(light, make_state(light, Vec3(0.0, 0.0, 0.0), Quat::Identity(), Vec3(2.0, 0.0, 0.0),
                              Vec3::Zero()));
  world.add(heavy, make_state(heavy, Vec3(1.2, 0.0, 0.0), Quat::Identity(), Vec3(-1.0, 0.0, 0.0),
                              Vec3::Zero()));
  Optimised technique;
  const StepReport report = technique.step(world, 0.2);
  CHECK(report.status == StepStatus::done);
  // Targets 0.4 and 1.0 overlap by 0.4; three quarters of that are the lighter one's.
  CHECK(world.states()[0].position_w.x() == near(0.1).margin(1e-6));
  CHECK(world.states()[1].position_w.x() == near(1.1).margin(1e-6));
  const double together = (2.0 - 3.0) / 4.0;  // [m/s]
  CHECK(world.states()[0].linear_momentum_w.x() == near(together).margin(1e-6));
  CHECK(world.states()[1].linear_momentum_w.x() == near(3.0 * together).margin(3e-6));
  CHECK(report.energy.total() == near(0.125 - 3.5).margin(1e-5));
}

TEST_CASE("A stack stands under optimisation at steps of any length", "[exact][optimised]") {
  for (const double dt : kSteps) {
    CAPTURE(dt);
    World world = world_of("stack");
    const World start = world;
    Optimised technique;
    double weight = 0.0;
    for (const BodyProperties& body : world.bodies())
      if (body.movable()) weight += body.mass * kGravity;
    for (int k = 0; k < 20; ++k) CHECK(technique.step(world, dt).status == StepStatus::done);
    CHECK(distance_of(world, start) < 1e-6);  // [m]
    double push = 0.0;
    for (const ContactRecord& contact : technique.contacts())
      if (contact.first == world.ids()[0]) push += contact.push_w.y();
    CHECK(push == near(weight * dt).epsilon(1e-4));
  }
}

TEST_CASE("Friction of optimisation holds a box on a slope, or slides it along the parabola",
          "[exact][optimised]") {
  // The slope is in gravity, 20 degrees; the coefficient of the steepest rest is 0.364.
  const double slope = std::numbers::pi / 9.0;
  for (const double friction : {0.4, 0.2}) {
    World world;
    world.gravity_w = kGravity * Vec3(elementary::sin(slope), -elementary::cos(slope), 0.0);
    world.add_ground(friction, 0.0);
    const BodyProperties box = box_properties(Vec3(2.0, 0.5, 2.0), 1.0, friction);
    world.add(box, make_state(box, Vec3(0.0, 0.25, 0.0)));
    Optimised technique;
    for (int k = 0; k < 8; ++k) technique.step(world, 0.125);
    const double along = std::max(0.0, elementary::sin(slope) - friction * elementary::cos(slope));
    CAPTURE(friction);
    CHECK(world.states()[1].position_w.x() == near(0.5 * kGravity * along).margin(1e-4));
    CHECK(world.states()[1].linear_momentum_w.x() == near(kGravity * along).margin(1e-4));
  }
}

TEST_CASE("A bounce under optimisation ends its step with the speed of the start",
          "[exact][optimised]") {
  World world = falling_cube(0.6, 0.5);
  const BodyProperties cube = world.bodies()[1];
  world.states()[1].linear_momentum_w = Vec3(0.0, -2.0 * 3.0, 0.0);
  Optimised technique;
  technique.step(world, 0.1);
  CHECK(world.states()[1].position_w.y() == near(0.5).margin(1e-9));
  CHECK(world.states()[1].linear_momentum_w.y() / cube.mass == near(0.5 * 3.0).margin(1e-5));
}

TEST_CASE("An elastic bounce under optimisation keeps its speed, whatever that is",
          "[exact][optimised]") {
  for (const double speed : {1.0, 2.0, 3.0, 5.0, 7.0}) {
    World world = weightless_world();
    const BodyProperties wall = fixed_box_properties(Vec3(0.2, 2.0, 2.0), 0.0, 1.0);
    const BodyProperties cube = box_properties(Vec3::Constant(0.3), 1.0, 0.0, 1.0);
    world.add(wall, make_state(wall, Vec3(1.0, 0.0, 0.0)));
    world.add(cube, make_state(cube, Vec3(0.2, 0.1, -0.2), Quat::Identity(), Vec3(speed, 0.0, 1.0),
                               Vec3::Zero()));
    Optimised technique;
    for (int k = 0; k < 60; ++k) technique.step(world, 1.0 / 60.0);
    CAPTURE(speed);
    CHECK((world.states()[1].linear_momentum_w - Vec3(-speed, 0.0, 1.0)).norm() < 1e-5);
  }
}

TEST_CASE("Momentum is kept by optimisation without ground, and energy never rises",
          "[exact][optimised]") {
  World free = world_of("clump", {{"per_edge", "2"}}, 1);
  free.remove(free.ids()[0]);
  free.gravity_w.setZero();
  const Vec3 momentum = linear_momentum(free);
  Optimised technique;
  for (int k = 0; k < 10; ++k) technique.step(free, 0.1);
  CHECK((linear_momentum(free) - momentum).norm() < 1e-12);  // [kg m/s] measured: 1e-15

  // A clump that falls, with and without bounces, and a box that slides under a cube that stands on its edge and lifts it.
  World lifted = ground_world(0.0, 0.0);
  const BodyProperties plate = box_properties(Vec3(3.0, 1.0, 3.0), 50.0, 0.0);
  const BodyProperties cube = box_properties(Vec3::Ones(), 1.0, 0.0);
  lifted.add(plate, make_state(plate, Vec3(-1.6, 0.5, 0.0), Quat::Identity(), Vec3(8.0, 0.0, 0.0),
                               Vec3::Zero()));
  lifted.add(cube,
             make_state(cube, Vec3(0.3, 1.46, 0.0), rotation_from_degrees(Vec3(0.0, 0.0, 45.0))));
  const std::array<World, 3> starts{
      world_of("clump", {{"per_edge", "2"}}, 2),
      world_of("clump", {{"per_edge", "2"}, {"restitution", "0.8"}}, 2), lifted};
  for (std::size_t n = 0; n < starts.size(); ++n) {
    for (const double dt : {1.0 / 60.0, 0.125, 0.25}) {
      CAPTURE(n, dt);
      World world = starts[n];
      Optimised moves;
      double energy = energy_of(world).total();
      for (int k = 0; k < 20; ++k) {
        const StepReport report = moves.step(world, dt);
        const double now = energy_of(world).total();
        CHECK(report.status == StepStatus::done);
        CHECK(now <= energy * (1.0 + 1e-5));  // poses of bodies at rest miss 2e-6 of it
        CHECK(now - energy == near(report.energy.total()).margin(1e-9 * energy));  // all is booked
        energy = now;
      }
    }
  }
}

TEST_CASE("A bar that rotates into boxes gains hardly any energy by being turned aside",
          "[unit][optimised]") {
  Random random(5);
  for (int k = 0; k < 40; ++k) {
    CAPTURE(k);
    Scene scene{.gravity_w = Vec3::Zero()};
    SceneBox bar;
    bar.size = Vec3(random.uniform(1.0, 3.0), 0.06, 0.06);
    bar.angular_velocity_w.y() = random.uniform(20.0, 60.0);
    SceneBox block;
    block.size.setConstant(random.uniform(0.05, 0.3));
    block.mass = random.uniform(0.2, 3.0);
    const double angle = random.uniform(0.6, 2.5);
    const double out = bar.size.x() * random.uniform(0.25, 0.6);
    block.position_w =
        Vec3(out * std::cos(angle), random.uniform(-0.05, 0.05), out * std::sin(angle));
    scene.boxes = {bar, block};
    Simulation run(scene, "optimised");
    const double energy = energy_of(run.world()).total();
    for (int step = 0; step < 30; ++step) run.step();
    CHECK(energy_of(run.world()).total() <= 1.2 * energy);  // it was up to 300 times as much
  }
}

TEST_CASE(
    "A way that is not finished within the rounds is reported, and bodies pass through nothing",
    "[unit][optimised]") {
  // 20 m in a step, through a wall a hundredth as thick as the way.
  World world = weightless_world();
  const BodyProperties cube = box_properties(Vec3::Ones(), 1.0);
  world.add(cube, make_state(cube, Vec3(-10.0, 0.0, 0.0), Quat::Identity(), Vec3(20.0, 0.0, 0.0),
                             Vec3::Zero()));
  const BodyProperties wall = fixed_box_properties(Vec3(0.2, 5.0, 5.0));
  world.add(wall, make_state(wall, Vec3::Zero()));
  World copy = world;
  Optimised technique;
  CHECK(technique.step(world, 1.0).status == StepStatus::done);
  CHECK(world.states()[0].position_w.x() == near(-0.6).margin(1e-6));
  Optimised short_of_breath({.rounds = 3});
  CHECK(short_of_breath.step(copy, 1.0).status == StepStatus::event_cap);
  CHECK(copy.states()[0].position_w.x() == near(-10.0 + 3.0 * 0.25).margin(1e-9));

  CHECK_THROWS_AS(Optimised({.reach = 0.0}), std::invalid_argument);
  CHECK_THROWS_WITH(Optimised({.rounds = 0}), "tumble: rounds = 0: expected 1 or more");
  CHECK_THROWS_WITH(Optimised({.budget = 0}), "tumble: budget = 0: expected 1 or more");
}

TEST_CASE("A cube that spins fast on the ground is braked under optimisation and stays there",
          "[exact][optimised]") {
  // Friction whose limit grew with the push once drove both up: the cube jumped by up to 77 m.
  for (const double spin : {30.0, 40.0, 50.0, 55.0, 100.0}) {
    CAPTURE(spin);
    World world = falling_cube(0.5, 0.0);
    const BodyProperties& cube = world.bodies()[1];
    BodyState& state = world.states()[1];
    state =
        make_state(cube, state.position_w, Quat::Identity(), Vec3::Zero(), Vec3(0.0, spin, 0.0));
    Optimised technique;
    const double dt = 1.0 / 60.0;
    technique.step(world, dt);
    // The weight at the corners, with the lever 1/sqrt(2) and a moment of inertia of m/6.
    const double friction = 0.5;
    CHECK(angular_velocity(cube, state).y() ==
          near(spin - 6.0 * friction * kGravity * dt / std::numbers::sqrt2).epsilon(1e-6));
    for (int k = 1; k < 60; ++k) technique.step(world, dt);
    CHECK(state.position_w.y() == near(0.5).margin(1e-6));
  }
}
