/// \file
/// \brief The documented properties of the envelope without pops (thesis 5.5).
#include "tumble/filtering/corner_motion.hpp"
#include "tumble/filtering/envelope_filter.hpp"

#include "filtering/one_body.hpp"
#include "support/test.hpp"

using namespace one_body;

namespace {

constexpr Envelope kEnvelope;

// [-] Rounding of a distance in envelopes: positions of a metre carry 1e-16 m, an envelope is 1e-2 m.
constexpr double kRounding = 1e-12;

// [envelopes] Distance of two poses.
double apart(const BodyState& a, const BodyState& b) {
  return std::max((a.position_w - b.position_w).norm() / kEnvelope.radius,
                  angle_between(a.orientation_wb, b.orientation_wb) / kEnvelope.angle);
}

Trajectory shown_of(const Trajectory& run) { return filtered(run, SoftEnvelopeFilter()); }

// From side to side in every frame, by this many envelopes: a displacement along x and a rotation about it.
Trajectory shaking(double envelopes) {
  return run_of(100, [=](int n) {
    const double side = n % 2 == 0 ? 0.0 : envelopes;
    return BodyState{
        .position_w = Vec3(0.7 * side * kEnvelope.radius, 0.0, 0.0),
        .orientation_wb = rotation_from_vector(Vec3(side * kEnvelope.angle, 0.0, 0.0))};
  });
}

int last_change(const Trajectory& shown) {
  int last = 0;
  for (int n = 1; n < shown.count(); ++n)
    if (!same_pose(body_in(shown, n), body_in(shown, n - 1))) last = n;
  return last;
}

}  // namespace

TEST_CASE("A soft envelope shows a body within the envelope that its speed leaves",
          "[exact][filtering]") {
  for (const double largest : {0.2, 0.6, 1.2, 3.0}) {
    double worst = 0.0;
    for (std::uint64_t seed = 1; seed <= 30; ++seed) {
      const Trajectory run =
          random_walk(200, largest * kEnvelope.radius, 0.8 * largest * kEnvelope.angle, seed);
      const Trajectory shown = shown_of(run);
      for (int n = 1; n < run.count(); ++n) {
        const double left = std::max(0.0, 1.0 - apart(body_in(run, n), body_in(run, n - 1)));
        worst = std::max(worst, apart(body_in(run, n), body_in(shown, n)) - left);
      }
    }
    CHECK(worst <= kRounding);
  }
}

TEST_CASE("A step shown by a soft envelope is at most twice the computed one",
          "[exact][filtering]") {
  double largest_ratio = 0.0;
  for (const double largest : {0.2, 0.6, 1.2, 3.0})
    for (std::uint64_t seed = 1; seed <= 30; ++seed) {
      const Trajectory run =
          random_walk(200, largest * kEnvelope.radius, 1.2 * largest * kEnvelope.angle, seed);
      const Trajectory shown = shown_of(run);
      for (int n = 1; n < run.count(); ++n) {
        const double computed = apart(body_in(run, n), body_in(run, n - 1));
        const double seen = apart(body_in(shown, n), body_in(shown, n - 1));
        CHECK(seen <= 2.0 * computed + kRounding);
        if (computed > 0.1) largest_ratio = std::max(largest_ratio, seen / computed);
      }
    }
  CHECK(largest_ratio > 1.5);  // the bound is nearly reached
}

TEST_CASE(
    "A soft envelope shows the computed pose, bit by bit, of a body that moves by an envelope a "
    "frame",
    "[exact][filtering]") {
  const Trajectory fast = random_walk(300, 3.0 * kEnvelope.radius, 3.0 * kEnvelope.angle, 5);
  const Trajectory shown = shown_of(fast);
  int fast_frames = 0;
  for (int n = 1; n < fast.count(); ++n) {
    if (apart(body_in(fast, n), body_in(fast, n - 1)) < 1.0) continue;
    CHECK(same_pose(body_in(shown, n), body_in(fast, n)));
    ++fast_frames;
  }
  CHECK(fast_frames > 100);
}

TEST_CASE("Shaking by up to half an envelope is shown at rest at once by a soft envelope",
          "[exact][filtering]") {
  CHECK(last_change(shown_of(shaking(0.3))) == 0);
  CHECK(last_change(shown_of(shaking(0.499))) == 0);
  CHECK(last_change(shown_of(shaking(0.51))) > 0);
  // In any direction: within a ball half as wide as the envelope.
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Random chance(seed);
    const Trajectory run = run_of(200, [&](int) {
      BodyState state;
      const Vec3 along = chance.direction();
      const Vec3 axis = chance.direction();
      state.position_w = 0.249 * kEnvelope.radius * along;
      state.orientation_wb = rotation_from_vector(Vec3(0.249 * kEnvelope.angle * axis));
      return state;
    });
    CHECK(last_change(shown_of(run)) == 0);
  }
}

TEST_CASE(
    "Shaking along a line by up to two thirds of an envelope is shown at rest after two frames",
    "[exact][filtering]") {
  for (const double size : {0.51, 0.6, 0.66}) {
    const int last = last_change(shown_of(shaking(size)));
    CHECK(last >= 1);
    CHECK(last <= 2);
  }
  CHECK(last_change(shown_of(shaking(0.68))) == 99);
}

TEST_CASE("The lag of a soft envelope is the envelope that the speed leaves",
          "[exact][filtering]") {
  for (const double f : {0.05, 0.3, 0.7, 0.95}) {
    const Trajectory run = run_of(200, [=](int n) { return at(f * kEnvelope.radius * n); });
    const Trajectory shown = shown_of(run);
    for (int n = 100; n < 200; ++n)
      CHECK(apart(body_in(run, n), body_in(shown, n)) == near(1.0 - f, kRounding));
  }
}

TEST_CASE("A creeping body that shakes pops under the envelope of the thesis and not under ours",
          "[exact][filtering]") {
  BodyProperties cube{.size = Vec3::Ones()};
  // It creeps by 5 mm/s and oscillates by 4 mm in every frame, two fifths of the envelope.
  const Trajectory run =
      run_of(1200, [](int n) { return at(0.005 * kFrameTime * n + (n % 2 == 0 ? 0.0 : 0.004)); });
  const auto path = [&](const Trajectory& frames) { return corner_path(frames, BodyId{7}, cube); };
  const auto pops_of = [&](const PoseFilter& filter) {
    return pops(path(filtered(run, filter)), path(run), kEnvelope.radius);
  };
  CHECK(pops_of(EnvelopeFilter()).count >= 8);
  CHECK(pops_of(EnvelopeFilter()).largest > kEnvelope.radius);
  CHECK(pops_of(SoftEnvelopeFilter()).count == 0);
}

TEST_CASE("A body that creeps without turning keeps the bits of its orientation under ours",
          "[exact][filtering]") {
  BodyState start;
  start.orientation_wb.coeffs() = Vec3(0.1, -0.7, 0.3).homogeneous().normalized();
  const Trajectory run = run_of(100, [&](int n) {
    BodyState state = start;
    state.position_w.x() = 0.004 * n;
    return state;
  });
  const Trajectory shown = shown_of(run);
  CHECK(changes_in(shown) > 90);
  for (int n = 0; n < shown.count(); ++n)
    CHECK(body_in(shown, n).orientation_wb.coeffs() == start.orientation_wb.coeffs());
}
