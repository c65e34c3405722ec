/// \file
/// \brief Damped integration as a whole, and its impulses.
#include "tumble/impulse_damped/damped.hpp"

#include "support/runs.hpp"
#include "support/test.hpp"

namespace {

BodyId add_cube(World& world, const Vec3& position_w, const Vec3& velocity_w = Vec3::Zero(),
                double restitution = 0.9, const Quat& q = Quat::Identity(),
                const Vec3& size = Vec3::Ones()) {
  return world.add(box_properties(size, 1.0, 0.0, restitution), position_w, q, velocity_w);
}

// A few boxes that fly into each other over the ground.
World heap() {
  World world = ground_world(0.0, 0.3);
  Random random(2);
  for (int k = 0; k < 12; ++k)
    add_cube(world, Vec3(1.6 * (k % 2), 1.0 + 1.8 * (k / 4), 1.6 * (k / 2 % 2)),
             random.in_cube(2.0), 0.3, random.orientation());
  return world;
}

// Impulses alone: what the thesis added is switched off.
DampedOptions bare() {
  DampedOptions options{.stable_boxes = StableRule::off, .damping = damping_parts_from("none")};
  options.noise.where = Randomness::off;
  return options;
}

}  // namespace

TEST_CASE("A box of any size falls as gravity says", "[exact][impulse_damped]") {
  for (const double size : {1.0, 20.0, 1e3, 1e5}) {
    for (const double dt : {1.0 / 600.0, kFrame, 1.0 / 6.0}) {
      World world = ground_world(0.0, 0.0);
      const double height = 0.5 * size + 10.0;
      add_cube(world, Vec3(0.0, height, 0.0), Vec3::Zero(), 0.0, Quat::Identity(),
               Vec3::Constant(size));
      Damped damped;
      const int steps = static_cast<int>(std::lround(1.0 / dt));
      run(world, damped, steps, dt);
      CAPTURE(size, dt);
      CHECK(height - world.states()[1].position_w.y() ==
            near(0.5 * kGravity * (1.0 + dt)).epsilon(1e-9));
    }
  }
}

TEST_CASE("Boxes of any masses that touch fall together as gravity says",
          "[exact][impulse_damped]") {
  World world;  // without ground: rounding makes them approach by 1e-15 m/s
  const double masses[] = {1.0, 10.0, 0.1, 5.0};
  for (int k = 0; k < 4; ++k) {
    world.add(box_properties(Vec3::Ones(), masses[k], 0.5, 0.0), Vec3(0.1 * k, k, 0.0));
  }
  Damped damped;
  run(world, damped, 300);
  for (int k = 0; k < 4; ++k) {
    CHECK(world.states()[idx(k)].position_w.y() ==
          near(k - 0.5 * kGravity * 5.0 * (5.0 + kFrame), 1e-9));
    CHECK(world.states()[idx(k)].position_w.x() == near(0.1 * k, 1e-9));
  }
}

TEST_CASE("A cube at rest stays where it is to the last bit", "[exact][impulse_damped]") {
  for (const StableRule rule : {StableRule::off, StableRule::corners, StableRule::hull}) {
    World world = stack_of(1, 0.0, 0.9);
    Damped damped({.stable_boxes = rule});
    run(world, damped, 600);
    CHECK(world.states()[1].position_w == Vec3(0.0, 0.5, 0.0));
    CHECK(world.states()[1].linear_momentum_w.norm() < 1e-15);  // one rounding of g dt
    CHECK(damped.stable_bodies().size() == (rule == StableRule::off ? 0 : 1));
  }
}

TEST_CASE("A box at rest stays where it is", "[exact][impulse_damped]") {
  // Without all that the thesis added. g dt is taken and given: one rounding in a step.
  for (const NormalRule normals :
       {NormalRule::last_face, NormalRule::separation, NormalRule::signed_distance}) {
    for (const PointRule points : {PointRule::one, PointRule::area}) {
      World world = stack_of(1, 0.0);
      DampedOptions options = bare();
      options.normals = normals;
      options.points = points;
      Damped damped(options);
      run(world, damped, 600);
      CHECK(std::abs(world.states()[1].position_w.y() - 0.5) < 1e-12);
      CHECK(fastest(world) < 1e-14);
    }
  }
}

TEST_CASE("A box at rest does not bounce though restitution is 0.9", "[exact][impulse_damped]") {
  World world = stack_of(1, 0.0, 0.9);
  Damped damped(bare());
  const StepReport report = damped.step(world, kFrame);
  CHECK(report.events == 0);
  CHECK(fastest(world) < 1e-15);
}

