/// \file
/// \brief Chance in collisions: what it must never do, and that it can be repeated.
#include "tumble/contact/collision_noise.hpp"

#include "support/test.hpp"

namespace {

struct Case {
  World world;
  std::vector<MovingBody> moving;
  Contact contact;
};

// Two random bricks that approach each other at a random point.
Case random_case(Random& random) {
  Case c;
  const bool fixed = random.unit() < 0.3;
  const Vec3 size(random.uniform(0.1, 2.0), random.uniform(0.1, 2.0), random.uniform(0.1, 2.0));
  const Quat q = random.orientation();
  const Vec3 v = random.in_cube(5.0);
  const Vec3 w = random.in_cube(5.0);
  if (fixed) {
    const BodyProperties wall = fixed_box_properties(Vec3::Ones());
    c.world.add(wall, Vec3::Zero());
  } else {
    c.world.add(box_properties(Vec3::Ones(), 1.0), Vec3::Zero(), Quat::Identity(),
                random.in_cube(5.0));
  }
  c.world.add(box_properties(size, random.uniform(0.1, 10.0)), Vec3(0.0, 1.0, 0.0), q, v, w);
  load_moving_bodies(c.world, c.moving);
  c.contact.first_id = c.world.ids()[0];
  c.contact.second_id = c.world.ids()[1];
  c.contact.first = 0;
  c.contact.second = 1;
  c.contact.normal_w = random.direction();
  c.contact.restitution = random.unit();
  c.contact.count = 1;
  c.contact.points[0].position_w = random.in_cube(0.8);
  if (c.contact.normal_w.dot(
          relative_velocity(c.moving[0], c.moving[1], c.contact.points[0].position_w)) > 0.0)
    c.contact.normal_w = -c.contact.normal_w;
  return c;
}

double kinetic(const Case& c) {
  World world = c.world;
  store_moving_bodies(c.moving, world);
  return kinetic_energy(world.bodies()[0], world.states()[0]) +
         kinetic_energy(world.bodies()[1], world.states()[1]);
}

}  // namespace

TEST_CASE("Chance never adds energy to a collision and never lets the bodies go on approaching",
          "[exact][impulse_damped]") {
  Random random(3);
  NoiseOptions much;
  much.normal = 0.5;  // ten times the default: the cases that must be drawn back are frequent
  int varied = 0;
  for (int trial = 0; trial < 5000; ++trial) {
    Case c = random_case(random);
    const double before = kinetic(c);
    const NoisyCollision noisy =
        vary(c.contact, c.moving, much, random.fork(static_cast<std::uint64_t>(trial)));
    varied += noisy.normal_w != c.contact.normal_w ? 1 : 0;
    CHECK(noisy.restitution >= 0.0);
    CHECK(noisy.restitution <= 1.0);
    const Vec3& point_w = c.contact.points[0].position_w;
    const Vec3 u_w = relative_velocity(c.moving[0], c.moving[1], point_w);
    const Mat3 k_w = inverse_mass_at(c.moving[0], c.moving[1], point_w);
    const double impulse = -(1.0 + noisy.restitution) * noisy.normal_w.dot(u_w) /
                           noisy.normal_w.dot(k_w * noisy.normal_w);
    REQUIRE(impulse > 0.0);
    apply_impulse(c.moving[0], c.moving[1], point_w, impulse * noisy.normal_w);
    // Rounding of energies of up to 500 J.
    CHECK(kinetic(c) <= before * (1.0 + 1e-13));
    CHECK(c.contact.normal_w.dot(relative_velocity(c.moving[0], c.moving[1], point_w)) >= -1e-12);
  }
  CHECK(varied > 4500);  // 4996 of 5000; the rest is left as it is
}

TEST_CASE("Chance is the same whatever was drawn before, and another one in another step",
          "[determinism][impulse_damped]") {
  Random random(5);
  const Case c = random_case(random);
  const NoiseOptions options;
  const Random step = Random(1).fork(17);
  const NoisyCollision once = vary(c.contact, c.moving, options, step);
  const NoisyCollision again = vary(c.contact, c.moving, options, step);
  CHECK(once.normal_w == again.normal_w);
  CHECK(once.restitution == again.restitution);
  CHECK(vary(c.contact, c.moving, options, Random(1).fork(18)).normal_w != once.normal_w);
  CHECK(vary(c.contact, c.moving, options, Random(2).fork(17)).normal_w != once.normal_w);
}

TEST_CASE("The normal turns by its standard deviation", "[reference][impulse_damped]") {
  // A cube that falls without spin on its centre: nothing has to be drawn back.
  World world = ground_world();
  world.add(box_properties(Vec3::Ones(), 1.0), Vec3(0.0, 0.5, 0.0), Quat::Identity(),
            Vec3(0.0, -5.0, 0.0));
  std::vector<MovingBody> moving = test::moving_bodies(world);
  Contact contact{.first_id = world.ids()[0],
                  .second_id = world.ids()[1],
                  .second = 1,
                  .restitution = 0.5,
                  .count = 1};
  const NoiseOptions options;
  double squares = 0.0;
  double mean = 0.0;
  constexpr int kDraws = 20000;
  for (int k = 0; k < kDraws; ++k) {
    const NoisyCollision noisy =
        vary(contact, moving, options, Random(1).fork(static_cast<std::uint64_t>(k)));
    squares += noisy.normal_w.x() * noisy.normal_w.x() / kDraws;
    mean += noisy.restitution / kDraws;
  }
  // Two components share an angle whose square has the mean 2 σ² (1 - exp(-4.5)) for σ = 0.05,
  // being 3 σ at most: 0.04972 for each. The error of 20000 draws is a quarter of a per cent.
  CHECK(std::sqrt(squares) == near(0.04972, 0.0004));
  CHECK(mean == near(0.5, 0.002));
}

TEST_CASE("Only collisions on the right side of the threshold are left to chance",
          "[unit][impulse_damped]") {
  World world = ground_world();
  const BodyId id = world.add(box_properties(Vec3::Ones(), 1.0), Vec3(0.0, 0.5, 0.0),
                              Quat::Identity(), Vec3(0, -1.4, 0));
  std::vector<MovingBody> moving;
  Contact contact{.second = 1, .count = 1};
  const auto chance = [&](double speed, Randomness where) {
    world.set_velocity(id, Vec3(0.0, -speed, 0.0), Vec3::Zero());
    load_moving_bodies(world, moving);
    return left_to_chance(contact, moving, world, {.where = where});
  };
  // The threshold is 0.5 sqrt(9.81) = 1.566 m/s.
  CHECK(chance(1.6, Randomness::fast));
  CHECK_FALSE(chance(1.5, Randomness::fast));
  CHECK_FALSE(chance(1.6, Randomness::slow));
  CHECK(chance(1.5, Randomness::slow));
  CHECK(chance(1.5, Randomness::all));
  CHECK_FALSE(chance(-1.6, Randomness::all));  // separating
  CHECK_FALSE(chance(1.6, Randomness::off));
}
