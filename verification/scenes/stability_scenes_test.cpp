/// \file
/// \brief Scenes of geometric stability: names, numbers of boxes, which box is over which, refusals.
#include "tumble/base/error.hpp"
#include "tumble/base/number_text.hpp"
#include "tumble/geometry/separation.hpp"
#include "tumble/scenes/library.hpp"

#include "support/catch.hpp"
#include "support/scenes.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace tumble;
using namespace tumble::test;

std::vector<std::string> names_of(const Scene& scene) {
  std::vector<std::string> names;
  for (const SceneBox& box : scene.boxes) names.push_back(box.name);
  return names;
}

// How many lower corners of a box are over an upright one, seen from above.
int corners_over(const SceneBox& top, const SceneBox& bottom) {
  int count = 0;
  for (const double x : {-0.5, 0.5}) {
    for (const double z : {-0.5, 0.5}) {
      const Vec3 corner_w =
          top.position_w +
          top.orientation_wb * Vec3(x * top.size.x(), -0.5 * top.size.y(), z * top.size.z());
      const Vec3 away = corner_w - bottom.position_w;
      CHECK(std::abs(away.y() - 0.5 * bottom.size.y()) < 1e-14);  // [m] rounding: they touch
      // [m] rounding: exactly over an edge counts
      if (std::abs(away.x()) <= 0.5 * bottom.size.x() + 1e-14 &&
          std::abs(away.z()) <= 0.5 * bottom.size.z() + 1e-14)
        ++count;
    }
  }
  return count;
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

// [-] The largest overhang with which a series stands.
double largest_overhang(const char* pattern, int count) {
  double low = 0.0;
  double high = 0.99;
  while (high - low > 1e-9) {
    const double middle = 0.5 * (low + high);
    const Scene scene = built("fig6_4", {{"pattern", pattern},
                                         {"count", std::to_string(count)},
                                         {"overhang", shortest_text(middle)}});
    (stands(scene) ? low : high) = middle;
  }
  return low;
}

}  // namespace

TEST_CASE("The top cube of figure 5.3 has one corner over the bottom one, and its centre beside it",
          "[unit][scenes]") {
  const Scene scene = built("fig5_3");
  CHECK(names_of(scene) == std::vector<std::string>{"bottom", "top"});
  CHECK(corners_over(scene.boxes[1], scene.boxes[0]) == 1);
  CHECK(scene.boxes[1].position_w.x() > 0.5);
  CHECK(scene.boxes[1].position_w.z() < -0.5);
  for (const char* shift : {"0.21", "0.5", "0.79"})
    CHECK(corners_over(built("fig5_3", {{"shift", shift}}).boxes[1], scene.boxes[0]) == 1);
  const Scene whole = built("fig5_3", {{"shift", "0"}, {"yaw", "0"}});
  CHECK(corners_over(whole.boxes[1], whole.boxes[0]) == 4);
}

TEST_CASE("The top cube of figure 5.4 is whole on the bottom box wherever it starts",
          "[unit][scenes]") {
  for (const char* offset : {"-0.5", "0", "0.3", "0.5"}) {
    const Scene scene = built("fig5_4", {{"offset", offset}, {"speed", "-3"}});
    CHECK(names_of(scene) == std::vector<std::string>{"bottom", "top"});
    CHECK(corners_over(scene.boxes[1], scene.boxes[0]) == 4);
    CHECK(scene.boxes[1].velocity_w == Vec3(-3.0, 0.0, 0.0));
    CHECK(scene.boxes[0].velocity_w == Vec3::Zero());
  }
}

TEST_CASE("Each bottom box of figure 5.5 is under two corners of the top one", "[unit][scenes]") {
  CHECK(names_of(built("fig5_5")) == std::vector<std::string>{"left", "right", "top"});
  for (const char* gap : {"0", "0.4", "0.8"}) {
    for (const char* yaw : {"-30", "0", "10", "30"}) {
      INFO("gap " << gap << ", yaw " << yaw);
      const Scene scene = built("fig5_5", {{"gap", gap}, {"yaw", yaw}});
      const double between =
          separation(shape_of(scene.boxes[0]), shape_of(scene.boxes[1])).distance;
      CHECK(between == near(std::stod(gap)).margin(1e-14));  // [m] rounding
      CHECK(corners_over(scene.boxes[2], scene.boxes[0]) == 2);
      CHECK(corners_over(scene.boxes[2], scene.boxes[1]) == 2);
    }
  }
}

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
  for (const char* rows : {"4", "8", "98"}) {
    CHECK_THROWS_WITH(built("fig5_6", {{"rows", rows}}),
                      Catch::Matchers::Contains("rows = " + std::string(rows)) &&
                          Catch::Matchers::Contains("no centre box; give an odd number"));
  }
  CHECK_THROWS_WITH(built("fig5_6", {{"rows", "1"}}), Catch::Matchers::Contains("from 3"));
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

TEST_CASE("Five blocks to and fro stand up to an overhang of 3/8, a staircase of N up to 1/N",
          "[exact][scenes]") {
  // [-] The search ends at 1e-9.
  CHECK(largest_overhang("to_and_fro", 5) == near(0.375).margin(2e-9));
  for (const int count : {3, 5, 8})
    CHECK(largest_overhang("staircase", count) == near(1.0 / count).margin(2e-9));
}
