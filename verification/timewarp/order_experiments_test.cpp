/// \file
/// \brief Stories of collisions and how they differ, and figure 5.1 (5.1).

#include "driver/played_scene.hpp"
#include "driver/quick.hpp"
#include "support/test.hpp"
#include "timewarp/bands.hpp"
#include "timewarp/event_story.hpp"

using namespace tumble::chapters;

namespace {

// A story in which the k-th collision is at the time k; pairs as letters, such as "AB".
std::vector<Collision> story(const std::vector<std::string>& pairs) {
  std::vector<Collision> collisions;
  for (const std::string& pair : pairs)
    collisions.push_back({static_cast<double>(collisions.size()), pair[0] - 'A', pair[1] - 'A'});
  return collisions;
}

std::vector<int> counts(const std::vector<std::string>& reference,
                        const std::vector<std::string>& tested) {
  const StoryDifference found = compare_stories(story(reference), story(tested));
  return {found.missed, found.misordered, found.invented};
}

std::string wrong(const std::vector<std::string>& reference,
                  const std::vector<std::string>& tested) {
  std::string marks;
  for (const char mark : compare_stories(story(reference), story(tested)).wrong)
    marks += mark != 0 ? 'x' : '.';
  return marks;
}

World world_with(const std::string& scene) { return build_world(make_scene(scene, {})); }

}  // namespace

TEST_CASE("A collision is missed, misordered or invented by its partner in the true story",
          "[unit][timewarp]") {
  CHECK(counts({"AB", "BC", "CD"}, {"AB", "CD"}) == std::vector<int>{1, 0, 0});
  CHECK(counts({"AB", "CD"}, {"AB", "BC", "CD"}) == std::vector<int>{0, 0, 1});
  CHECK(counts({"AB", "CD"}, {"CD", "AB"}) == std::vector<int>{0, 1, 0});
  CHECK(counts({}, {"AB"}) == std::vector<int>{0, 0, 1});
  CHECK(counts({"AB"}, {}) == std::vector<int>{1, 0, 0});
  // The second meeting of a pair has the second one as its partner, and no other.
  CHECK(counts({"AB", "CD", "AB"}, {"AB", "AB"}) == std::vector<int>{1, 0, 0});
  CHECK(counts({"AB", "CD"}, {"AB", "CD", "AB"}) == std::vector<int>{0, 0, 1});
  // One that comes much too late is one out of place, not all that it lets pass.
  CHECK(counts({"AB", "BC", "CD", "DE"}, {"BC", "CD", "DE", "AB"}) == std::vector<int>{0, 1, 0});
  CHECK(wrong({"AB", "BC", "CD", "DE"}, {"BC", "CD", "DE", "AB"}) == "...x");
  // Of equally long choices, the one that ends first in the true story: here CD and not DE.
  CHECK(wrong({"AB", "BC", "CD", "DE"}, {"DE", "AC", "CD"}) == "xx.");
}

TEST_CASE("A longest common story leaves out no more collisions than any other choice",
          "[reference][timewarp]") {
  // Against all 2^n choices of the tested story.
  const std::vector<std::string> reference = {"AB", "BC", "CD", "DE", "EF", "FG", "GH", "HI"};
  Random random(3);
  for (int round = 0; round < 50; ++round) {
    std::vector<std::string> tested = reference;
    for (std::size_t k = tested.size(); k > 1; --k)
      std::swap(tested[k - 1],
                tested[static_cast<std::size_t>(random.unit() * static_cast<double>(k))]);
    int most = 0;
    for (unsigned choice = 0; choice < (1U << tested.size()); ++choice) {
      std::vector<std::string> chosen;
      for (std::size_t k = 0; k < tested.size(); ++k)
        if ((choice >> k & 1U) != 0) chosen.push_back(tested[k]);
      if (std::ranges::is_sorted(chosen)) most = std::max(most, static_cast<int>(chosen.size()));
    }
    CHECK(counts(reference, tested)[1] == static_cast<int>(tested.size()) - most);
  }
}

