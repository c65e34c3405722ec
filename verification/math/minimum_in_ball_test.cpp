/// \file
/// \brief The least value of a quadratic function within a ball: friction of a contact patch, as an example.
#include "tumble/math/minimum_in_ball.hpp"

#include "support/test.hpp"

namespace {

Vec3 random_vector(Random& random) {
  const double x = random.uniform(-1.0, 1.0);
  const double y = random.uniform(-1.0, 1.0);
  const double z = random.uniform(-1.0, 1.0);
  return {x, y, z};
}

// S (B B' + 1/10) S, with S = diag(1, 1, lever): of a patch whose friction has this lever.
Mat3 random_matrix(double lever, Random& random) {
  Mat3 b;
  for (int k = 0; k < 3; ++k) b.col(k) = random_vector(random);
  Mat3 a = b * b.transpose() + 0.1 * Mat3::Identity();
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) a(i, k) *= (i == 2 ? lever : 1.0) * (k == 2 ? lever : 1.0);
  return a;
}

}  // namespace

TEST_CASE(
    "Friction within a ball stops the motion, or is at the bound and directly against the "
    "remaining one",
    "[exact][minimum_in_ball]") {
  Random random(1);
  int stopped = 0;
  double off_bound = 0.0, not_straight = 0.0, left = 0.0;
  for (int k = 0; k < 3000; ++k) {
    const double lever = std::pow(10.0, -random.uniform(0.0, 3.0));
    const Mat3 a = random_matrix(lever, random);
    const Vec3 u = a * random_vector(random);  // stopped by an impulse of about 1
    const double limit = std::pow(10.0, random.uniform(-4.0, 1.0));
    const Vec3 impulse = minimum_in_ball(a, u, limit);
    const Vec3 end = a * impulse + u;
    REQUIRE(impulse.norm() <= limit * (1.0 + 1e-12));
    if (impulse.norm() < limit * (1.0 - 1e-12)) {
      ++stopped;
      left = std::max(left, end.norm() / u.norm());
      continue;
    }
    off_bound = std::max(off_bound, std::abs(impulse.norm() / limit - 1.0));
    not_straight = std::max(not_straight, end.cross(impulse).norm() / (u.norm() * impulse.norm()));
    REQUIRE(end.dot(impulse) <= 1e-12 * u.norm() * impulse.norm());
  }
  CHECK(stopped > 500);
  CHECK(stopped < 2500);
  CHECK(left < 1e-8);           // [-] rounding over the lever squared, 1e-16 / 1e-6, and a margin
  CHECK(off_bound < 1e-12);     // [-] rounding
  CHECK(not_straight < 1e-12);  // [-] ditto
}

TEST_CASE("Friction within a ball is finite whatever the lever and the bound",
          "[exact][minimum_in_ball]") {
  Random random(2);
  for (int k = 0; k < 3000; ++k) {
    // Levers down to rounding, whose square vanishes in the sum of the others, and bounds of nearly 0.
    const double lever = std::pow(10.0, -random.uniform(0.0, 30.0));
    const Mat3 a = random_matrix(lever, random);
    const double limit = std::pow(10.0, -random.uniform(0.0, 100.0));
    const Vec3 impulse = minimum_in_ball(a, random_vector(random), limit);
    REQUIRE(impulse.allFinite());
    REQUIRE(impulse.norm() <= limit * (1.0 + 1e-12));
  }
  CHECK(minimum_in_ball(Mat3::Identity(), Vec3::UnitX(), 0.0) == Vec3::Zero());
  CHECK(minimum_in_ball(Mat3::Identity(), Vec3::Zero(), 1.0) == Vec3::Zero());
  // Slopes and bounds whose squares vanish, as impulses do that halve in each step.
  for (int k = 0; k < 3000; ++k) {
    const double size = std::pow(10.0, -random.uniform(50.0, 320.0));
    const Mat3 a = random_matrix(1.0, random);
    const Vec3 u = random_vector(random);
    const double limit = std::pow(10.0, random.uniform(-3.0, 1.0));
    const Vec3 small = minimum_in_ball(a, size * u, size * limit);
    REQUIRE(small.allFinite());
    const double unit = std::ldexp(1.0, 600);  // a norm of such numbers would be 0
    REQUIRE((unit * small).norm() <= (1.0 + 1e-12) * unit * size * limit + 1e-50);
  }
}
