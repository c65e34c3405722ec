/// \file
/// \brief Free fall by three integrators, energy and momenta.
#include "tumble/dynamics/integrate.hpp"

#include "dynamics/random_bodies.hpp"
#include "support/test.hpp"

namespace {

const Vec3 kGravityW(0.0, -9.81, 0.0);
using Step = void (*)(const BodyProperties&, BodyState&, const Vec3&, double, RotationRule);

// Height after one second of free fall from 10 m in n steps.
double fallen_to(Step step, int n) {
  const BodyProperties body = box_properties(Vec3::Ones(), 3.0);
  BodyState state = make_state(body, Vec3(0.0, 10.0, 0.0));
  for (int i = 0; i < n; ++i) step(body, state, kGravityW, 1.0 / n, RotationRule::frozen);
  CHECK(std::abs(velocity(body, state).y() + 9.81) < 1e-12);
  return state.position_w.y();
}

}  // namespace

TEST_CASE("Free fall from 10 m: each integrator reaches its own height to 1e-12 m",
          "[exact][integrate]") {
  // y0 - g h² N(N±1)/2 for the two Euler steps, y0 - g t²/2 for flight. Any half step in the wrong
  // place shows by 1e-2 m. Rounding of 240 additions: measured 2e-14 m.
  CHECK(std::abs(fallen_to(step_semi_implicit, 60) - 5.013250) < 1e-12);
  CHECK(std::abs(fallen_to(step_semi_implicit, 240) - 5.0745625) < 1e-12);
  CHECK(std::abs(fallen_to(step_forward_euler, 60) - 5.176750) < 1e-12);
  CHECK(std::abs(fallen_to(step_forward_euler, 240) - 5.1154375) < 1e-12);
  CHECK(std::abs(fallen_to(fly, 1) - 5.095) < 1e-12);
  CHECK(std::abs(fallen_to(fly, 60) - 5.095) < 1e-12);
  CHECK(std::abs(fallen_to(fly, 240) - 5.095) < 1e-12);
}

TEST_CASE("Flight in two parts is flight in one: translation always, rotation where exact",
          "[exact][integrate]") {
  Random random(31);
  double worst_position = 0.0;
  double worst_exact_rotation = 0.0;
  for (int trial = 0; trial < 500; ++trial) {
    const double edge = random.uniform(0.2, 2.0);
    const double other = trial % 2 == 0 ? edge : random.uniform(0.2, 2.0);
    const BodyProperties body = box_properties(Vec3(edge, other, edge), 2.0);
    const BodyState start = random_state(random, body, 1.0, 5.0, 10.0);
    const double first = random.uniform(0.0, 0.5);
    const double second = random.uniform(0.0, 0.5);
    for (const RotationRule rule : rotation_rules()) {
      BodyState one = start;
      BodyState two = start;
      fly(body, one, kGravityW, first + second, rule);
      fly(body, two, kGravityW, first, rule);
      fly(body, two, kGravityW, second, rule);
      worst_position = std::max(worst_position, (one.position_w - two.position_w).norm());
      const bool is_cube = trial % 2 == 0;
      const bool exact = rule == RotationRule::splitting || (is_cube && rule != RotationRule::rk4);
      if (!exact) continue;
      worst_exact_rotation =
          std::max(worst_exact_rotation, angle_between(one.orientation_wb, two.orientation_wb));
    }
  }
  CHECK(worst_position < 1e-13);        // [m] rounding of positions up to 8 m; measured 2e-15
  CHECK(worst_exact_rotation < 1e-13);  // [rad] rounding of angles up to 30; measured 3e-14
}

TEST_CASE("Micro-steps of any length leave a continuous arc", "[unit][integrate]") {
  // Just before and just after a whole number of micro-steps.
  const BodyProperties body = box_properties(Vec3(1.0, 2.0, 3.0), 1.0);
  const BodyState start =
      make_state(body, Vec3::Zero(), Quat::Identity(), Vec3(1.0, 2.0, 3.0), Vec3(3.0, 4.0, 2.0));
  for (const RotationRule rule : rotation_rules()) {
    for (const double sign : {1.0, -1.0}) {
      BodyState before = start;
      BodyState after = start;
      fly_in_micro_steps(body, before, kGravityW, sign * (0.03 - 1e-12), rule, 0.01);
      fly_in_micro_steps(body, after, kGravityW, sign * (0.03 + 1e-12), rule, 0.01);
      // [rad] 2e-12 s at 6 rad/s, and rounding.
      CHECK(angle_between(before.orientation_wb, after.orientation_wb) < 2e-11);
      CHECK((before.position_w - after.position_w).norm() < 2e-11);
    }
  }
}

