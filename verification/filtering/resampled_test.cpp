/// \file
/// \brief Resampled runs: identical bits, interpolation, refusals.
#include "tumble/filtering/resampled.hpp"

#include "tumble/base/random.hpp"
#include "tumble/filtering/box_filter.hpp"
#include "tumble/filtering/tolerances.hpp"
#include "tumble/math/rotation.hpp"

#include "support/catch.hpp"

namespace {

using namespace tumble;

constexpr double kInterval = 1.0 / 60.0;  // [s]
const Vec3 kSpin(0.3, -2.0, 1.1);         // [rad/s]

// A body in uniform motion; quaternions q and -q at random.
BodyState moving(double time, bool other_sign = false) {
  BodyState state;
  state.position_w = Vec3(1.0, 2.0, 3.0) + time * Vec3(0.5, -1.5, 0.25);
  state.orientation_wb = rotation_from_vector(time * kSpin);
  state.linear_momentum_w = Vec3(1.0, 0.0, 0.0) + time * Vec3(0.0, -9.81, 0.0);
  state.angular_momentum_w = Vec3(0.0, time, 0.0);
  if (other_sign) state.orientation_wb.coeffs() *= -1.0;
  return state;
}

void record(double time, std::int64_t step, std::vector<BodyId> ids, Trajectory& run) {
  std::vector<BodyState> states;
  for (const BodyId id : ids) {
    states.push_back(moving(time, step % 2 == 1));
    states.back().position_w.z() += number_of(id);
  }
  run.record(Frame{time, step, ids, states});
}

// Intervals from a fifth of the nominal one to twice as much.
Trajectory uneven(std::uint64_t seed, double duration) {
  Random chance(seed);
  Trajectory run;
  double time = 0.25;
  for (int k = 0; time <= 0.25 + duration; ++k) {
    record(time, k, {BodyId{3}}, run);
    time += kInterval * chance.uniform(0.2, 2.0);
  }
  return run;
}

}  // namespace

TEST_CASE("A run that is at equal times already is resampled to itself, bit by bit",
          "[unit][filtering]") {
  Trajectory run;
  double time = 0.0;
  for (int k = 0; k < 5000; ++k, time += kInterval) record(time, k, {BodyId{1}, BodyId{2}}, run);
  const Trajectory same = resampled(run, kInterval);
  REQUIRE(same.count() == run.count());
  int differing = 0;
  for (int k = 0; k < run.count(); ++k) {
    const Frame f = run.frame(k);
    const Frame g = same.frame(k);
    if (f.time != g.time || f.step != g.step || !(f.states[1] == g.states[1])) ++differing;
  }
  CHECK(differing == 0);
  const Trajectory third = resampled(run, 3.0 * kInterval);
  REQUIRE(third.count() == 1 + 4999 / 3);
  CHECK(third.frame(400).states[0] == run.frame(1200).states[0]);
}

TEST_CASE("A uniform motion is on its straight line and its turn at every resampled time",
          "[exact][filtering]") {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const Trajectory run = uneven(seed, 3.0);
    const Trajectory even = resampled(run, kInterval);
    const double end = run.frame(run.count() - 1).time;
    REQUIRE(even.count() == 1 + static_cast<int>(std::floor((end - 0.25) / kInterval)));
    double worst_place = 0.0;     // [m]
    double worst_angle = 0.0;     // [rad]
    double worst_momentum = 0.0;  // [kg m/s]
    for (int k = 0; k < even.count(); ++k) {
      const Frame frame = even.frame(k);
      CHECK(frame.time == near(0.25 + k * kInterval).margin(1e-12));
      BodyState exact = moving(frame.time);
      exact.position_w.z() += 3.0;
      const BodyState& state = frame.states[0];
      worst_place = std::max(worst_place, (state.position_w - exact.position_w).norm());
      worst_angle =
          std::max(worst_angle, angle_between(state.orientation_wb, exact.orientation_wb));
      worst_momentum = std::max(worst_momentum,
                                (state.linear_momentum_w - exact.linear_momentum_w).norm() +
                                    (state.angular_momentum_w - exact.angular_momentum_w).norm());
      CHECK(std::abs(state.orientation_wb.norm() - 1.0) < 1e-15);
    }
    CHECK(worst_place < 1e-14);     // measured 1.8e-15: a few roundings of 5 m
    CHECK(worst_angle < 1e-14);     // measured 9e-16
    CHECK(worst_momentum < 1e-13);  // measured 1.4e-14: a few roundings of 30 kg m/s
  }
}

TEST_CASE("Between two frames a body turns the shorter way, whatever the signs of its quaternions",
          "[exact][filtering]") {
  for (const bool sign : {false, true}) {
    Trajectory run;
    const std::array<BodyId, 1> ids = {BodyId{0}};
    std::array<BodyState, 1> states;
    run.record(Frame{0.0, 0, ids, states});
    states[0].orientation_wb = rotation_from_vector(Vec3(0.0, 0.0, 1.5));
    if (sign) states[0].orientation_wb.coeffs() *= -1.0;
    run.record(Frame{3.0, 3, ids, states});
    const Trajectory even = resampled(run, 1.0);
    REQUIRE(even.count() == 4);
    const Quat third = rotation_from_vector(Vec3(0.0, 0.0, 0.5));
    CHECK(angle_between(even.frame(1).states[0].orientation_wb, third) < 1e-15);  // measured 0
    CHECK(even.frame(3).states[0].orientation_wb.coeffs() == states[0].orientation_wb.coeffs());
  }
}

