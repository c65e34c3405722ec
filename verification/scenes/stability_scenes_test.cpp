/// \file
/// \brief Scenes of geometric stability: names, numbers of boxes, which box is over which, refusals.

#include "support/scenes.hpp"
#include "support/test.hpp"

namespace {

std::vector<std::string> names_of(const Scene& scene) {
  std::vector<std::string> names;
  for (const SceneBox& box : scene.boxes) names.push_back(box.name);
  return names;
}

// Whether in a series of blocks all that are above a block have their centre over the face that
// they share with it.
bool stands(const Scene& scene) {
  double moment = 0.0;
  double mass = 0.0;
  for (std::size_t k = scene.boxes.size(); k-- > 1;) {
    const SceneBox& upper = scene.boxes[k];
    const SceneBox& lower = scene.boxes[k - 1];
    moment += upper.mass * upper.position_w.x();
    mass += upper.mass;
    const double left = std::max(upper.position_w.x() - 0.5 * upper.size.x(),
                                 lower.position_w.x() - 0.5 * lower.size.x());
    const double right = std::min(upper.position_w.x() + 0.5 * upper.size.x(),
                                  lower.position_w.x() + 0.5 * lower.size.x());
    if (moment < left * mass || moment > right * mass) return false;
  }
  return true;
}

}  // namespace

TEST_CASE("Figure 5.6 is the pyramid without the centre box of its lowest row", "[unit][scenes]") {
  for (const int rows : {3, 7, 11}) {
    INFO(rows << " rows");
    const std::string given = std::to_string(rows);
    const Scene scene = built("fig5_6", {{"rows", given}});
    const Scene whole = built("pyramid", {{"rows", given}});
    CHECK(scene.boxes.size() == static_cast<std::size_t>(rows * (rows + 1) / 2 - 1));
    const std::string centre = "r1_" + std::to_string(rows / 2 + 1);
    std::size_t k = 0;
    for (const SceneBox& box : whole.boxes) {
      if (box.name == centre) {
        CHECK(box.position_w.x() == 0.0);
        continue;
      }
      REQUIRE(k < scene.boxes.size());
      CHECK(scene.boxes[k].name == box.name);
      CHECK(scene.boxes[k].position_w == box.position_w);
      ++k;
    }
  }
  const Scene touching = built("fig5_6", {{"rows", "5"}, {"gap", "0"}});
  CHECK(separation(shape_of(touching.boxes[0]), shape_of(touching.boxes[1])).distance == 0.0);
}

TEST_CASE("A pyramid with an even number of boxes below has no centre to take out, and says so",
          "[unit][scenes]") {
  for (const char* rows : {"4", "8", "98"})
    CHECK_THROWS_WITH(
        built("fig5_6", {{"rows", rows}}),
        Contains("rows = " + std::string(rows)) && Contains("no centre box; give an odd number"));
  CHECK_THROWS_WITH(built("fig5_6", {{"rows", "1"}}), Contains("from 3"));
  CHECK_NOTHROW(built("fig5_6", {{"rows", "9"}}));
}

TEST_CASE("The blocks of figure 6.4 lean to and fro, or all to one side", "[unit][scenes]") {
  const Scene scene = built("fig6_4");
  CHECK(names_of(scene) ==
        std::vector<std::string>{"base", "block1", "block2", "block3", "block4", "block5"});
  const auto places = [](const Scene& series) {
    std::vector<double> x;
    for (const SceneBox& box : series.boxes) x.push_back(box.position_w.x());
    return x;
  };
  CHECK(places(scene) == std::vector<double>{0.0, 0.0, 0.25, 0.0, -0.25, 0.0});
  CHECK(places(built("fig6_4", {{"pattern", "staircase"}, {"overhang", "0.125"}})) ==
        std::vector<double>{0.0, 0.0, 0.125, 0.25, 0.375, 0.5});
  CHECK(stands(scene));
  CHECK(built("fig6_4", {{"count", "9"}}).boxes.size() == 10);
}
