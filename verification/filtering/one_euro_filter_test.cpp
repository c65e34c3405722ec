/// \file
/// \brief The one-euro filter against closed forms (thesis 5.5).
#include "tumble/filtering/one_euro_filter.hpp"

#include "filtering/one_body.hpp"
#include "support/test.hpp"

using namespace one_body;

namespace {

constexpr double kTurnRate = 2.0 * std::numbers::pi;  // [rad] of a period
constexpr double kRounding = 1e-13;                   // [m], [rad] for sums of a few hundred terms

// The filter as an exponential smoothing with a fixed cutoff [Hz].
OneEuroFilter fixed(double cutoff) { return OneEuroFilter({cutoff, 0.0, 1.0}); }

double share(double cutoff, double dt) { return 1.0 / (1.0 + 1.0 / (kTurnRate * cutoff * dt)); }

// [m] lag of the displayed body at the end of a ramp, in the steady state
double lag_of(double speed, const PoseFilter& filter, double interval = kFrameTime) {
  const int frames = 1200;
  const Trajectory run = run_of(
      frames, [=](int n) { return at(speed * interval * n); }, interval);
  return body_in(run, frames - 1).position_w.x() -
         body_in(filtered(run, filter), frames - 1).position_w.x();
}

}  // namespace

TEST_CASE("Without gain a step is taken as exponential smoothing takes it", "[exact][filtering]") {
  for (const double cutoff : {0.5, 1.0, 4.0}) {
    const Trajectory shown =
        filtered(run_of(200, [](int n) { return at(n == 0 ? 0.0 : 1.0); }), fixed(cutoff));
    double left = 1.0;  // (1 - a)^n
    for (int n = 1; n < shown.count(); ++n) {
      left *= 1.0 - share(cutoff, kFrameTime);
      CHECK(body_in(shown, n).position_w.x() == near(1.0 - left, kRounding));
    }
  }
}

TEST_CASE("Without gain a swing is damped by the response of a first-order filter",
          "[exact][filtering]") {
  const double cutoff = 1.0;
  const double a = share(cutoff, kFrameTime);
  for (const double frequency : {0.25, 1.0, 4.0, 15.0}) {
    const double w = kTurnRate * frequency * kFrameTime;
    const auto [sin, cos] = elementary::sincos(w);
    // H = a / (1 - (1 - a) e^{-iw})
    const double real = 1.0 - (1.0 - a) * cos;
    const double imaginary = (1.0 - a) * sin;
    const double size = real * real + imaginary * imaginary;
    const Trajectory shown =
        filtered(run_of(2400, [=](int n) { return at(elementary::cos(w * n)); }), fixed(cutoff));
    for (int n = 1200; n < 2400; ++n) {
      const auto [s, c] = elementary::sincos(w * n);
      // [m] after 20 s the start has no effect; rounding of w n
      CHECK(body_in(shown, n).position_w.x() == near(a * (c * real + s * imaginary) / size, 1e-10));
    }
    // Half of the power at the cutoff, to the accuracy of 60 frames per second.
    if (frequency == cutoff) CHECK(a * a / size == near(0.5, 0.03));
  }
}

TEST_CASE("The lag of the one-euro filter follows from its cutoff and gain", "[exact][filtering]") {
  const OneEuroOptions options;
  double last = kInfinity;
  for (const double speed : {0.001, 0.1, 1.0, 10.0}) {
    const double lag = lag_of(speed, OneEuroFilter(options));
    const double expected = speed / (kTurnRate * (options.cutoff + options.gain * speed));
    CHECK(lag == near(expected, 1e-11));  // [m] at places of up to 200 m
    CHECK(lag / speed < last);            // the faster, the smaller
    last = lag / speed;
  }
  // Its default gain makes that a centimetre at high speed, and never more.
  CHECK(lag_of(100.0, OneEuroFilter()) == near(0.01, 1e-4));
  CHECK(lag_of(100.0, OneEuroFilter()) < 0.01);
  // And it is the same at any frame rate.
  for (const double rate : {24.0, 30.0, 240.0})
    CHECK(lag_of(1.0, OneEuroFilter(), 1.0 / rate) == near(lag_of(1.0, OneEuroFilter()), 1e-10));
}

TEST_CASE("A change of the frame rate enters the one-euro filter by the time between two frames",
          "[exact][filtering]") {
  const std::vector<BodyId> ids = {BodyId{7}};
  Trajectory run;
  double left = 1.0;
  double time = 0.0;
  run.record(Frame{0.0, 0, ids, std::vector<BodyState>{at(0.0)}});
  for (int n = 1; n <= 60; ++n) {
    const double dt = n % 3 == 0 ? 0.05 : 0.01;
    time += dt;
    left *= 1.0 - share(2.0, dt);
    run.record(Frame{time, n, ids, std::vector<BodyState>{at(1.0)}});
  }
  CHECK(body_in(filtered(run, fixed(2.0)), 60).position_w.x() == near(1.0 - left, kRounding));
}

