/// \file
/// \brief Corners, reach and bounds of a box.
#include "tumble/geometry/box.hpp"

#include "geometry/boxes.hpp"
#include "support/test.hpp"

namespace {

// [-] Sums of three products of numbers of order 10: a few times 1e-16 times 10.
constexpr double kRounding = 2e-14;

}  // namespace

TEST_CASE("Corner k of a box lies on the sides that the bits of k name", "[unit][box]") {
  const Box box = make_box(Vec3(1.0, 2.0, 3.0), Quat::Identity(), Vec3(2.0, 4.0, 6.0));
  CHECK(corner_of(box, 0) == Vec3(0.0, 0.0, 0.0));
  CHECK(corner_of(box, 1) == Vec3(2.0, 0.0, 0.0));
  CHECK(corner_of(box, 2) == Vec3(0.0, 4.0, 0.0));
  CHECK(corner_of(box, 4) == Vec3(0.0, 0.0, 6.0));
  CHECK(corner_of(box, 7) == Vec3(2.0, 4.0, 6.0));
  const std::array<Vec3, 8> all = corners_of(box);
  for (int k = 0; k < 8; ++k) CHECK(all[idx(k)] == corner_of(box, k));
}

TEST_CASE("Reach and bounds of a box are those of its corners", "[unit][box]") {
  Random random(1);
  double worst_reach = 0.0, worst_bounds = 0.0, worst_margin = 0.0;
  for (int trial = 0; trial < 2000; ++trial) {
    const Box box = random_box(random, 5.0, 1.0, 0.1);
    const Vec3 direction = random.direction();
    const double margin = random.unit();
    double farthest = -kInfinity;
    Vec3 low = Vec3::Constant(kInfinity), high = -low;
    for (const Vec3& corner : corners_of(box)) {
      farthest = std::max(farthest, direction.dot(corner - box.center_w));
      low = low.cwiseMin(corner);
      high = high.cwiseMax(corner);
    }
    worst_reach = std::max(worst_reach, std::abs(reach(box, direction) - farthest));
    const Bounds tight = bounds_of(box), wide = bounds_of(box, margin);
    worst_bounds = std::max({worst_bounds, (tight.low - low).norm(), (tight.high - high).norm()});
    worst_margin = std::max({worst_margin, (tight.low - wide.low - Vec3::Constant(margin)).norm(),
                             (wide.high - tight.high - Vec3::Constant(margin)).norm()});
  }
  CHECK(worst_reach < kRounding);   // measured 1.2e-15 m
  CHECK(worst_bounds < kRounding);  // measured 1.6e-15 m
  CHECK(worst_margin < kRounding);  // measured 1.3e-15 m
}

TEST_CASE("Bounds that touch overlap, and bounds a hair apart do not", "[unit][box]") {
  const Bounds a{Vec3::Zero(), Vec3::Ones()};
  for (int k = 0; k < 3; ++k) {
    Bounds b = a;
    b.low[k] = 1.0;
    b.high[k] = 2.0;
    CHECK(overlap(a, b));
    CHECK(overlap(b, a));
    b.low[k] = std::nextafter(1.0, 2.0);
    CHECK_FALSE(overlap(a, b));
    CHECK_FALSE(overlap(b, a));
  }
  CHECK(overlap(a, a));
  CHECK(overlap(a, Bounds{Vec3::Constant(-kInfinity), Vec3::Constant(kInfinity)}));
}

TEST_CASE("A box that cannot exist is refused with the value", "[unit][box]") {
  const Quat upright = Quat::Identity();
  CHECK_THROWS_AS(make_box(Vec3(kNan, 0.0, 0.0), upright, Vec3::Ones()), std::invalid_argument);
  CHECK_THROWS_AS(make_box(Vec3(0.0, kInfinity, 0.0), upright, Vec3::Ones()),
                  std::invalid_argument);
  CHECK_THROWS_AS(make_box(Vec3::Zero(), Quat(1.0, 0.1, 0.0, 0.0), Vec3::Ones()),
                  std::invalid_argument);
  CHECK_THROWS_AS(make_box(Vec3::Zero(), Quat(0.0, 0.0, 0.0, 0.0), Vec3::Ones()),
                  std::invalid_argument);
  CHECK_THROWS_AS(make_box(Vec3::Zero(), Quat(kNan, 0.0, 0.0, 0.0), Vec3::Ones()),
                  std::invalid_argument);
  for (const double bad : {0.0, -1.0, kNan, kInfinity}) {
    for (int k = 0; k < 3; ++k) {
      Vec3 size = Vec3::Ones();
      size[k] = bad;
      CHECK_THROWS_AS(make_box(Vec3::Zero(), upright, size), std::invalid_argument);
    }
  }
  CHECK_THROWS_WITH(make_box(Vec3::Zero(), upright, Vec3(1.0, -2.0, 1.0)),
                    Contains("size.y") && Contains("-2"));
}