TEST_CASE("A cube that lands flat leaves with 0.9 of its speed and does not turn",
          "[exact][impulse_damped]") {
  for (const PointRule points : {PointRule::one, PointRule::area}) {
    World world = ground_world(0.0, 0.9);
    add_cube(world, Vec3(0.0, 0.51, 0.0), Vec3(0.0, -2.0, 0.0));
    DampedOptions options = bare();
    options.points = points;
    Damped damped(options);
    const StepReport report = damped.step(world, kFrame);
    CHECK(report.events == 1);
    CHECK(velocity(world.bodies()[1], world.states()[1]).y() == near(1.8 - kGravity / 60.0, 1e-14));
    CHECK(world.states()[1].angular_momentum_w.norm() < 1e-14);
    CHECK(report.energy.restitution == near(-0.5 * (4.0 - 3.24), 1e-14));
  }
}

TEST_CASE("A box bounces on a geometrically stable one as on the ground",
          "[exact][impulse_damped]") {
  // With a finite mass in the impulse, stopped afterwards, the upper one would leave at -0.075 m/s.
  World world = stack_of(1, 0.0, 0.9);
  Damped damped({.damping = damping_parts_from("none")});
  damped.step(world, kFrame);
  REQUIRE(damped.stable_bodies().size() == 1);
  add_cube(world, Vec3(0.0, 1.51, 0.0), Vec3(0.0, -1.5, 0.0));
  World copy = world;
  const std::unique_ptr<Technique> clone = damped.clone();
  damped.step(world, kFrame);
  clone->step(copy, kFrame);
  CHECK(copy.hash().value() == world.hash().value());  // the mark is memory
  // 0.9 times 1.5, and the gravity of the step; a few roundings
  CHECK(velocity(world.bodies()[2], world.states()[2]).y() == near(1.35 - kGravity / 60.0, 1e-14));
  CHECK(world.states()[1].position_w == Vec3(0.0, 0.5, 0.0));
}

TEST_CASE("A stable block that is hit at its top from the side falls over",
          "[exact][impulse_damped]") {
  World world = ground_world();
  const Vec3 size(0.2, 1.0, 0.2);
  add_cube(world, Vec3(0.0, 0.5, 0.0), Vec3::Zero(), 0.0, Quat::Identity(), size);
  Damped damped;
  run(world, damped, 3);
  REQUIRE(damped.stable_bodies().size() == 1);
  add_cube(world, Vec3(-0.31, 0.9, 0.0), Vec3(8.0, 0.0, 0.0), 0.0, Quat::Identity(),
           Vec3::Constant(0.2));
  damped.step(world, kFrame);  // in which they meet
  CHECK(world.states()[1].angular_momentum_w.z() < -0.1);
  run(world, damped, 60);
  CHECK(std::abs(world.states()[1].orientation_wb.toRotationMatrix()(1, 1)) < 0.5);
}

TEST_CASE("Bodies that part are left alone", "[exact][impulse_damped]") {
  World world = weightless_world();
  add_cube(world, Vec3::Zero(), Vec3(-0.5, 0.0, 0.0));
  add_cube(world, Vec3(0.95, 0.0, 0.0), Vec3(0.5, 0.0, 0.0));
  Damped damped(bare());
  const StepReport report = damped.step(world, kFrame);
  CHECK(report.impulses == 0);
  CHECK(velocity(world.bodies()[0], world.states()[0]) == Vec3(-0.5, 0.0, 0.0));
}

TEST_CASE("Impulses keep the momentum of two free bodies and never add energy",
          "[exact][impulse_damped]") {
  Random random(21);
  for (int trial = 0; trial < 300; ++trial) {
    World world = weightless_world();
    add_cube(world, Vec3::Zero(), random.in_cube(2.0), 0.9, random.orientation(),
             Vec3(1.0, 0.6, 0.4));
    add_cube(world, random.direction() * 0.8, random.in_cube(2.0), 0.9, random.orientation());
    const Vec3 momentum_w = linear_momentum(world);
    DampedOptions options = bare();
    options.noise.where = trial % 2 == 0 ? Randomness::all : Randomness::off;
    options.points = trial % 3 == 0 ? PointRule::area : PointRule::one;
    Damped damped(options);
    const double before = energy_of(world).kinetic;
    const StepReport report = damped.step(world, kFrame);
    CHECK((linear_momentum(world) - momentum_w).norm() < 1e-13);
    CHECK(report.energy.restitution <= 1e-14);
    // All that changed is booked: rotation keeps the energy to the order dt² of its rule.
    CHECK(energy_of(world).kinetic - before == near(report.energy.restitution, 2e-3));
  }
}

