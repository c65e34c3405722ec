/// \file
/// \brief The thesis's own scenes under damped integration: they stand, fall and settle as the
///        figures show.
#include "driver/quick.hpp"
#include "support/catch.hpp"

using namespace tumble::chapters;

TEST_CASE("The pyramid of figure 6.6 stands still until it is shot at",
          "[claims][impulse_damped]") {
  // As large and as long as in the figure: ten rows, five seconds.
  const FigureUnderTest figure("fig6_6_projectile", {"rows=10", "height=3.5", "appears=5"});
  CHECK(figure.number("boxes of the pyramid") == 55.0);
  // [mm] of 1 m; measured 3.8: pushes of 1 mm, one for each row that they are handed through.
  CHECK(figure.number("farthest that a box moves in the first half second") < 10.0);
  CHECK(figure.number("farthest that a box moves from then to the shot") == 0.0);
  // Measured 3, as with Coulomb's friction.
  CHECK(figure.number("boxes that have fallen in the last frame") > 0.0);
  CHECK(figure.result.drawings.size() == 6);
}

TEST_CASE("Figures 6.6 and 6.7 have films", "[unit][impulse_damped]") {
  for (const char* name : {"fig6_6_projectile", "fig6_7_clump"}) {
    const FigureUnderTest figure(name);
    INFO(name);
    REQUIRE(figure.result.film);
    const std::string gif = figure.result.film();
    CHECK(gif.substr(0, 6) == "GIF89a");
    CHECK(gif.back() == ';');
  }
}

TEST_CASE("A pyramid does not overlap or chatter before a shot, and does both after it",
          "[claims][impulse_damped]") {
  const FigureUnderTest figure("fig6_6_projectile_curves", {"rows=10", "height=3.5", "appears=3"});
  CHECK(figure.number("deepest overlap before the shot") < 1e-9);  // [mm] rounding
  CHECK(figure.number("largest chatter before the shot, after a second") == 0.0);
  CHECK(figure.number("deepest overlap after the shot") > 1.0);  // [mm] measured 41
  CHECK(figure.number("largest chatter after the shot") > 1.0);  // [mm] measured 51
  // [mm] a fifth of an edge would be another pile
  CHECK(figure.number("deepest overlap after the shot") < 200.0);
  CHECK(figure.number("largest gain of energy in a step") < 10.0);  // [J] measured 2.3
}

TEST_CASE("Cubes that fly together settle, and some still chatter", "[claims][impulse_damped]") {
  const FigureUnderTest figure("fig6_7_clump", {"per_edge=4", "duration=8"});
  const double cubes = figure.number("cubes");
  CHECK(cubes == 64.0);
  // [-] measured 0 to 4 of 125 in the figure
  CHECK(figure.number("cubes that do not rest") < 0.1 * cubes);
  CHECK(figure.number("mean distance from the axis in the end") <
        figure.number("mean distance from the axis at the start"));
  // The caption of the figure says so.
  CHECK(figure.number("largest chatter of those that rest") > 0.0);
  CHECK(figure.number("largest chatter of those that rest") < 100.0);  // [mm] a tenth of an edge
}
