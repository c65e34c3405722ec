/// \file
/// \brief A bouncing box, event by event: the infinite series of bounces in a finite time.
#include "tumble/base/tolerances.hpp"
#include "tumble/dynamics/event_search.hpp"

#include "support/catch.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

using namespace tumble;

namespace {

struct Bounces {
  int count = 0;                 // until the rebound is slow enough
  double time = 0.0;             // [s] of the last of them
  double rebound = 0.0;          // [m/s] after it
  std::int64_t evaluations = 0;  // of the search
  std::int64_t most = 0;         // of one event's
};

// Drops a box from 1 m and lets it bounce with restitution e in steps of 1/60 s.
Bounces bounce(double e, double slow, SearchMethod method, double resolution) {
  const std::vector<BodyProperties> bodies = {ground_properties(),
                                              box_properties(Vec3(1.0, 0.5, 2.0), 3.0)};
  std::vector<BodyState> states = {BodyState{}, make_state(bodies[1], Vec3(0.0, 1.25, 0.0))};
  const std::vector<IndexPair> pairs = {{0, 1}};
  SearchOptions options;
  options.method = method;
  options.resolution = resolution;
  EventSearch search;
  Bounces out;
  const double dt = 1.0 / 60.0;
  for (int step = 0; step < 10000; ++step) {
    double now = 0.0;  // since the start of the step
    while (true) {
      Flight flight;
      flight.bodies = bodies;
      flight.states = states;
      const FirstEvent& event = search.find(flight, pairs, 0.0, dt - now, options);
      states[1] = state_at(flight, 1, event.time);
      now += event.time;
      if (event.status != CollisionStatus::found) break;
      // Newton's restitution, by hand: v -> -e v.
      states[1].linear_momentum_w *= -e;
      ++out.count;
      out.time = step * dt + now;
      out.rebound = velocity(bodies[1], states[1]).y();
      out.evaluations += event.evaluations;
      out.most = std::max(out.most, event.evaluations);
      if (out.rebound <= slow) return out;
    }
  }
  FAIL("still bouncing");
  return out;
}

}  // namespace

TEST_CASE("A box dropped from 1 m bounces as often and as long as the geometric series",
          "[exact][search]") {
  struct Expected {
    double e, slow;
    int count;
    double time;
  };
  // v0 = √(2 g h) = 4.42944691807 m/s; n = ⌈ln(slow / v0) / ln e⌉.
  const std::array<Expected, 6> table = {{{0.5, 0.1, 6, 1.32635069540},
                                          {0.5, 0.01, 9, 1.35104339451},
                                          {0.5, 0.001, 13, 1.35435045243},
                                          {0.9, 0.1, 36, 8.37550707897},
                                          {0.9, 0.01, 58, 8.55891479272},
                                          {0.9, 0.001, 80, 8.57697625069}}};
  for (const Expected& expected : table) {
    for (const SearchMethod method : {SearchMethod::discrete, SearchMethod::conservative}) {
      const Bounces got = bounce(expected.e, expected.slow, method, 1e-10);
      CHECK(got.count == expected.count);
      // An event is found up to 1e-10 s early; later flights are then shorter by up to as much
      // for every bounce, which 80 bounces add up to 1e-8 s.
      CHECK(std::abs(got.time - expected.time) < 1e-8);  // [s] measured 5e-9
      // The bounces that are left take (2 v / g) / (1 - e), up to √(2 h / g) (1 + e) / (1 - e).
      const double end = got.time + 2.0 * got.rebound / 9.81 / (1.0 - expected.e);
      CHECK(std::abs(end - (expected.e == 0.5 ? 1.35457092296 : 8.57894917873)) < 1e-7);
    }
  }
}

TEST_CASE("At the default resolution a bounce costs at most 15 halvings", "[exact][search]") {
  const double resolution = tolerance::event_resolution;
  const Bounces discrete = bounce(0.9, 0.01, SearchMethod::discrete, resolution);
  CHECK(discrete.count == 58);
  CHECK(discrete.most == 15);  // ⌈log2((1/60) / 1e-6)⌉
  CHECK(discrete.evaluations <= 15 * 58);
  CHECK(std::abs(discrete.time - 8.55891479272) < 58 * 1e-6 / (1.0 - 0.9));  // measured 2e-5
  // Nothing turns here, so the conservative search steps right to the contact: measured 199
  // separations against 858.
  const Bounces conservative = bounce(0.9, 0.01, SearchMethod::conservative, resolution);
  CHECK(conservative.count == 58);
  CHECK(conservative.evaluations < discrete.evaluations);
}
