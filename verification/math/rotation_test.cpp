/// \file
/// \brief Rotation vectors, turning, angles between orientations, and the way along an arc.
#include "tumble/math/rotation.hpp"

#include "support/test.hpp"

namespace {

constexpr double pi = std::numbers::pi;

bool same(const Quat& p, const Quat& q) { return (p.coeffs().array() == q.coeffs().array()).all(); }

}  // namespace

TEST_CASE("A rotation vector turns about its axis by its length", "[exact][rotation]") {
  // 1e-15: a few roundings of numbers up to 1 (measured 2e-16).
  const Vec3 z = rotation_from_vector(Vec3(0.0, 0.0, pi / 2.0)) * Vec3(1.0, 0.0, 0.0);
  CHECK((z - Vec3(0.0, 1.0, 0.0)).norm() <= 1e-15);
  const Quat whole = rotation_from_vector(Vec3(2.0 * pi, 0.0, 0.0));
  CHECK(angle_between(whole, Quat::Identity()) <= 1e-15);
  CHECK(same(rotation_from_vector(Vec3::Zero()), Quat::Identity()));
  // No digit is lost where the square of the length is 0.
  CHECK(rotation_from_vector(Vec3(1e-200, 0.0, 0.0)).x() == 0.5e-200);
}

TEST_CASE("The logarithm takes back the exponential for angles up to half a turn",
          "[exact][rotation]") {
  Random random(1);
  double worst = 0.0;
  for (int i = 0; i < 5000; ++i) {
    const double size = i % 2 == 0 ? random.uniform(0.0, 3.14) : std::exp2(-400.0 * random.unit());
    const Vec3 r = size * random.direction();
    worst = std::max(worst, (rotation_vector(rotation_from_vector(r)) - r).norm() / r.norm());
  }
  // Relative: the quaternion's own rounding, a few 1e-16, over sin and atan2 (measured 4e-16).
  CHECK(worst <= 3e-15);
}

TEST_CASE("The logarithm goes the shortest way and takes q and -q for one orientation",
          "[unit][rotation]") {
  Random random(2);
  Failures wrong;
  for (int i = 0; i < 2000; ++i) {
    const Quat q = random.orientation();
    const Quat minus(-q.w(), -q.x(), -q.y(), -q.z());
    if (rotation_vector(q) != rotation_vector(minus)) ++wrong["different"];
    if (rotation_vector(q).norm() > pi + 1e-15) ++wrong["long way"];
  }
  CHECK(wrong == Failures{});
  // Half a turn, where both ways are equally short.
  for (const double w : {0.0, -0.0})
    for (const double sign : {1.0, -1.0}) {
      CHECK(rotation_vector(Quat(w, sign, 0.0, 0.0)) == Vec3(pi, 0.0, 0.0));
      CHECK(rotation_vector(Quat(w, 0.0, 0.0, sign)) == Vec3(0.0, 0.0, pi));
    }
  CHECK(rotation_vector(Quat::Identity()) == Vec3::Zero());
  // The length of q does not matter.
  const Vec3 r(0.1, 0.2, -0.3);
  const Quat q = rotation_from_vector(r);
  CHECK((rotation_vector(Quat(7.0 * q.coeffs())) - r).norm() <= 1e-15);
}

TEST_CASE("The angle between orientations keeps its digits when it is small", "[exact][rotation]") {
  Random random(4);
  for (const double angle : {1e-12, 1e-6, 0.1, 1.0, 3.0, pi}) {
    const Vec3 axis = random.direction();
    const Quat q = rotation_from_vector(angle * axis);
    // 1e-15 relative from the identity, where components are exact to their last digit.
    CHECK(std::abs(angle_between(Quat::Identity(), q) / angle - 1.0) <= 1e-15);
    const Quat p = random.orientation();
    const Quat pq = q * p;
    // Elsewhere 1e-15 rad: rounding of components near 1 (measured 4e-16).
    CHECK(std::abs(angle_between(p, pq) - angle) <= 1e-15);
    CHECK(angle_between(p, pq) == angle_between(pq, p));
    const Quat minus(-pq.w(), -pq.x(), -pq.y(), -pq.z());
    CHECK(angle_between(p, pq) == angle_between(p, minus));
  }
  const Quat p = random.orientation();
  CHECK(angle_between(p, p) == 0.0);
}

TEST_CASE(
    "On the way from one orientation to another the angle grows evenly, the shorter way round",
    "[exact][rotation]") {
  Random random(9);
  for (int i = 0; i < 100; ++i) {
    const Quat from = random.orientation();
    Quat to = random.orientation();
    const double whole = angle_between(from, to);
    if (i % 2 == 0) to.coeffs() *= -1.0;  // the same orientation
    for (const double share : {0.25, 0.5, 1.0}) {
      const Quat between = rotation_between(from, to, share);
      // [rad] rounding of components near 1 and of an angle up to pi.
      CHECK(std::abs(angle_between(from, between) - share * whole) <= 1e-14);
      CHECK(std::abs(angle_between(between, to) - (1.0 - share) * whole) <= 1e-14);
    }
  }
  const Quat still = random.orientation();
  CHECK(same(rotation_between(still, still, 0.3), still));
}

