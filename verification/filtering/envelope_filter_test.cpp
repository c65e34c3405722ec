/// \file
/// \brief The exact behaviour of the thesis's envelope filter (thesis 5.5).
#include "tumble/filtering/envelope_filter.hpp"

#include "filtering/one_body.hpp"
#include "support/test.hpp"

using namespace one_body;

namespace {

constexpr double kRadius = 0.01;
constexpr double kAngle = std::numbers::pi / 180.0;

// [m] of the centre, [rad] of the turn
double way(const BodyState& a, const BodyState& b) { return (a.position_w - b.position_w).norm(); }
double turn(const BodyState& a, const BodyState& b) {
  return angle_between(a.orientation_wb, b.orientation_wb);
}

Trajectory shown_of(const Trajectory& run) { return filtered(run, EnvelopeFilter()); }

// A swing of an amplitude [m] and a frequency [1/frame], 60 frames.
Trajectory swing(double amplitude, double frequency) {
  return run_of(60, [=](int n) {
    return at(amplitude * elementary::cos(2.0 * std::numbers::pi * frequency * n));
  });
}

}  // namespace

TEST_CASE("A swing as wide as the envelope is shown at rest, and a wider one twice in a period",
          "[exact][filtering]") {
  // To and fro in every frame by 5 mm: 10 mm from end to end, not more than the radius.
  CHECK(changes_in(shown_of(swing(0.005, 0.5))) == 0);
  // With 6 mm and 0.15 periods per frame, 60 frames have 9 periods; the shown position changes sides
  // twice in each, except for the first frame, which is shown as computed.
  CHECK(changes_in(shown_of(swing(0.006, 0.15))) == 17);
  CHECK(changes_in(shown_of(swing(0.006, 0.5))) == 59);
}

TEST_CASE("A ramp of 3 mm a frame under an envelope of 10 mm pops by 12 mm in every fourth frame",
          "[exact][filtering]") {
  const Trajectory run = run_of(81, [](int n) { return at(0.003 * n); });
  const Trajectory shown = shown_of(run);
  CHECK(changes_in(shown) == 20);
  for (int n = 0; n < shown.count(); ++n)
    CHECK(body_in(shown, n).position_w.x() == body_in(run, n - n % 4).position_w.x());
  // [m] rounding of 81 multiples of 3 mm
  CHECK(body_in(shown, 40).position_w.x() - body_in(shown, 39).position_w.x() ==
        near(0.012, 1e-15));
}

TEST_CASE("A body is shown at rest if and only if it stays within the envelope of its first pose",
          "[exact][filtering]") {
  int at_rest = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    const Trajectory run = random_walk(20, 0.005, 0.3 * kAngle, seed);
    bool within = true;
    for (int n = 1; n < run.count(); ++n)
      within = within && way(body_in(run, n), body_in(run, 0)) <= kRadius &&
               turn(body_in(run, n), body_in(run, 0)) <= kAngle;
    CHECK((changes_in(shown_of(run)) == 0) == within);
    at_rest += within ? 1 : 0;
  }
  CHECK(at_rest > 20);
  CHECK(at_rest < 180);
}

TEST_CASE("Position and orientation leave the envelope together, whichever of them does",
          "[exact][filtering]") {
  const auto both = [](double x, double angle) {
    BodyState state = turned_by(angle);
    state.position_w.x() = x;
    return state;
  };
  // Inside; outside by position, with a small rotation; inside; outside by rotation, with a small move.
  const std::vector<BodyState> poses = {both(0.0, 0.0), both(0.009, 0.9 * kAngle),
                                        both(0.011, 0.5 * kAngle), both(0.012, 0.1 * kAngle),
                                        both(0.013, -0.6 * kAngle)};
  const std::vector<std::size_t> expected = {0, 0, 2, 2, 4};
  const Trajectory shown = shown_of(run_of(5, [&](int n) { return poses[idx(n)]; }));
  for (std::size_t n = 0; n < poses.size(); ++n)
    CHECK(same_pose(body_in(shown, static_cast<int>(n)), poses[expected[n]]));
}

