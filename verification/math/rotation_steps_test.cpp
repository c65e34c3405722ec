/// \file
/// \brief The way along an arc, and the rate of a rotation vector.

#include "support/test.hpp"

using namespace tumble;

namespace {

constexpr double pi = std::numbers::pi;

}  // namespace

TEST_CASE("A point that goes along an arc keeps its distance from the axis", "[exact][rotation]") {
  Random random(21);
  double worst = 0.0;
  for (int i = 0; i < 2000; ++i) {
    // Angles of every size, also where series take over.
    const double angle = i % 2 == 0 ? random.uniform(0.0, 20.0) : std::exp2(-40.0 * random.unit());
    const Vec3 r = angle * random.direction();
    const Vec3 from_axis = random.in_cube(2.0);
    const Vec3 to = rotation_from_vector(r) * from_axis;
    worst = std::max(worst, (from_axis + along_arc(r, r.cross(from_axis)) - to).norm());
  }
  CHECK(worst <= 2e-14);  // [m] roundings of numbers up to 20 · 3 m, squared over the angle
}

TEST_CASE("Along its axis and without a turn an arc is straight", "[exact][rotation]") {
  const Vec3 d(1.0, -2.0, 3.0);
  CHECK(along_arc(Vec3::Zero(), d) == d);
  CHECK(along_arc(Vec3(1e-200, 0.0, 0.0), d) == d);
  CHECK((along_arc(0.7 * d, d) - d).norm() <= 1e-14);
  // Half a turn about z: as far as the diameter, which is 2/π of the way, to the left.
  CHECK((along_arc(Vec3(0.0, 0.0, pi), Vec3(pi, 0.0, 0.0)) - Vec3(0.0, 2.0, 0.0)).norm() <= 1e-15);
  // A full turn brings it back, but for the part along the axis.
  CHECK((along_arc(Vec3(0.0, 0.0, 2.0 * pi), Vec3(1.0, 2.0, 3.0)) - Vec3(0.0, 0.0, 3.0)).norm() <=
        2e-15);
}

TEST_CASE("The rate of a rotation vector is that of its rotation", "[exact][rotation]") {
  Random random(24);
  double worst = 0.0;
  for (int i = 0; i < 500; ++i) {
    const double angle = i % 5 == 0 ? 1e-5 * random.unit() : random.uniform(0.0, 3.0);
    const Vec3 r = angle * random.direction();
    const Vec3 omega = random.in_cube(2.0);
    // The difference quotient, from both sides, of what the rotation's logarithm does.
    const double dt = 1e-5;
    const auto later = [&](double time) {
      return rotation_vector(rotation_from_vector(time * omega) * rotation_from_vector(r));
    };
    const Vec3 rate = (later(dt) - later(-dt)) / (2.0 * dt);
    worst = std::max(worst, (rate - rotation_vector_rate(r, omega)).norm());
  }
  CHECK(worst <= 1e-8);  // [rad/s] (ω dt)² times numbers up to 10, and rounding over dt
}

TEST_CASE("A rotation vector grows along itself at the rate at which its body turns",
          "[exact][rotation]") {
  const Vec3 omega(1.0, -2.0, 3.0);
  CHECK(rotation_vector_rate(Vec3::Zero(), omega) == omega);
  CHECK((rotation_vector_rate(0.5 * omega, omega) - omega).norm() <= 1e-15);
  CHECK((rotation_vector_rate(-1.6 * omega, omega) - omega).norm() <= 1e-14);
  // Half a turn about z, turned about x: half of it that way, and a quarter of a turn's share across.
  const Vec3 rate = rotation_vector_rate(Vec3(0.0, 0.0, pi), Vec3(1.0, 0.0, 0.0));
  CHECK((rate - Vec3(0.0, -pi / 2.0, 0.0)).norm() <= 1e-15);
}

TEST_CASE("Arcs and rates of rotations that are no numbers or too long are refused",
          "[unit][rotation]") {
  const Vec3 d = Vec3::Ones();
  CHECK_THROWS_WITH(along_arc(Vec3(0.0, kNan, 0.0), d), Contains("rotation_w"));
  CHECK_THROWS_WITH(along_arc(Vec3(0.0, 1e151, 0.0), d), Contains("1e150"));
  CHECK_THROWS_WITH(along_arc(Vec3(0.0, 1e300, 0.0), d), Contains("1e150"));
  CHECK(along_arc(Vec3(0.0, 1e9, 0.0), d).allFinite());
  CHECK_THROWS_WITH(rotation_vector_rate(Vec3(0.0, kNan, 0.0), d), Contains("rotation_w"));
  CHECK_THROWS_WITH(rotation_vector_rate(Vec3(0.0, 6.2832, 0.0), d), Contains("full turn"));
  CHECK(rotation_vector_rate(Vec3(0.0, 6.2831, 0.0), d).allFinite());
}
