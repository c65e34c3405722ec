/// \file
/// \brief Tests of inverse masses at a point and of impulses on a pair.
#include "tumble/contact/effective_mass.hpp"

#include "contact/impact_cases.hpp"
#include "support/catch.hpp"

using namespace tumble;
using namespace tumble::impact_cases;

TEST_CASE("Two immovable bodies have infinite mass at a point", "[unit][effective_mass]") {
  const Heavy a = fixed();
  const Heavy b = fixed();
  CHECK(inverse_mass_at(a.moving, b.moving, Vec3(1, 2, 3)) == Mat3::Zero());
  CHECK(std::isinf(effective_mass(a.moving, b.moving, Vec3(1, 2, 3), Vec3::UnitY())));
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
