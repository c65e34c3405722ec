/// \file
/// \brief Features of motion from successive places of a body.
#include "tumble/filtering/motion_history.hpp"

#include "support/test.hpp"

namespace {

// By brute force: all choices of reversal points, for a swing along x.
double swing_by_trying(const std::vector<double>& u, std::size_t from, int parts, double sense) {
  if (parts == 0) return kInfinity;
  double best = 0.0;
  for (std::size_t to = from + 1; to < u.size(); ++to)
    best = std::max(best,
                    std::min(sense * (u[to] - u[from]), swing_by_trying(u, to, parts - 1, -sense)));
  return best;
}

BodyState at(double x) {
  BodyState state;
  state.position_w.x() = x;
  return state;
}

std::vector<Placement> places_of(const std::vector<double>& u) {
  std::vector<Placement> places;
  for (const double x : u) places.push_back(placement_of(box_properties(Vec3::Ones(), 1.0), at(x)));
  return places;
}

}  // namespace

TEST_CASE("The distance of two placements is the root mean square displacement of the corners",
          "[exact][filtering]") {
  Random chance(3);
  for (int k = 0; k < 20; ++k) {
    const Vec3 size(chance.uniform(0.1, 2.0), chance.uniform(0.1, 2.0), chance.uniform(0.1, 2.0));
    const BodyProperties body = box_properties(size, 1.0);
    const auto any = [&] { return Vec3(chance.unit(), chance.unit(), chance.unit()); };
    BodyState a{.orientation_wb = rotation_from_vector(any())};
    BodyState b{.orientation_wb = rotation_from_vector(3.0 * any())};
    a.position_w = any();
    b.position_w = any();
    const auto from = corners_of(box_of(body, a));
    const auto to = corners_of(box_of(body, b));
    double sum = 0.0;
    for (std::size_t c = 0; c < 8; ++c) sum += (to[c] - from[c]).squaredNorm() / 8.0;
    CHECK((placement_of(body, b) - placement_of(body, a)).norm() ==
          near(std::sqrt(sum), 1e-14));  // [m] rounding; measured 5e-16
  }
}

TEST_CASE("The swing is the largest over all choices of reversal points", "[exact][filtering]") {
  Random chance(5);
  for (int k = 0; k < 200; ++k) {
    std::vector<double> u(4 + chance.below(7));
    for (double& x : u) x = chance.uniform(-1.0, 1.0);
    const int reversals = 1 + static_cast<int>(chance.below(4));
    double expected = 0.0;
    for (std::size_t from = 0; from < u.size(); ++from)
      for (const double sense : {1.0, -1.0})
        expected = std::max(expected, swing_by_trying(u, from, reversals + 1, sense));
    CHECK(swing_of(places_of(u), reversals) == near(expected, 1e-14));  // [m] rounding
  }
}

TEST_CASE("Features of simple motions have their exact values", "[exact][filtering]") {
  const double margin = 1e-14;  // [m] rounding of a sum of 30 steps
  std::vector<double> steady;
  std::vector<double> zigzag;
  for (int k = 0; k <= 30; ++k) {
    steady.push_back(0.01 * k);
    zigzag.push_back(k % 2 == 0 ? 0.0 : 0.01);
  }
  const MotionHistory goes = history_of(places_of(steady));
  CHECK(goes.displacement == near(0.3, margin));
  CHECK(goes.path == near(0.3, margin));
  CHECK(goes.drift == near(0.3, margin));
  CHECK(goes.excursion == near(0.3, margin));
  CHECK(swing_of(places_of(steady), 1) == near(0.0, margin));
  const MotionHistory shakes = history_of(places_of(zigzag));
  CHECK(shakes.displacement == near(0.0, margin));
  CHECK(shakes.path == near(0.3, margin));
  CHECK(shakes.drift == near(0.0, margin));  // symmetric about the middle
  CHECK(shakes.excursion == near(0.01, margin));
  CHECK(swing_of(places_of(zigzag), 3) == near(0.01, margin));
}

TEST_CASE("The principal direction is that of all steps together, not of the longest",
          "[exact][filtering]") {
  std::vector<Placement> places;
  for (int k = 0; k <= 20; ++k) {
    BodyState state{.position_w = Vec3(k % 2 == 0 ? 0.0 : 0.01, k < 10 ? 0.0 : 0.012, 0.0)};
    places.push_back(placement_of(box_properties(Vec3::Ones(), 1.0), state));
  }
  // Squares 20, 1.2 and 1.44 of 10 mm: the angle of an ellipse's axis in closed form.
  const double angle = 0.5 * elementary::atan2(2.0 * 1.2, 20.0 - 1.44);
  CHECK(swing_of(places, 3) == near(0.01 * elementary::cos(angle), 1e-12));  // [m] 8 rounds
}

TEST_CASE("Features refuse too few places, too many and no reversal", "[unit][filtering]") {
  CHECK_THROWS_AS(history_of(places_of({0.0})), std::invalid_argument);
  CHECK_THROWS_AS(swing_of(places_of({0.0, 1.0}), 0), std::invalid_argument);
  CHECK_THROWS_AS(swing_of(places_of(std::vector<double>(kMostPlaces + 1)), 1),
                  std::invalid_argument);
  CHECK(swing_of(places_of({0.0, 1.0, 0.0}), 3) == 0.0);
}
