/// \file
/// \brief Making bodies, and the velocities behind their momenta.
#include "tumble/dynamics/body.hpp"

#include "dynamics/random_bodies.hpp"
#include "support/test.hpp"

TEST_CASE("A box of 3 by 2 by 1 m and 12 kg has the moments 5, 10 and 13", "[unit][body]") {
  const BodyProperties body = box_properties(Vec3(3.0, 2.0, 1.0), 12.0, 0.25, 0.75);
  CHECK(body.inertia_b == Vec3(5.0, 10.0, 13.0));
  CHECK(body.inverse_inertia_b == Vec3(1.0 / 5.0, 1.0 / 10.0, 1.0 / 13.0));
  CHECK(body.mass == 12.0);
  CHECK(body.inverse_mass == 1.0 / 12.0);
  CHECK(body.friction == 0.25);
  CHECK(body.restitution == 0.75);
  CHECK(body.movable());
}

TEST_CASE("Equal edges give moments that are equal to the last bit", "[unit][body]") {
  Random random(11);
  int different = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    const double edge = random.uniform(0.01, 10.0);
    const double other = random.uniform(0.01, 10.0);
    const double mass = random.uniform(0.01, 10.0);
    const Vec3 xy = box_properties(Vec3(edge, edge, other), mass).inertia_b;
    const Vec3 yz = box_properties(Vec3(other, edge, edge), mass).inertia_b;
    const Vec3 xz = box_properties(Vec3(edge, other, edge), mass).inertia_b;
    different += xy.x() != xy.y() || yz.y() != yz.z() || xz.x() != xz.z() ? 1 : 0;
  }
  CHECK(different == 0);
}

TEST_CASE("An immovable body has no inverse mass, no velocity and no energy", "[unit][body]") {
  for (const BodyProperties& body :
       {ground_properties(), fixed_box_properties(Vec3(1.0, 2.0, 3.0))}) {
    CHECK_FALSE(body.movable());
    CHECK(body.mass == kInfinity);
    const BodyState state = make_state(body, Vec3(1.0, 2.0, 3.0));
    CHECK(velocity(body, state) == Vec3::Zero());
    CHECK(angular_velocity(body, state) == Vec3::Zero());
    CHECK(inverse_inertia_w(body, state.orientation_wb) == Mat3::Zero());
    CHECK(kinetic_energy(body, state) == 0.0);
  }
}

TEST_CASE("Velocities go into momenta and come back", "[unit][body]") {
  Random random(12);
  double worst = 0.0;
  for (int trial = 0; trial < 1000; ++trial) {
    const BodyProperties body = random_box(random);
    const Quat q = random.orientation();
    const Vec3 v = random.in_cube(10.0);
    const Vec3 omega = random.in_cube(10.0);
    const BodyState state = make_state(body, Vec3::Zero(), q, v, omega);
    worst = std::max(worst, (velocity(body, state) - v).norm());
    worst = std::max(worst, (angular_velocity(body, state) - omega).norm());
    const Mat3 inverse = inverse_inertia_w(body, q);
    worst = std::max(worst, (inverse * state.angular_momentum_w - omega).norm());
    if (inverse != inverse.transpose()) worst = kInfinity;  // symmetric to the last bit
    const double energy = 0.5 * (body.mass * v.squaredNorm() + omega.dot(state.angular_momentum_w));
    worst = std::max(worst, std::abs(kinetic_energy(body, state) / energy - 1.0));
  }
  // Rounding of some 20 operations on numbers up to 17, times ratios of moments up to 25.
  CHECK(worst < 1e-12);  // measured 8e-14
}

TEST_CASE("Bodies refuse sizes, masses and coefficients that make no sense", "[unit][body]") {
  const Vec3 size(1.0, 2.0, 3.0);
  CHECK_THROWS_WITH(box_properties(Vec3(1.0, 0.0, 3.0), 1.0),
                    "tumble: size.y = 0: expected a finite number above 0");
  CHECK_THROWS_WITH(box_properties(size, -1.0),
                    "tumble: mass = -1: expected a finite number above 0");
  CHECK_THROWS_AS(box_properties(Vec3(1.0, 1.0, kNan), 1.0), std::invalid_argument);
  CHECK_THROWS_AS(box_properties(size, kInfinity), std::invalid_argument);
  CHECK_THROWS_WITH(box_properties(size, 1e31),
                    "tumble: mass = 1e+31: expected a number from 1e-30 to 1e+30");
  for (const double mass : {1e-320, 1e-300, 9e-31, 1.1e30, 1e300})
    CHECK_THROWS_AS(box_properties(size, mass), std::invalid_argument);
  CHECK_THROWS_WITH(
      box_properties(1e-200 * size, 1.0),
      "tumble: shortest edge of size = 1e-200: expected a number from 1e-20 to 1e+20");
  CHECK_THROWS_WITH(box_properties(Vec3(1.0, 1e200, 1.0), 1.0),
                    "tumble: longest edge of size = 1e+200: expected a number from 1e-20 to 1e+20");
  CHECK_THROWS_WITH(
      box_properties(1e-19 * Vec3::Ones(), 12.0),
      "tumble: smallest moment of inertia, of a box of 12 kg with edges from 1e-19 to "
      "1e-19 m, = 2e-38: expected a number from 1e-30 to 1e+30");
  CHECK_THROWS_WITH(fixed_box_properties(Vec3(1.0, 1.0, 1e155)),
                    Contains("longest edge of size = 1e+155"));
  CHECK_THROWS_AS(box_properties(size, 1.0, -0.1), std::invalid_argument);
  CHECK_THROWS_WITH(box_properties(size, 1.0, 0.5, 1.5),
                    "tumble: restitution = 1.5: expected a number from 0 to 1");
  CHECK_THROWS_AS(fixed_box_properties(-size), std::invalid_argument);
  CHECK_THROWS_AS(fixed_box_properties(size, kNan), std::invalid_argument);
  CHECK_THROWS_AS(ground_properties(-1.0), std::invalid_argument);
  CHECK_THROWS_AS(ground_properties(0.5, -0.5), std::invalid_argument);
}

TEST_CASE("States refuse numbers that are not finite and quaternions that are not of length 1",
          "[unit][body]") {
  const BodyProperties body = box_properties(Vec3::Ones(), 1.0);
  const Quat identity = Quat::Identity();
  CHECK_THROWS_AS(make_state(body, Vec3(kNan, 0.0, 0.0)), std::invalid_argument);
  CHECK_THROWS_AS(make_state(body, Vec3::Zero(), Quat(2.0, 0.0, 0.0, 0.0)), std::invalid_argument);
  CHECK_THROWS_AS(make_state(body, Vec3::Zero(), identity, Vec3(0.0, kInfinity, 0.0)),
                  std::invalid_argument);
  CHECK_THROWS_AS(make_state(body, Vec3::Zero(), identity, Vec3::Zero(), Vec3(0.0, 0.0, kNan)),
                  std::invalid_argument);
  CHECK_THROWS_WITH(make_state(ground_properties(), Vec3::Zero(), identity, Vec3::UnitX()),
                    "tumble: an immovable body was given a velocity: expected none");
}
