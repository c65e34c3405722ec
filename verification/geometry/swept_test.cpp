/// \file
/// \brief First contact of moving boxes against closed forms and fine sampling in time.
#include "tumble/geometry/swept.hpp"

#include "geometry/boxes.hpp"
#include "support/test.hpp"

namespace {

constexpr double kEighthTurn = 0.78539816339744830962;  // [rad] 45 degrees

// [-] Ten rounding errors of numbers of order 10, for fractions of a motion.
constexpr double kRounding = 1e-14;

Box moved(Box box, const Vec3& by) {
  box.center_w += by;
  return box;
}

// The judge: the separating axis test at one instant.
double gap(const Box& first, const Box& second) {
  return separation(first, second, {.prefer_faces = false, .enough = kInfinity}).distance;
}

}  // namespace

TEST_CASE("A cube pushed against another one meets and leaves it at the closed-form fractions",
          "[exact][swept]") {
  const SweepResult got =
      sweep(cube_at(Vec3::Zero()), Vec3(4.0, 0.0, 0.0), cube_at(Vec3(3.0, 0.5, 0.0)), Vec3::Zero());
  CHECK(got.status == SweepStatus::hit);
  CHECK(got.enter == 0.5);
  CHECK(got.leave == 1.0);
  CHECK(got.normal_w == Vec3::UnitX());
  CHECK(got.axis == 0);
}

TEST_CASE("Two edges that meet crosswise meet at the closed-form fraction", "[exact][swept]") {
  const Box lower = cube_at(Vec3::Zero(), rotation_from_vector(kEighthTurn * Vec3::UnitZ()));
  const Box upper = cube_at(Vec3(0.0, 2.0, 0.0), rotation_from_vector(kEighthTurn * Vec3::UnitX()));
  const SweepResult got = sweep(lower, Vec3::Zero(), upper, Vec3(0.0, -1.0, 0.0));
  CHECK(got.status == SweepStatus::hit);
  CHECK(std::abs(got.enter - (2.0 - std::sqrt(2.0))) < kRounding);
  CHECK((got.normal_w - Vec3::UnitY()).norm() < kRounding);
  CHECK(got.axis == 6 + 3 * 2 + 0);  // the first one's z edge and the second one's x edge
}

TEST_CASE("Boxes that overlap or touch at the start are reported with the axis of least overlap",
          "[unit][swept]") {
  const Box here = cube_at(Vec3::Zero());
  const SweepResult deep =
      sweep(here, Vec3::Zero(), cube_at(Vec3(0.3, 0.9, 0.1)), Vec3(0.0, 0.4, 0.0));
  CHECK(deep.status == SweepStatus::overlapping_at_start);
  CHECK(deep.enter == 0.0);
  CHECK(std::abs(deep.leave - 0.25) < kRounding);
  CHECK(deep.normal_w == Vec3::UnitY());
  CHECK(deep.axis == 1);

  const SweepResult touching =
      sweep(here, Vec3::Zero(), cube_at(Vec3(0.0, 1.0, 0.0)), Vec3::Zero());
  CHECK(touching.status == SweepStatus::overlapping_at_start);
  CHECK(touching.leave == kInfinity);
  CHECK(touching.normal_w == Vec3::UnitY());

  const SweepResult same_place = sweep(here, Vec3::UnitX(), here, Vec3::Zero());
  CHECK(same_place.status == SweepStatus::overlapping_at_start);
  CHECK(same_place.leave == 1.0);
}

TEST_CASE("The sweep agrees with fine sampling of the separation", "[unit][swept]") {
  Random random(21);
  constexpr int kSamples = 200;
  int hits = 0, overlaps_before = 0, apart_at_contact = 0, wrong_leave = 0, wrong_start = 0;
  double worst_enter = 0.0, worst_leave = 0.0;
  for (int trial = 0; trial < 3000; ++trial) {
    const Box first = random_box(random, 1.0, 1.2, 0.2), second = random_box(random, 1.0, 1.2, 0.2);
    const Vec3 u1 = random.in_cube(3.0), u2 = random.in_cube(3.0);
    const SweepResult got = sweep(first, u1, second, u2);
    const auto gap_at = [&](double t) { return gap(moved(first, t * u1), moved(second, t * u2)); };
    if ((gap_at(0.0) <= 0.0) != (got.status == SweepStatus::overlapping_at_start)) ++wrong_start;
    if (got.status == SweepStatus::overlapping_at_start) {
      worst_leave = std::max(worst_leave, std::abs(gap_at(got.leave)));
      continue;
    }
    for (int k = 0; k < kSamples; ++k)
      if (gap_at(got.enter * k / kSamples) <= 0.0) ++overlaps_before;
    if (got.status == SweepStatus::no_hit) continue;
    ++hits;
    worst_enter = std::max(worst_enter, std::abs(gap_at(got.enter)));
    worst_leave = std::max(worst_leave, std::abs(gap_at(got.leave)));
    if (gap_at(0.5 * (got.enter + got.leave)) > 0.0) ++apart_at_contact;
    if (got.leave < got.enter) ++wrong_leave;
  }
  CHECK(hits > 300);
  CHECK(overlaps_before == 0);
  CHECK(apart_at_contact == 0);
  CHECK(wrong_leave == 0);
  CHECK(wrong_start == 0);
  // [m] Rounding of coordinates of order 3; a part of 1e-8 may come from almost parallel edges.
  CHECK(worst_enter < 1e-13);  // measured 9.0e-16 m
  CHECK(worst_leave < 1e-13);  // measured 2.5e-15 m
}

TEST_CASE("The sweep refuses a displacement that is not finite", "[unit][swept]") {
  const Box box = cube_at(Vec3::Zero());
  CHECK_THROWS_WITH(sweep(box, Vec3(kNan, 0.0, 0.0), box, Vec3::Zero()),
                    Contains("displacement_first_w"));
  CHECK_THROWS_AS(sweep(box, Vec3::Zero(), box, Vec3(0.0, kInfinity, 0.0)), std::invalid_argument);
}

TEST_CASE("The safe time is the first root of the bound, for every sign of its terms",
          "[exact][swept]") {
  CHECK(safe_time(6.0, {2.0, 0.0}) == 3.0);
  CHECK(safe_time(6.0, {1.0, 1.0}) == 3.0 - (4.0 - std::sqrt(13.0)));  // -1 + √13
  CHECK(safe_time(2.0, {0.0, 1.0}) == 2.0);
  CHECK(safe_time(1.5, {2.0, -1.0}) == 1.0);        // the earlier of the roots 1 and 3
  CHECK(safe_time(3.0, {2.0, -1.0}) == kInfinity);  // turns back at 2
  CHECK(safe_time(1.5, {-1.0, 1.0}) == 3.0);        // goes away first
  CHECK(safe_time(0.0, {-1.0, 1.0}) == 2.0);        // and comes back to where it was
  CHECK(safe_time(1.0, {-1.0, 0.0}) == kInfinity);
  CHECK(safe_time(1.0, {-1.0, -1.0}) == kInfinity);
  CHECK(safe_time(1.0, {0.0, 0.0}) == kInfinity);
  CHECK(safe_time(0.0, {1.0, 1.0}) == 0.0);
  CHECK(safe_time(0.0, {0.0, 1.0}) == 0.0);
}
