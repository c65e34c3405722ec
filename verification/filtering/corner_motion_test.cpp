/// \file
/// \brief Measures of unwanted motion: excursion, acceleration, squirm and pops (thesis 5.5).
#include "tumble/filtering/corner_motion.hpp"

#include "filtering/one_body.hpp"
#include "support/test.hpp"

using namespace one_body;

namespace {

BodyProperties brick() { return BodyProperties{.size = Vec3(1.0, 0.4, 2.0)}; }

std::vector<Corners> path_of(const Trajectory& run) { return corner_path(run, BodyId{7}, brick()); }

// A path of a body that moves along x.
std::vector<Corners> along_x(int count, const std::function<double(int)>& x) {
  return path_of(run_of(count, [&](int n) { return at(x(n)); }));
}

// By brute force: every pair of frames, every corner.
double excursion_of_all(const std::vector<Corners>& path) {
  double largest = 0.0;
  for (const Corners& a : path)
    for (const Corners& b : path)
      for (std::size_t c = 0; c < 8; ++c) largest = std::max(largest, (a[c] - b[c]).norm());
  return largest;
}

}  // namespace

TEST_CASE("A corner path has the corners of the box in the frames that have the body",
          "[unit][filtering]") {
  const Trajectory walk = random_walk(5, 0.3, 0.5, 1);
  const std::vector<Corners> path = path_of(walk);
  REQUIRE(path.size() == 5);
  for (std::size_t n = 0; n < path.size(); ++n) {
    const BodyState& state = body_in(walk, static_cast<int>(n));
    for (std::size_t c = 0; c < 8; ++c) {
      const Vec3 local = state.orientation_wb.conjugate() * (path[n][c] - state.position_w);
      CHECK((local.cwiseAbs() - 0.5 * brick().size).norm() <= 1e-14);  // [m] rounding
      CHECK(path[n][c] == corners_of(box_of(brick(), state))[c]);
    }
  }
  CHECK(corner_path(walk, BodyId{8}, brick()).empty());
}

TEST_CASE("The largest excursion is that of all pairs of frames", "[exact][filtering]") {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const std::vector<Corners> path = path_of(random_walk(31, 0.01, 0.02, seed));
    const double all = excursion_of_all(path);
    CHECK(largest_excursion(path) == all);
    CHECK(largest_excursion(path, 0.5 * all) == all);
    CHECK(largest_excursion(path, 2.0 * all) == 2.0 * all);  // smaller values are not computed
  }
  CHECK(largest_excursion({}) == 0.0);
  CHECK(largest_excursion(along_x(1, [](int) { return 0.0; })) == 0.0);
  // To and fro by 3 mm, with reversals at the ends only.
  CHECK(largest_excursion(along_x(50, [](int n) { return n % 2 == 0 ? 0.0 : 0.003; })) ==
        near(0.003, 1e-15));
}

TEST_CASE("The second difference of a free fall is g dt² and that of a steady motion 0",
          "[exact][filtering]") {
  const double g = 9.81;
  const double dt = kFrameTime;
  const auto fall = along_x(40, [=](int n) { return 2.0 * n * dt - 0.5 * g * n * n * dt * dt; });
  CHECK(rms_second_difference(fall) == near(g * dt * dt, 1e-14));  // [m] rounding
  CHECK(rms_second_difference(along_x(40, [](int n) { return 0.01 * n; })) <= 1e-15);
  // To and fro by a: each is 2 a away from both neighbours, 2 · 2 a in all.
  const auto shaking = along_x(41, [](int n) { return n % 2 == 0 ? -0.001 : 0.001; });
  CHECK(rms_second_difference(shaking) == near(0.004, 1e-15));
  CHECK(rms_second_difference(along_x(2, [](int n) { return 1.0 * n; })) == 0.0);
  CHECK(rms_second_difference({}) == 0.0);
}

TEST_CASE("The second difference is a mean over frames and over corners", "[exact][filtering]") {
  // One jump in five frames, by d: second differences d, -d, 0.
  const double d = 0.01;
  const auto jump = along_x(5, [=](int n) { return n < 2 ? 0.0 : d; });
  CHECK(rms_second_difference(jump) == near(d * std::sqrt(2.0 / 3.0), 1e-15));
  // A turn about a fixed axis at a constant rate: r (2 - 2 cos w) for each corner at distance r.
  const double w = 0.01;
  const auto turning = path_of(run_of(30, [=](int n) { return turned_by(w * n); }));
  const double r = 0.5 * std::sqrt(1.0 + 0.4 * 0.4);
  CHECK(rms_second_difference(turning) == near(r * (2.0 - 2.0 * elementary::cos(w)), 1e-14));
}