TEST_CASE("No integrator moves an immovable body or does anything in no time",
          "[unit][integrate]") {
  const BodyProperties fixed = fixed_box_properties(Vec3::Ones());
  const BodyProperties body = box_properties(Vec3(1.0, 2.0, 3.0), 1.0);
  Random random(33);
  for (const Step step : {step_forward_euler, step_semi_implicit, fly}) {
    for (const RotationRule rule : rotation_rules()) {
      const BodyState still = make_state(fixed, Vec3(1.0, 2.0, 3.0), random.orientation());
      BodyState state = still;
      step(fixed, state, kGravityW, 0.1, rule);
      CHECK(same_state(state, still));

      const BodyState moving = random_state(random, body, 1.0, 5.0, 5.0);
      state = moving;
      step(body, state, kGravityW, 0.0, rule);
      CHECK(same_state(state, moving));
    }
  }
}

TEST_CASE("Micro-steps refuse a length that is not above 0 or would take for ever",
          "[unit][integrate]") {
  const BodyProperties body = box_properties(Vec3::Ones(), 1.0);
  BodyState state;
  const auto with = [&](double micro_step) {
    fly_in_micro_steps(body, state, kGravityW, 1.0, RotationRule::frozen, micro_step);
  };
  CHECK_THROWS_WITH(with(0.0), "tumble: micro_step = 0: expected a number above 0");
  CHECK_THROWS_AS(with(-1.0), std::invalid_argument);
  CHECK_THROWS_AS(with(kNan), std::invalid_argument);
  CHECK_THROWS_WITH(with(1e-9),
                    "tumble: micro_step = 1e-09: expected at least a millionth of dt = 1");
}

TEST_CASE(
    "Flight keeps energy, linear momentum but for gravity, and angular momentum about the "
    "centre of mass",
    "[exact][energy]") {
  Random random(34);
  World world = ground_world();
  world.add(fixed_box_properties(Vec3::Ones()), BodyState{});
  double mass = 0.0;
  for (int i = 0; i < 5; ++i) {
    const BodyProperties body = random_box(random);
    world.add(body, random_state(random, body, 3.0, 5.0, 5.0));
    mass += body.mass;
  }
  Vec3 center = Vec3::Zero();
  for (std::size_t i = 2; i < world.states().size(); ++i)
    center += world.bodies()[i].mass * world.states()[i].position_w / mass;
  const double energy = energy_of(world).total();
  const Vec3 linear = linear_momentum(world);
  const Vec3 angular = angular_momentum(world);
  const double t = 2.0;
  for (std::size_t i = 0; i < world.states().size(); ++i)
    for (int step = 0; step < 2000; ++step)
      fly(world.bodies()[i], world.states()[i], world.gravity_w, t / 2000, RotationRule::rk4);
  // About the origin gravity turns by M c(t) x g, with the centre of mass on its own parabola.
  const Vec3 torque_integral =
      mass * (center * t + 0.5 * t * t * (linear / mass)).cross(world.gravity_w);
  // Relative rounding of 2000 steps on energies of 1 kJ; the rule's energy error is 1e-12.
  CHECK(std::abs(energy_of(world).total() / energy - 1.0) < 1e-11);  // measured 9e-13
  CHECK((linear_momentum(world) - linear - mass * t * world.gravity_w).norm() <
        1e-10);                                                                // measured 2e-11
  CHECK((angular_momentum(world) - angular - torque_integral).norm() < 1e-9);  // measured 1e-10
}

TEST_CASE("Potential energy is m g times the height, and immovable bodies have none",
          "[unit][energy]") {
  World world = ground_world();
  world.add(fixed_box_properties(Vec3::Ones()), Vec3(0.0, 5.0, 0.0));
  CHECK(energy_of(world).total() == 0.0);
  world.add(box_properties(Vec3::Ones(), 2.0), Vec3(1.0, 3.0, 1.0), Quat::Identity(),
            Vec3(2.0, 0.0, 0.0));
  CHECK(energy_of(world).potential == near(2.0 * 9.81 * 3.0).epsilon(1e-15));
  CHECK(energy_of(world).kinetic == 4.0);
  CHECK(linear_momentum(world) == Vec3(4.0, 0.0, 0.0));
  CHECK(angular_momentum(world) == Vec3(0.0, 4.0, -12.0));  // x × P
}
