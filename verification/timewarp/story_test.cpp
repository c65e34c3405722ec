/// \file
/// \brief Collisions by three methods: swept and full timewarp, and a search over all bodies.
#include "tumble/basic_colliding/basic.hpp"
#include "tumble/timewarp/timewarp_full.hpp"

#include "support/test.hpp"
#include "timewarp/cases.hpp"

namespace {

// The first collisions of a scene, and whether all searches converged.
struct Story {
  EventLog events;
  bool complete = true;
};

Story collect(Technique& technique, World world, std::size_t length) {
  Listener heard;
  technique.observe(&heard);
  Story out;
  for (int k = 0; k < 600 && heard.events.size() < length; ++k) {
    const StepReport report = technique.step(world, 1.0 / 60.0);
    out.complete = out.complete && report.status == StepStatus::done && report.fallbacks == 0;
  }
  technique.observe(nullptr);
  out.events = heard.events;
  return out;
}

Story by_swept(const World& world, double resolution, std::size_t length) {
  return collect(*make_timewarp("timewarp_swept", {.resolution = resolution}), world, length);
}

Story by_full(const World& world, double resolution, std::size_t length, double stride = 1.0,
              int synchronise_every = 0) {
  TimewarpFullOptions options;
  options.resolution = resolution;
  options.stride = stride;
  options.synchronise_every = synchronise_every;
  TimewarpFull full(options);
  return collect(full, world, length);
}

Story by_all(const World& world, double resolution, std::size_t length) {
  Basic basic({.resolution = resolution, .search = SearchMethod::conservative});
  return collect(basic, world, length);
}

// Number of collisions that two runs share from the start, and the difference of their times.
struct Agreement {
  std::size_t length = 0;
  double times = 0.0;  // [s]
};

Agreement agreement(const EventLog& a, const EventLog& b, std::size_t most) {
  Agreement out;
  for (; out.length < std::min({a.size(), b.size(), most}); ++out.length) {
    const Event& one = a[out.length];
    const Event& other = b[out.length];
    if (one.first != other.first || one.second != other.second) break;
    out.times = std::max(out.times, std::abs(one.time - other.time));
  }
  return out;
}

// 8 to 12 cubes in a cage, every second case with gravity.
World random_cage(std::uint64_t seed) {
  World world = world_of(
      "cage", {{"count", std::to_string(8 + seed % 5)}, {"spin", seed % 3 == 0 ? "10" : "2"}},
      seed);
  if (seed % 2 == 0) world.gravity_w = Vec3(0.0, -9.81, 0.0);
  return world;
}

}  // namespace

TEST_CASE("Swept, full timewarp and a search over all bodies find the same collisions",
          "[reference][timewarp]") {
  // A time difference grows about a thousandfold in 30 collisions (measured: from 1e-13 s to
  // 2e-10 s), in any order of computation; so the resolution is far below the tolerance.
  constexpr std::size_t kLength = 30;
  constexpr double kResolution = 1e-13;
  double worst = 0.0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    CAPTURE(seed);
    const World world = random_cage(seed);
    const Story all = by_all(world, kResolution, kLength);
    CHECK(all.complete);
    const Story swept = by_swept(world, kResolution, kLength);
    const Story full = by_full(world, kResolution, kLength);
    CHECK(swept.complete);
    CHECK(full.complete);
    const Agreement of_swept = agreement(all.events, swept.events, kLength);
    const Agreement of_full = agreement(all.events, full.events, kLength);
    CHECK(of_swept.length == kLength);
    CHECK(of_full.length == kLength);
    worst = std::max({worst, of_swept.times, of_full.times});
  }
  CHECK(worst < 1e-9);
}

TEST_CASE("The collisions of a full timewarp do not depend on how far bodies fly ahead",
          "[reference][timewarp]") {
  constexpr std::size_t kLength = 30;
  double worst = 0.0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const World world = random_cage(seed);
    const Story swept = by_swept(world, 1e-13, kLength);
    for (const double stride : {0.0, 0.3, 2.5, 7.0}) {
      for (const int synchronise_every : {0, 3}) {
        CAPTURE(seed, stride, synchronise_every);
        const Story full = by_full(world, 1e-13, kLength, stride, synchronise_every);
        CHECK(full.complete);
        const Agreement shared = agreement(swept.events, full.events, kLength);
        CHECK(shared.length == kLength);
        worst = std::max(worst, shared.times);
      }
    }
  }
  CHECK(worst < 1e-9);
}

TEST_CASE("Runs diverge later the finer the resolution of collisions", "[reference][timewarp]") {
  // Measured: 108 collisions in a row at 1e-7 s, 194 at 1e-13 s.
  double shared[2] = {0.0, 0.0};
  int compared[2] = {0, 0};
  for (const int fine : {0, 1}) {
    const double resolution = fine == 1 ? 1e-13 : 1e-7;
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
      const World world = random_cage(2 * seed);
      const Story all = by_all(world, resolution, 400);
      const Story swept = by_swept(world, resolution, 400);
      if (!all.complete || !swept.complete) continue;
      ++compared[fine];
      shared[fine] += static_cast<double>(agreement(all.events, swept.events, 400).length);
    }
    REQUIRE(compared[fine] >= 5);
    shared[fine] /= compared[fine];
  }
  CAPTURE(shared[0], shared[1], compared[0], compared[1]);
  CHECK(shared[0] > 40.0);
  CHECK(shared[1] > 1.3 * shared[0]);
}