TEST_CASE(
    "The angle of the envelope is that of the shortest turn, and q and -q are one orientation",
    "[exact][filtering]") {
  // A rotation by 2 degrees about an axis that is oblique to the body.
  const Vec3 axis = Vec3(1.0, 2.0, -2.0) / 3.0;
  const auto turn_run = [&](double angle, bool minus) {
    return run_of(2, [=](int n) {
      BodyState state{.orientation_wb = rotation_from_vector(Vec3(n * angle * axis))};
      if (minus && n == 1) state.orientation_wb.coeffs() *= -1.0;
      return state;
    });
  };
  CHECK(changes_in(shown_of(turn_run(0.99 * kAngle, false))) == 0);
  CHECK(changes_in(shown_of(turn_run(0.99 * kAngle, true))) == 0);
  CHECK(changes_in(shown_of(turn_run(1.01 * kAngle, false))) == 1);
  CHECK(changes_in(shown_of(turn_run(1.01 * kAngle, true))) == 1);
}

TEST_CASE(
    "Poses shown by an envelope are within it, are computed poses, and are exact for bodies that "
    "leave it in every frame",
    "[exact][filtering]") {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    const Trajectory run = random_walk(200, 0.008, 0.5 * kAngle, seed);
    const Trajectory shown = shown_of(run);
    REQUIRE(shown.count() == run.count());
    bool within = true;
    bool computed = true;
    for (int n = 0; n < run.count(); ++n) {
      const BodyState& seen = body_in(shown, n);
      within =
          within && way(seen, body_in(run, n)) <= kRadius && turn(seen, body_in(run, n)) <= kAngle;
      computed = computed && (same_pose(seen, body_in(run, n)) ||
                              (n > 0 && same_pose(seen, body_in(shown, n - 1))));
    }
    CHECK(within);
    CHECK(computed);
  }
  const Trajectory fast = run_of(50, [](int n) { return at(0.0101 * n); });
  const Trajectory turning = run_of(50, [](int n) { return turned_by(1.01 * kAngle * n); });
  CHECK(changes_in(shown_of(fast)) == 49);
  CHECK(changes_in(shown_of(turning)) == 49);
  CHECK(same_pose(body_in(shown_of(turning), 33), body_in(turning, 33)));
}

TEST_CASE("A body that comes back after frames without it is a new one to an envelope",
          "[unit][filtering]") {
  const std::vector<BodyId> two = {BodyId{1}, BodyId{4}};
  const std::vector<BodyId> first = {BodyId{1}};
  Trajectory run;
  run.record(Frame{0.0, 0, two, std::vector<BodyState>{at(0.0), at(1.0)}});
  run.record(Frame{0.1, 1, two, std::vector<BodyState>{at(0.001), at(1.001)}});
  run.record(Frame{0.2, 2, first, std::vector<BodyState>{at(0.002)}});
  run.record(Frame{0.3, 3, two, std::vector<BodyState>{at(0.003), at(1.003)}});
  run.record(Frame{0.4, 4, two, std::vector<BodyState>{at(0.004), at(1.004)}});
  const Trajectory shown = shown_of(run);
  REQUIRE(shown.count() == 5);
  CHECK(shown.frame(1).states[1].position_w.x() == 1.0);
  CHECK(shown.frame(2).ids.size() == 1);
  CHECK(shown.frame(3).states[1].position_w.x() == 1.003);  // not 1
  CHECK(shown.frame(4).states[1].position_w.x() == 1.003);
  CHECK(shown.frame(4).states[0].position_w.x() == 0.0);  // it was present all the time
}

TEST_CASE("An envelope without a radius or an angle above 0 is refused", "[unit][filtering]") {
  for (const double bad : {0.0, -0.01, kNan, kInfinity}) {
    CHECK_THROWS_AS(EnvelopeFilter({bad, kAngle}), std::invalid_argument);
    CHECK_THROWS_AS(EnvelopeFilter({kRadius, bad}), std::invalid_argument);
    CHECK_THROWS_AS(SoftEnvelopeFilter({bad, kAngle}), std::invalid_argument);
    CHECK_THROWS_AS(SoftEnvelopeFilter({kRadius, bad}), std::invalid_argument);
  }
}