TEST_CASE("Squirm is the speed of a drift and ignores oscillation frame by frame",
          "[exact][filtering]") {
  const auto drift = [](int n) { return 0.004 * n * kFrameTime; };
  CHECK(squirm(along_x(60, drift), kFrameTime) == near(0.004, 1e-12));
  const auto shaking = [](int n) { return n % 2 == 0 ? -0.002 : 0.002; };
  // The line fit through eleven alternating positions is level: Σ j (-1)^j over j and -j is 0.
  CHECK(squirm(along_x(60, shaking), kFrameTime) <= 1e-14);
  CHECK(squirm(along_x(60, [=](int n) { return drift(n) + shaking(n); }), kFrameTime) ==
        near(0.004, 1e-12));
  CHECK(squirm(along_x(kSquirmFrames, drift), kFrameTime) == near(0.004, 1e-12));
  CHECK(squirm(along_x(kSquirmFrames - 1, drift), kFrameTime) == 0.0);
  CHECK(squirm({}, kFrameTime) == 0.0);
  CHECK_THROWS_AS(squirm(along_x(60, drift), 0.0), std::invalid_argument);
  CHECK_THROWS_AS(squirm(along_x(60, drift), -1.0), std::invalid_argument);
}

TEST_CASE("Squirm of a slow swing is the root mean square of its speed", "[exact][filtering]") {
  const double amplitude = 0.01;
  for (const double frequency : {0.2, 0.5, 1.0}) {
    const double w = 2.0 * std::numbers::pi * frequency * kFrameTime;
    double factor = 0.0;  // ratio of the line fit's slope to the slope of a swing
    for (int j = 1; j <= 5; ++j) factor += 2.0 * j * elementary::sin(w * j) / (110.0 * w);
    const int periods = 4;
    const int frames = static_cast<int>(periods / (frequency * kFrameTime) + 0.5) + 2 * 5;
    const auto path = along_x(frames, [=](int n) { return amplitude * elementary::sin(w * n); });
    const double speed = std::sqrt(2.0) * std::numbers::pi * frequency * amplitude;
    // [m/s] sums over whole periods of equal spacing are exact
    CHECK(squirm(path, kFrameTime) == near(speed * factor, 1e-12));
    CHECK(factor > 0.9);
    if (frequency <= 0.5) CHECK(factor > 0.97);
  }
}

TEST_CASE("Squirm is that of the corner that moves most", "[exact][filtering]") {
  // A slow rotation about z through one edge, then through the opposite one: the farthest corner is a
  // diagonal away, and has another index each time.
  const double rate = 0.01;  // [rad/s]
  for (const double side : {-1.0, 1.0}) {
    const auto path = path_of(run_of(60, [=](int n) {
      BodyState state = turned_by(rate * n * kFrameTime);
      state.position_w = state.orientation_wb * Vec3(side * 0.5, side * 0.2, 0.0);
      return state;
    }));
    const double diagonal = std::sqrt(1.0 + 0.4 * 0.4);
    // [m/s] a rotation by 0.01 rad in a second is straight to a millionth
    CHECK(squirm(path, kFrameTime) == near(rate * diagonal, 1e-7));
  }
}

TEST_CASE("Pops are shown steps that are longer than computed ones and than a given length",
          "[exact][filtering]") {
  const auto path = [](const std::vector<double>& x) {
    return along_x(static_cast<int>(x.size()), [&](int n) { return x[idx(n)]; });
  };
  const auto computed = path({0.0, 0.004, 0.008, 0.012, 0.016, 0.046, 0.046});
  //                                 waits, waits,  pops,  creeps, as fast, too short
  const auto shown = path({0.0, 0.0, 0.0, 0.012, 0.016, 0.046, 0.049});
  const Pops found = pops(shown, computed, 0.01);
  CHECK(found.count == 1);
  CHECK(found.largest == near(0.012, 1e-15));
  CHECK(pops(shown, computed, 0.0029).count == 2);
  CHECK(pops(shown, computed, 0.0121).count == 0);
  CHECK(pops(shown, computed, 0.0121).largest == 0.0);
  CHECK(pops(computed, computed, 1e-6).count == 0);
  CHECK(pops({}, {}, 0.01).count == 0);
  CHECK_THROWS_AS(pops(shown, std::span(computed).first(6), 0.01), std::invalid_argument);
  CHECK_THROWS_AS(pops(shown, computed, 0.0), std::invalid_argument);
}

TEST_CASE("The displacement between two poses is that of the corner that moves farthest",
          "[exact][filtering]") {
  const Corners from = corners_of(box_of(brick(), turned_by(0.0)));
  const Corners to = corners_of(box_of(brick(), turned_by(0.1)));
  const double r = 0.5 * std::sqrt(1.0 + 0.4 * 0.4);
  CHECK(largest_displacement(from, to) == near(2.0 * r * elementary::sin(0.05), 1e-15));
  CHECK(largest_displacement(from, from) == 0.0);
}