TEST_CASE("Gravity last, as listed, or before the contacts, as in the text, is the same path",
          "[exact][impulse_damped]") {
  // Section 5.2 adds gravity before contacts. COLLIDE's temporary gravity stands for it. Free
  // flight, a bounce and rest of one box, by hand with the order of the text.
  World world = ground_world(0.0, 0.5);
  add_cube(world, Vec3(0.0, 0.7, 0.0), Vec3::Zero(), 0.5);
  Damped damped(bare());
  double y = 0.7;
  double v = 0.0;
  DampedNumbers numbers;
  for (int k = 0; k < 120; ++k) {
    damped.step(world, kFrame);
    const double predicted = y + kFrame * (v - kGravity * kFrame);
    if (predicted <= 0.5 && v < 0.0) v *= -0.5;  // collides
    v -= kGravity * kFrame;                      // falls
    if (y + kFrame * v <= 0.5 && v < 0.0) {      // touches: ten passes, each with its own share
      for (int i = 1; i <= 10; ++i)
        if (y + kFrame * v <= 0.5 && v < 0.0) v *= 1.0 - i / 10.0;
    }
    y += kFrame * v;
    while (y < 0.5 - 1e-12) y += numbers.eps1;
    REQUIRE(world.states()[1].position_w.y() == near(y, 1e-12));
  }
}

TEST_CASE("A stack is still with shock by velocity and chatters with shock by position",
          "[reference][impulse_damped]") {
  DampedOptions options = bare();
  options.normals = NormalRule::separation;
  World pushed = stack_of(5, 0.0);
  Damped position(options);
  double noise = 0.0;
  for (int k = 0; k < 300; ++k) {
    position.step(pushed, kFrame);
    if (k >= 240) noise = std::max(noise, fastest(pushed));
  }
  options.shock = ShockRule::velocity;
  World stopped = stack_of(5, 0.0);
  Damped velocity(options);
  run(stopped, velocity, 300);
  CHECK(noise > 0.02);
  CHECK(fastest(stopped) < 1e-10);
}

TEST_CASE("Everything that damped integration adds is in its books", "[exact][impulse_damped]") {
  // Without collisions and without damping, which has books of its own, what is left is the error of the
  // semi-implicit rule for cubes that nothing touches, m (g dt)²/2 for each.
  for (const StableRule rule : {StableRule::off, StableRule::corners}) {
    World world = heap();
    const int cubes = world.count() - 1;
    const double mass = world.bodies()[1].mass;  // [kg] of each
    DampedOptions options{
        .collision_passes = 0, .stable_boxes = rule, .damping = damping_parts_from("none")};
    Damped damped(options);
    for (int k = 0; k < 300; ++k) {
      const double energy = energy_of(world).total();
      const StepReport report = damped.step(world, kFrame);
      // A body that still rises slower than gravity takes away in the step is stopped early: at speed v up to
      // v (g dt - v) / 2 for each kilogram, at most (g dt)²/8.
      CHECK(report.energy.restitution <= 0.125 * cubes * kGravity * kGravity * kFrame * kFrame);
      CHECK(report.energy.friction == 0.0);
      const double change = energy_of(world).total() - energy;
      const double rule_error = 0.5 * mass * kGravity * kGravity * kFrame * kFrame;
      const double flying = std::round((report.energy.total() - change) / rule_error);
      CHECK((flying >= 0.0 && flying <= cubes));
      // Rounding of some 300 J; cubes turn without error.
      REQUIRE(change == near(report.energy.total() - flying * rule_error, 1e-10));
    }
  }
}

TEST_CASE("A heap sleeps with damped integration and wakes when its support is hit",
          "[reference][impulse_damped]") {
  World world = stack_of(3, 0.0);
  Damped damped({.sleeping = true});
  run(world, damped, 60);
  CHECK(std::all_of(world.sleep_states().begin() + 1, world.sleep_states().end(),
                    [](const SleepState& rest) { return rest.asleep; }));
  const StepReport still = damped.step(world, kFrame);
  CHECK(still.impulses == 0);
  add_cube(world, Vec3(-1.1, 0.5, 0.0), Vec3(8.0, 0.0, 0.0));
  run(world, damped, 10);
  CHECK_FALSE(world.sleep_states()[1].asleep);
}

TEST_CASE("Damped integration says that it has no friction and refuses a bad option",
          "[unit][impulse_damped]") {
  World world = stack_of(1, 0.0);
  CHECK(Damped().ignores(world).empty());
  World rough = ground_world(0.5);
  CHECK(Damped().ignores(rough) == std::vector<std::string>{"friction"});
  CHECK_THROWS_WITH(Damped({.contact_passes = -1}), Contains("contact_passes"));
}
