/// \file
/// \brief Crowds and ties, run small.
#include "tumble/dynamics/flight.hpp"

#include "driver/played_scene.hpp"
#include "driver/quick.hpp"
#include "support/test.hpp"
#include "timewarp/crowd_scenes.hpp"
#include "timewarp/event_story.hpp"
#include "timewarp/tie_scenes.hpp"

using namespace tumble::chapters;

TEST_CASE("The closed form of a chain gives the three collisions of a worked example",
          "[exact][timewarp]") {
  // Cubes at 0, 1.5 and 3.4 m with 2, 0 and -1 m/s: 0.5 / 2 s; then 0.9 m less 0.25 s at 1 m/s
  // remain between the second at 2 m/s and the third; at 0.9 s the first, at rest, is hit by the
  // second.
  const std::vector<Collision> story = exact_story({{0.0, 1.5, 3.4}, {2.0, 0.0, -1.0}}, 1.0);
  REQUIRE(story.size() == 3);
  CHECK(story[0].time == near(0.25, 1e-12));
  CHECK(story[1].time == near(7.0 / 15.0, 1e-12));
  CHECK(story[2].time == near(0.9, 1e-12));
  CHECK(story[0].first == 0);
  CHECK(story[1].first == 1);
  CHECK(story[2].first == 0);
  // A crossing after the end does not count.
  CHECK(exact_story({{0.0, 1.5, 3.4}, {2.0, 0.0, -1.0}}, 0.8).size() == 2);
}

TEST_CASE("A search over all bodies finds the collisions of chains in their closed form",
          "[reference][timewarp]") {
  const auto search = search_over_all();
  int collisions = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const Chain chain = random_chain(5, 8.0 / kStep, Random(seed));
    const std::vector<Collision> truth = exact_story(chain, kStep);
    const std::vector<Collision> found = story_of(*search, world_of(chain), kStep);
    REQUIRE(found.size() == truth.size());
    for (std::size_t k = 0; k < found.size(); ++k) {
      CHECK(found[k].first == truth[k].first);
      // [s] each collision adds an error of a tolerance at most
      CHECK(found[k].time == near(truth[k].time, 2e-8));
    }
    collisions += static_cast<int>(found.size());
  }
  CHECK(collisions > 100);
}

TEST_CASE("On a line the simple form is right as long as no two cubes can change places",
          "[claims][timewarp]") {
  const FigureUnderTest figure("claim_5_1a_order", {"seeds=2", "frames=1"});
  CHECK(figure.number("share of wrong chains, simple, up to the bound of two edges") == 0.0);
  // [-] measured with 400 chains 0.30
  CHECK(figure.number("share of wrong chains, simple, at twice the bound") > 0.15);
}

TEST_CASE("Two impacts come as far apart in time as was asked for, the left or the right one first",
          "[reference][timewarp]") {
  // Long enough apart for a fine search; between them the cube that was hit is still where it was.
  constexpr double delay = 1e-7;  // [s]
  int left = 0;
  for (const bool turning : {false, true}) {
    for (std::uint64_t seed = 1; seed <= 30; ++seed) {
      TwoImpacts impacts = two_impacts({.delay = delay, .turning = turning}, Random(seed));
      left += impacts.left_first ? 1 : 0;
      // Each alone: the other one is taken away.
      double times[2] = {0.0, 0.0};
      for (const int body : {0, 2}) {
        World world = impacts.world;
        world.remove(world.ids()[static_cast<std::size_t>(2 - body)]);
        const auto search = search_over_all(1e-11);
        const std::vector<Collision> story = story_of(*search, world, kStep);
        REQUIRE(!story.empty());
        times[body / 2] = story.front().time;
      }
      const double between = impacts.left_first ? times[1] - times[0] : times[0] - times[1];
      CHECK(std::abs(between - delay) < 2e-11);
      CHECK(std::min(times[0], times[1]) > 0.19 * kStep);
      CHECK(std::max(times[0], times[1]) < 0.81 * kStep);
    }
  }
  CHECK(left > 15);
  CHECK(left < 45);
}

TEST_CASE("Bisection brings two impacts in one of its cells in the order of a coin tossed",
          "[reference][timewarp]") {
  const FigureUnderTest figure("claim_5_1c_ties");
  const Quantity& share = quantity_of(figure.result, "the same, simple");
  // A cell of 1/60 s / 2^15 is 0.5086 of the tolerance; the share falls from a half to 0 in it.
  const double expected = 0.25 * (kStep / 32768.0) / 1e-6;
  CHECK(share.low < expected);
  CHECK(share.high > expected);
}

TEST_CASE("Ties that are resolved together are in no order, and hardly any is left out",
          "[claims][timewarp]") {
  const FigureUnderTest figure("claim_5_1c_ties");
  CHECK(figure.number("the same, ties together") == 0.0);
  CHECK(figure.number("share of them resolved at one stroke, ties together") > 0.9);
}
