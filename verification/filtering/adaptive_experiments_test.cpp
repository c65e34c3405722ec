/// \file
/// \brief Adaptive steps against fixed ones: the measure of rest, and the findings (claim 6.3.1b).

#include "driver/quick.hpp"
#include "filtering/adaptive_runs.hpp"
#include "support/test.hpp"

using namespace tumble::chapters;

namespace {

// Four cubes for two seconds, the last of them watched: one at rest; one that shakes by 2 mm in every
// other frame; one that creeps at 3 cm/s for a second; one that creeps to the end.
SettledRun written_run() {
  SettledRun run;
  const BodyProperties cube = box_properties(Vec3::Ones(), 1.0);
  for (int k = 0; k < 4; ++k) {
    run.world.add(cube, Vec3(3.0 * k, 0.5, 0.0));
  }
  const World start = run.world;
  for (int n = 0; n <= 120; ++n) {
    run.world.states()[1].position_w.y() = n % 2 == 0 ? 0.5 : 0.502;
    run.world.states()[2].position_w.z() = 0.03 * kFrame * std::min(n, 60);
    run.world.states()[3].position_w.z() = 0.03 * kFrame * n;
    run.frames.record(frame_of(run.world));
    run.touches.emplace_back(4, 1);
    run.world.finish_step(kFrame);
  }
  run.first = 60;
  return run;
}

}  // namespace

TEST_CASE("The time of rest follows from net ways of half a second, and chatter does not delay it",
          "[exact][filtering]") {
  const RestingMeasures measured = measure_resting(written_run());
  // A half second of creeping is 15 mm, a third of a second 10 mm: it takes until a half second
  // contains less than that, 40 frames / 60 of it after the end of the creeping less a frame.
  REQUIRE(measured.times.size() == 4);
  CHECK(measured.times[0] == 0.0);
  CHECK(measured.times[1] == 0.0);
  // The last half second with 10 mm or more begins 20 frames before frame 60, and ends 10 after.
  // Rounding decides whether exactly 10 mm count.
  CHECK(measured.times[2] == near(70.0 * kFrame, 1.01 * kFrame));
  CHECK(measured.times[3] == 120.0 * kFrame);
  CHECK(measured.time_to_rest(0.5) == 0.0);
  CHECK(measured.time_to_rest(0.75) == measured.times[2]);
  CHECK(measured.time_to_rest() == measured.times[3]);
  CHECK(share_moving(measured, 0.5) == 0.5);
  CHECK(share_moving(measured, 1.5) == 0.25);
  CHECK(share_moving(measured, 120.0 * kFrame) == 0.25);
}

TEST_CASE("The amplitude of a run is that of the bodies that rest", "[exact][filtering]") {
  const RestingMeasures measured = measure_resting(written_run());
  REQUIRE(measured.amplitudes.size() == 3);
  // [m] rounding of coordinates of a few metres
  CHECK(measured.amplitudes[0] == near(0.0, 1e-14));
  CHECK(measured.amplitudes[2] == near(2e-3, 1e-14));
  CHECK(measured.mean_chatter() == near(2e-3 / 3.0, 1e-14));
  CHECK(measured.chatter() == near(measured.amplitudes[1], 0.0));
  CHECK(RestingMeasures{}.chatter() == 0.0);
}

TEST_CASE("A run in adaptive steps has the frames of one in fixed steps, and all its work",
          "[unit][filtering]") {
  const Scene scene = make_scene("fig6_7", {"per_edge=2"});
  const auto technique = [&] { return make_technique("damped", {}); };
  const SteppedRun fixed = settle_in_steps(scene, technique(), fixed_steps(0), 1.0, 0.5);
  const SteppedRun fine = settle_in_steps(scene, technique(), fixed_steps(2), 1.0, 0.5);
  const SteppedRun adaptive = settle_in_steps(scene, technique(), {}, 1.0, 0.5);
  REQUIRE(fixed.run.frames.count() == 91);
  REQUIRE(adaptive.run.frames.count() == 91);
  for (int k = 0; k < 91; ++k)
    REQUIRE(fixed.run.frames.frame(k).time == adaptive.run.frames.frame(k).time);
  CHECK(fine.run.work().integrations == 4 * fixed.run.work().integrations);
  REQUIRE(adaptive.substeps.size() == 91);
  std::int64_t substeps = 0;
  for (const int n : adaptive.substeps) substeps += n;
  CHECK(substeps > 90);
  CHECK(adaptive.run.work().integrations * 90 == fixed.run.work().integrations * substeps);
  CHECK(adaptive.run.first == 60);
}

TEST_CASE("Steps that adapt neither halve chatter nor bring rest sooner under damped integration",
          "[claims][filtering]") {
  const FigureUnderTest figure("claim_6_3_1b_adaptive", {"per_edge=5", "seeds=2", "settling=2.5",
                                                         "watched=1", "halvings=2"});
  CHECK(
      figure.number("of two sayings about a step that adapts those that hold: half of the chatter "
                    "or less, and nine tenths of the time to rest or less, against the fixed "
                    "step") == 0.0);
  // [-] measured over 8 seeds and six seconds 2.8, from 2.5 to 3.2
  CHECK(figure.number("median amplitude of resting bodies, adaptive over fixed") > 1.5);
  // [-] measured 2.5, from 2.0 to 3.1
  CHECK(figure.number("time until half of the bodies rest, adaptive over fixed") > 1.3);
  // [-] measured 3.9; the bodies fly whole steps
  CHECK(figure.number("integrations, adaptive over fixed") < 4.0);
  CHECK(figure.number("integrations, adaptive over fixed") > 3.0);
}

TEST_CASE("A cube passes a thin plank from the speed on at which a step is as long as both",
          "[claims][filtering]") {
  // Both are 0.25 m: 15 m/s. What ends in the nearer half is pushed back, so it takes more than 7.5.
  CHECK(share_through(7.0, 8, fixed_steps(0)) == 0.0);
  CHECK(share_through(30.0, 8, fixed_steps(0)) >= 0.25);  // measured 0.5
  CHECK(share_through(60.0, 8, fixed_steps(0)) >= 0.5);   // measured 0.75
  for (const double speed : {7.0, 30.0, 60.0}) CHECK(share_through(speed, 8, {}) == 0.0);
}