TEST_CASE("The one-euro filter treats a turn about an axis as it treats a move along one",
          "[exact][filtering]") {
  const auto angle = [](int n) { return 0.4 * elementary::sin(0.11 * n) + 0.05 * (n % 3); };
  const Trajectory moved =
      filtered(run_of(300, [&](int n) { return at(angle(n)); }), OneEuroFilter());
  const Trajectory turned =
      filtered(run_of(300, [&](int n) { return turned_by(angle(n)); }), OneEuroFilter());
  double widest = 0.0;
  for (int n = 0; n < 300; ++n) {
    const Vec3 seen = rotation_vector(body_in(turned, n).orientation_wb);
    widest = std::max(widest, std::abs(seen.z() - angle(n)));
    CHECK(seen.z() == near(body_in(moved, n).position_w.x(), 1e-12));
  }
  CHECK(widest > 0.01);  // the filter has an effect
}

TEST_CASE("The poses shown by the one-euro filter do not depend on the axes",
          "[exact][filtering]") {
  const Quat view = rotation_from_vector(Vec3(0.4, -1.1, 0.6));
  const Trajectory run = random_walk(200, 0.02, 0.05, 3);
  const Trajectory seen_from = run_of(200, [&](int n) {
    BodyState state = body_in(run, n);
    state.position_w = view * state.position_w;
    state.orientation_wb = view * state.orientation_wb;
    return state;
  });
  const Trajectory shown = filtered(run, OneEuroFilter());
  const Trajectory other = filtered(seen_from, OneEuroFilter());
  for (int n = 0; n < 200; ++n) {
    CHECK((view * body_in(shown, n).position_w - body_in(other, n).position_w).norm() <= 1e-13);
    CHECK(angle_between(view * body_in(shown, n).orientation_wb,
                        body_in(other, n).orientation_wb) <= 1e-13);
  }
}

TEST_CASE("q and -q are one orientation to the one-euro filter", "[exact][filtering]") {
  const Trajectory run = random_walk(100, 0.0, 0.1, 4);
  const Trajectory flipped = run_of(100, [&](int n) {
    BodyState state = body_in(run, n);
    if (n % 3 == 1) state.orientation_wb.coeffs() *= -1.0;
    return state;
  });
  const Trajectory a = filtered(run, OneEuroFilter());
  const Trajectory b = filtered(flipped, OneEuroFilter());
  for (int n = 0; n < 100; ++n)
    CHECK(angle_between(body_in(a, n).orientation_wb, body_in(b, n).orientation_wb) <= 1e-13);
}

TEST_CASE("The one-euro filter leaves a run at rest unchanged and damps chatter",
          "[exact][filtering]") {
  BodyState still{.position_w = Vec3(0.1, 1e5, -1e-7)};
  still.orientation_wb.coeffs() = Vec3(0.1, -0.7, 0.3).homogeneous().normalized() * (1.0 + 4e-10);
  const Trajectory run = run_of(50, [&](int) { return still; });
  for (int n = 0; n < 50; ++n) CHECK(body_in(filtered(run, OneEuroFilter()), n) == still);
  // Chatter by a millimetre per frame is reduced to a twentieth or less.
  const Trajectory shaken =
      filtered(run_of(600, [](int n) { return at(n % 2 == 0 ? 0.0 : 0.001); }), OneEuroFilter());
  CHECK(std::abs(body_in(shaken, 599).position_w.x() - body_in(shaken, 598).position_w.x()) < 6e-5);
  CHECK(body_in(shaken, 599).position_w.x() != body_in(shaken, 598).position_w.x());
}

TEST_CASE("A one-euro filter refuses parameters out of range", "[unit][filtering]") {
  for (const double bad : {-1.0, kNan, kInfinity}) {
    CHECK_THROWS_AS(OneEuroFilter({bad, 1.0, 1.0}), std::invalid_argument);
    CHECK_THROWS_AS(OneEuroFilter({1.0, bad, 1.0}), std::invalid_argument);
    CHECK_THROWS_AS(OneEuroFilter({1.0, 1.0, bad}), std::invalid_argument);
  }
  CHECK_THROWS_AS(OneEuroFilter({0.0, 1.0, 1.0}), std::invalid_argument);
  CHECK_THROWS_AS(OneEuroFilter({1.0, 1.0, 0.0}), std::invalid_argument);
  CHECK_NOTHROW(OneEuroFilter({1.0, 0.0, 1.0}));
}