TEST_CASE("Degrees turn about the world's x, then y, then z", "[exact][rotation]") {
  const Vec3 deg(30.0, -50.0, 110.0);
  const Quat x(Eigen::AngleAxisd(deg.x() * pi / 180.0, Vec3::UnitX()));
  const Quat y(Eigen::AngleAxisd(deg.y() * pi / 180.0, Vec3::UnitY()));
  const Quat z(Eigen::AngleAxisd(deg.z() * pi / 180.0, Vec3::UnitZ()));
  CHECK(angle_between(rotation_from_degrees(deg), z * (y * x)) <= 1e-15);
  CHECK(angle_between(rotation_from_degrees(deg + Vec3(360.0, -720.0, 36000.0)), z * (y * x)) <=
        1e-15);
}

TEST_CASE("Right angles in degrees give the exact quaternion", "[exact][rotation]") {
  const double s = std::sqrt(0.5);
  CHECK(same(rotation_from_degrees(Vec3::Zero()), Quat::Identity()));
  CHECK(same(rotation_from_degrees(Vec3(90.0, 0.0, 0.0)), Quat(s, s, 0.0, 0.0)));
  CHECK(same(rotation_from_degrees(Vec3(0.0, -90.0, 0.0)), Quat(s, 0.0, -s, 0.0)));
  CHECK(same(rotation_from_degrees(Vec3(0.0, 0.0, 180.0)), Quat(0.0, 0.0, 0.0, 1.0)));
  CHECK(same(rotation_from_degrees(Vec3(90.0, 90.0, 0.0)), Quat(0.5, 0.5, 0.5, -0.5)));
  int wrong = 0;
  for (int x = -4; x <= 4; ++x)
    for (int y = -4; y <= 4; ++y)
      for (int z = -4; z <= 4; ++z) {
        const Quat q = rotation_from_degrees(90.0 * Vec3(x, y, z));
        for (int k = 0; k < 4; ++k) {
          const double c = std::abs(q.coeffs()[k]);
          if (c != 0.0 && c != 0.5 && c != s && c != 1.0) ++wrong;
        }
        if (!(std::abs(q.norm() - 1.0) <= 3e-16)) ++wrong;
        const Quat close(Eigen::AngleAxisd(z * pi / 2.0, Vec3::UnitZ()) *
                         Eigen::AngleAxisd(y * pi / 2.0, Vec3::UnitY()) *
                         Eigen::AngleAxisd(x * pi / 2.0, Vec3::UnitX()));
        if (!(angle_between(q, close) <= 4e-15)) ++wrong;
      }
  CHECK(wrong == 0);
  // A right angle beside an ordinary one is exact in its own part: no turn about y or z here.
  const Quat q = rotation_from_degrees(Vec3(30.0, 0.0, 180.0));
  CHECK(q.w() == 0.0);
  CHECK(q.x() == 0.0);
}

TEST_CASE("Quaternions are brought to length 1, and refused without a direction",
          "[unit][rotation]") {
  CHECK(same(normalised(Quat(0.0, 3.0, 0.0, 4.0)), Quat(0.0, 0.6, 0.0, 0.8)));
  CHECK(std::abs(normalised(Quat(1e-149, 1e-149, 0.0, 0.0)).norm() - 1.0) <= 3e-16);
  using Wrong = std::invalid_argument;
  CHECK_THROWS_WITH(normalised(Quat(0.0, 0.0, 0.0, 0.0)), Contains("length"));
  CHECK_THROWS_AS(normalised(Quat(1e200, 0.0, 0.0, 0.0)), Wrong);
  CHECK_THROWS_AS(normalised(Quat(kNan, 0.0, 0.0, 1.0)), Wrong);
  CHECK_THROWS_AS(rotation_vector(Quat(kNan, 0.0, 0.0, 1.0)), Wrong);
  CHECK_THROWS_WITH(rotation_from_vector(Vec3(0.0, kNan, 0.0)), Contains("finite"));
  CHECK_THROWS_WITH(rotation_from_vector(Vec3(0.0, 1e151, 0.0)), Contains("1e150"));
  CHECK_THROWS_AS(turned(Quat::Identity(), Vec3(kNan, 0.0, 0.0), 0.1), Wrong);
  CHECK_THROWS_AS(turned(Quat::Identity(), Vec3(1.0, 0.0, 0.0), kNan), Wrong);
  CHECK_THROWS_WITH(rotation_from_degrees(Vec3(0.0, kNan, 0.0)), Contains("xyz_deg"));
}

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