TEST_CASE("A story goes on over frames and takes its observer away", "[unit][timewarp]") {
  const World start = world_with("line");
  const auto technique = make_technique("timewarp_simple");
  CHECK(story_of(*technique, start, 1.0).size() == 3);
  World again = start;
  CHECK_NOTHROW(technique->step(again, 1.0));
  // [s] times go on from frame to frame; a few times the resolution.
  const std::vector<Collision> frames = story_of(*technique, start, 0.25, 4);
  REQUIRE(frames.size() == 3);
  CHECK(frames[2].time == near(0.9, 1e-5));
  CHECK(frames[2].first == 0);
  CHECK(frames[2].second == 1);
  // [s] and of a world that has run for a while they count from its start.
  REQUIRE(technique->step(again, 1.0).events == 0);
  again.set_velocity(again.ids()[0], Vec3(2.0, 0.0, 0.0), Vec3::Zero());
  const std::vector<Collision> late = story_of(*technique, again, 1.0);
  REQUIRE(!late.empty());
  CHECK(late[0].time == near(0.55, 1e-5));
}

TEST_CASE("Bands end where the technique has put the bodies", "[unit][timewarp]") {
  for (const char* name : {"timewarp_simple", "timewarp_safer", "timewarp_swept"}) {
    for (const char* scene : {"fig5_1", "line"}) {
      CAPTURE(name, scene);
      const double frame = std::string(scene) == "line" ? 1.0 : 1.0 / 60.0;
      const World start = world_with(scene);
      World end = start;
      const EventLog events = events_of(*make_technique(name), end, frame);
      const std::vector<Way> ways = ways_of(start, events, frame);
      REQUIRE(ways.size() == end.states().size());
      for (std::size_t body = 0; body < ways.size(); ++body) {
        // [m] rounding: each flight ends at a knot.
        CHECK(place_at(ways[body], frame) == near(end.states()[body].position_w.x(), 1e-12));
        CHECK(ways[body].front().place == start.states()[body].position_w.x());
      }
    }
  }
}

TEST_CASE("The reference of figure 5.1 meets at the times of the closed form",
          "[exact][timewarp]") {
  const FigureUnderTest figure("fig5_1_order");
  // [m/s] 24 is handed on from A to E, D's 1.2 to C; [m] gaps of 0.06, 0.13, 0.02, 0.013.
  const double ab = 0.06 / 24.0;
  const double bc = ab + 0.13 / 24.0;
  const double cd = bc + (0.02 + 1.2 * bc) / (24.0 - 1.2);
  const double left = 0.013 - 1.2 * cd;  // [m] between D and E when C meets D
  const double de = cd + left / 24.0;
  const double again = cd + left / 1.2;
  const std::vector<double> times = {ab, bc, cd, de, again};
  std::vector<std::vector<double>> reference;
  for (const auto& row : figure.result.tables[0].rows)
    if (row[0] == 3.0) reference.push_back(row);
  REQUIRE(reference.size() == times.size());
  // [edges] A and B meet at B's left face, half an edge from its centre at 1.6.
  CHECK(reference[0][2] == near(1.1, 1e-9));
  for (std::size_t k = 0; k < times.size(); ++k) {
    // [ms] measured 1e-5 at the most, in the last of them.
    CHECK(reference[k][3] == near(1e3 * times[k], 2e-5));
    CHECK(reference[k][4] == 0.0);
  }
}

TEST_CASE("Without the cube in between, all forms resolve figure 5.1 alike", "[claims][timewarp]") {
  // A at a speed at which it ends in B and not beyond it: nothing is hidden.
  const FigureUnderTest figure("fig5_1_order", {"fast=8"});
  CHECK(figure.number("collisions out of place, simple") == 0.0);
  CHECK(figure.number("collisions out of place, safer") == 0.0);
  CHECK(figure.number("of three sayings about figure 5.1 those that hold: simple goes wrong, safer "
                      "goes wrong, swept volumes do not") == 1.0);
}