TEST_CASE("A resampled body is there where both frames around the time have it, or the one at it",
          "[unit][filtering]") {
  Trajectory run;
  record(0.0, 0, {BodyId{1}, BodyId{4}}, run);
  record(0.5, 1, {BodyId{1}, BodyId{2}, BodyId{4}}, run);
  record(1.0, 2, {BodyId{2}, BodyId{4}, BodyId{9}}, run);
  record(1.5, 3, {BodyId{4}, BodyId{9}}, run);
  const Trajectory even = resampled(run, 0.25);
  REQUIRE(even.count() == 7);
  const std::vector<std::vector<std::uint32_t>> expected = {{1, 4},    {1, 4}, {1, 2, 4}, {2, 4},
                                                            {2, 4, 9}, {4, 9}, {4, 9}};
  for (int k = 0; k < even.count(); ++k) {
    INFO("frame " << k);
    std::vector<std::uint32_t> ids;
    for (const BodyId id : even.frame(k).ids) ids.push_back(number_of(id));
    CHECK(ids == expected[static_cast<std::size_t>(k)]);
    for (std::size_t b = 0; b < ids.size(); ++b)
      CHECK(even.frame(k).states[b].position_w.z() ==
            near(3.0 + 0.25 * even.frame(k).time + ids[b]).margin(1e-14));
  }
  CHECK(even.frame(3).step == 1);
}

TEST_CASE("After resampling a box filter takes a run that it refuses as it is",
          "[unit][filtering]") {
  const Trajectory run = uneven(2, 1.0);
  CHECK_THROWS_WITH(filtered(run, BoxFilter(5)), Catch::Matchers::Contains("resampled()"));
  const Trajectory even = resampled(run, kInterval);
  CHECK(filtered(even, BoxFilter(5)).count() == even.count());

  // Frames as far off as tolerated are used as they are, and the filter accepts them.
  Trajectory off;
  const double far = 0.99 * tolerance::on_the_grid * kInterval;
  for (int k = 0; k < 20; ++k)
    record(k * kInterval + (k == 0 ? 0.0 : k % 2 == 0 ? far : -far), k, {BodyId{0}}, off);
  const Trajectory taken = resampled(off, kInterval);
  REQUIRE(taken.count() == 20);
  for (int k = 0; k < 20; ++k) CHECK(taken.frame(k).time == off.frame(k).time);
  CHECK(filtered(taken, BoxFilter(5)).count() == 20);
}

TEST_CASE(
    "Resampling refuses bad intervals, times that do not ascend and states that are no numbers",
    "[unit][filtering]") {
  const Trajectory run = uneven(1, 0.5);
  for (const double bad : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()})
    CHECK_THROWS_WITH(resampled(run, bad), Catch::Matchers::Contains("interval of resampled()"));
  CHECK_THROWS_WITH(resampled(run, 1e-9), Catch::Matchers::Contains("fewer than 1e8 frames"));
  CHECK_THROWS_WITH(resampled(run, 1e-320), Catch::Matchers::Contains("fewer than 1e8 frames"));

  CHECK(resampled(Trajectory{}, 1.0).count() == 0);
  CHECK(resampled(run, 10.0).count() == 1);  // the start

  Trajectory back;
  record(0.0, 0, {BodyId{0}}, back);
  record(1.0, 1, {BodyId{0}}, back);
  record(1.0, 2, {BodyId{0}}, back);
  CHECK_THROWS_WITH(resampled(back, 0.1), Catch::Matchers::Contains("frame 2 at 1 s"));

  Trajectory broken;
  record(0.0, 0, {BodyId{0}}, broken);
  const std::array<BodyId, 1> ids = {BodyId{0}};
  std::array<BodyState, 1> states;
  states[0].position_w.x() = std::nan("");
  broken.record(Frame{1.0, 1, ids, states});
  CHECK_THROWS_WITH(resampled(broken, 0.3),
                    Catch::Matchers::Contains("frame 1 at 1 s, body with id 0"));
  CHECK_THROWS_AS(resampled(broken, 1.0), std::invalid_argument);  // a frame at one of the times
  states[0] = BodyState{};
  states[0].linear_momentum_w.z() = std::numeric_limits<double>::infinity();
  Trajectory endless;
  record(0.0, 0, {BodyId{0}}, endless);
  endless.record(Frame{1.0, 1, ids, states});
  CHECK_THROWS_AS(resampled(endless, 0.3), std::invalid_argument);
  states[0] = BodyState{};
  states[0].orientation_wb.coeffs().setZero();
  Trajectory pointless;
  record(0.0, 0, {BodyId{0}}, pointless);
  pointless.record(Frame{1.0, 1, ids, states});
  CHECK_THROWS_AS(resampled(pointless, 0.3), std::invalid_argument);
}
