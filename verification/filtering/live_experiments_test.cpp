/// \file
/// \brief Filters that run live (claim 5.5e): the same frames, and how late they are seen.

#include "tumble/filtering/filters.hpp"

#include "driver/quick.hpp"
#include "filtering/live_runs.hpp"
#include "support/test.hpp"

using namespace tumble::chapters;

namespace {

double delay(const char* filter, double speed) {
  return steady_delay(speed, 960, *filter_of(filter));
}

}  // namespace

TEST_CASE("A mean over five frames waits for two, the other filters for none",
          "[claims][filtering]") {
  const FigureUnderTest figure("claim_5_5e_live");
  REQUIRE(figure.result.tables.size() == 3);
  const auto& rows = figure.result.tables[0].rows;
  REQUIRE(rows.size() == 5);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const double waits = k == 0 ? 2.0 : 0.0;
    CHECK(rows[k][1] == waits);  // held back during the run
    CHECK(rows[k][2] == waits);  // later frames that matter
  }
  CHECK(later_frames_needed(*filter_of("box:15")) == 7);
  CHECK(later_frames_needed(*filter_of("box:15,causal")) == 0);
  CHECK(figure.number("time for which frames wait at 60 Hz, box of five") ==
        near(1.0 / 30.0, 1e-15));
}

TEST_CASE("At constant speed each filter is as many frames late as its closed form says",
          "[exact][filtering]") {
  // A creeping body moves by 0.08/60 m in a frame, and 0.01 m is the envelope: the envelope pops
  // in every eighth frame, its mean offset is that of 0 to 7 frames; the soft one trails by
  // 1 - 0.08/0.6 envelopes. Exponential smoothing trails by 1/(2 pi f dt) frames.
  const double cutoff = 1.0 + 16.0 * 0.08;                              // [Hz]
  const auto close = [](double frames) { return near(frames, 1e-9); };  // measured 1e-13
  CHECK(delay("box:5", 0.08) == close(2.0));
  CHECK(delay("box:5,causal", 0.08) == close(2.0));
  CHECK(delay("box:9", 0.08) == close(4.0));
  CHECK(delay("envelope", 0.08) == close(3.5));
  CHECK(delay("soft_envelope", 0.08) ==
        close((1.0 - 0.08 * kFrame / 0.01) * 0.01 / (0.08 * kFrame)));
  CHECK(delay("one_euro:1Hz,16,1Hz", 0.08) ==
        close(1.0 / (2.0 * std::numbers::pi * cutoff * kFrame)));
  CHECK(delay("envelope", 3.0) == 0.0);
  CHECK(delay("soft_envelope", 3.0) == 0.0);
  CHECK(delay("box:5", 3.0) == close(2.0));
}

TEST_CASE("Envelopes show a landing in the frame of the impact, means over frames after it",
          "[claims][filtering]") {
  const FigureUnderTest figure("claim_5_5e_live");
  const auto& rows = figure.result.tables[0].rows;
  REQUIRE(rows.size() == 5);
  CHECK(rows[0][5] >= 2.0);  // measured 4
  CHECK(rows[1][5] == rows[0][5]);
  CHECK(rows[2][5] == 0.0);
  CHECK(rows[3][5] == 0.0);
  CHECK(rows[4][5] > 0.0);  // measured 1
}

TEST_CASE("Bits are counted one by one, and those of missing frames and bodies all",
          "[unit][filtering]") {
  Trajectory a;
  Trajectory b;
  const std::array<BodyId, 2> ids = {BodyId{1}, BodyId{2}};
  std::array<BodyState, 2> states;
  a.record(Frame{0.5, 1, ids, states});
  b.record(Frame{0.5, 1, ids, states});
  constexpr std::int64_t one_body = 64 * 14;  // id and state
  CHECK(differing_bits(a, b).different == 0);
  CHECK(differing_bits(a, b).compared == 128 + 2 * one_body);
  states[1].position_w.x() = -0.0;
  states[1].orientation_wb.w() = std::nextafter(1.0, 0.0);  // 52 bits of the fraction, one above
  a.record(Frame{1.0, 2, ids, states});
  b.record(Frame{1.0, 2, ids, std::array<BodyState, 2>{}});
  CHECK(differing_bits(a, b).different == 1 + 53);
  a.record(Frame{1.5, 3, std::span(ids).first(1), std::span(states).first(1)});
  CHECK(differing_bits(a, b).different == 54 + 128 + one_body);
  b.record(Frame{1.5, 3, ids, std::array<BodyState, 2>{}});
  CHECK(differing_bits(b, a).different == 54 + one_body);
}

TEST_CASE("In a live run bodies come, and one is taken away", "[unit][filtering]") {
  PlayedScene scene(make_scene("projectile", {"rows=2", "appears=0.1"}), {"contact_damped"});
  const int at_first = scene.world().count();
  const auto filters = live_filters();
  const LiveRun run = play_live(scene, filters, 0.4, 0.2);
  CHECK(run.computed.count() == 25);
  std::size_t most = 0;
  for (int k = 0; k < run.computed.count(); ++k)
    most = std::max(most, run.computed.frame(k).ids.size());
  CHECK(static_cast<int>(most) == at_first + 1);
  CHECK(static_cast<int>(run.computed.frame(24).ids.size()) == at_first);
  REQUIRE(run.live.size() == filters.size());
  for (const Trajectory& live : run.live) CHECK(live.count() == 25);

  // Nor is another one taken when rounding carries the clock past the end: 60 steps take more than 1 s.
  PlayedScene longer(make_scene("projectile", {"rows=2", "appears=0.1"}), {"contact_damped"});
  const LiveRun second = play_live(longer, filters, 1.0, 0.5);
  REQUIRE(second.computed.count() == 61);
  CHECK(longer.world().time() > 1.0);
  CHECK(static_cast<int>(second.computed.frame(60).ids.size()) == at_first);
}
