/// \file
/// \brief Tests of inverse masses at a point and of impulses on a pair.
#include "tumble/contact/effective_mass.hpp"

#include "contact/impact_cases.hpp"
#include "support/catch.hpp"

using namespace tumble;
using namespace tumble::impact_cases;

TEST_CASE("A cube and a tall box that meet off centre weigh 1 / 1.73958333 along the normal",
          "[exact][effective_mass]") {
  const Heavy a = box(Vec3::Zero(), Vec3::Ones(), 1.0, Vec3(2, 0, 0));
  const Heavy b = box(Vec3(1.0, 0.75, 0.0), Vec3(1, 2, 1), 3.0, Vec3::Zero());
  const Vec3 point(0.5, 0.125, 0.0);
  // 1 + 1/3 + 0.125² · 6 + 0.625² / 1.25 = 167/96 [1/kg]; rounding only.
  const double expected = 96.0 / 167.0;
  CHECK(effective_mass(a.moving, b.moving, point, Vec3::UnitX()) == near(expected).epsilon(1e-15));
  // Turning the bodies' order or the direction round changes nothing.
  CHECK(effective_mass(b.moving, a.moving, point, -Vec3::UnitX()) == near(expected).epsilon(1e-15));
}

TEST_CASE("Two immovable bodies have infinite mass at a point", "[unit][effective_mass]") {
  const Heavy a = fixed();
  const Heavy b = fixed();
  CHECK(inverse_mass_at(a.moving, b.moving, Vec3(1, 2, 3)) == Mat3::Zero());
  CHECK(std::isinf(effective_mass(a.moving, b.moving, Vec3(1, 2, 3), Vec3::UnitY())));
}

TEST_CASE("An impulse changes the relative velocity by K j and keeps both momenta",
          "[unit][effective_mass]") {
  Random random(1);
  int wrong_velocity = 0;
  int wrong_momentum = 0;
  int not_semidefinite = 0;
  for (int i = 0; i < 2000; ++i) {
    Heavy a = random_box(random);
    Heavy b = random_box(random);
    const Vec3 point = random.in_cube(3.0);
    const Vec3 j = random.in_cube(1.0);
    const Mat3 k = inverse_mass_at(a.moving, b.moving, point);
    const Vec3 u = relative_velocity(a.moving, b.moving, point);
    const Vec3 p = momentum(a) + momentum(b);
    const Vec3 l = angular_momentum(a) + angular_momentum(b);
    const double scale_p = momentum(a).norm() + momentum(b).norm() + j.norm();
    const double scale_l = angular_momentum(a).norm() + angular_momentum(b).norm() +
                           point.norm() * j.norm() + scale_p * 5.0;
    apply_impulse(a.moving, b.moving, point, j);
    const Vec3 after = relative_velocity(a.moving, b.moving, point);
    // Relative to the sizes involved; measured below 2e-15.
    if ((after - u - k * j).norm() > 1e-13 * (u.norm() + k.norm() * j.norm() + 50.0)) {
      ++wrong_velocity;
    }
    if ((momentum(a) + momentum(b) - p).norm() > 1e-13 * scale_p) ++wrong_momentum;
    if ((angular_momentum(a) + angular_momentum(b) - l).norm() > 1e-12 * scale_l) ++wrong_momentum;
    if (j.dot(k * j) <= 0.0 || (k - k.transpose()).norm() > 1e-14 * k.norm()) ++not_semidefinite;
  }
  CHECK(wrong_velocity == 0);
  CHECK(wrong_momentum == 0);
  CHECK(not_semidefinite == 0);
}

TEST_CASE("A body that is locked along y takes no impulse along y", "[unit][effective_mass]") {
  // What geometric stability (thesis 5.4) does to a body: no rise, no tilt.
  Heavy a = fixed();
  Heavy b = box(Vec3::Zero(), Vec3::Ones(), 2.0, Vec3(0, -1, 0));
  b.moving.inverse_mass.y() = 0.0;
  b.moving.inverse_inertia_w = Vec3(0.0, 3.0, 0.0).asDiagonal();
  const Vec3 point(0.5, -0.5, 0.5);
  CHECK(std::isinf(effective_mass(a.moving, b.moving, point, Vec3::UnitY())));
  apply_impulse(a.moving, b.moving, point, Vec3(0.0, 7.0, 0.0));
  CHECK(b.moving.velocity_w == Vec3(0, -1, 0));
  CHECK(b.moving.angular_velocity_w == Vec3::Zero());
}

TEST_CASE("The tangents make a right-handed frame with every normal", "[unit][effective_mass]") {
  Random random(2);
  double worst = 0.0;
  for (int i = 0; i < 2000; ++i) {
    const Vec3 n = i < 6 ? Vec3((i % 2 == 0 ? 1.0 : -1.0) * Vec3::Unit(i / 2)) : random.direction();
    const Tangents t = tangents_of(n);
    Mat3 frame;
    frame << t.first_w, t.second_w, n;
    worst = std::max(worst, (frame.transpose() * frame - Mat3::Identity()).norm());
    worst = std::max(worst, std::abs(frame.determinant() - 1.0));
  }
  CHECK(worst < 1e-14);  // [-] rounding; measured 6.5e-16
}
