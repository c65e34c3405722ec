/// \file
/// \brief The strip of a thrown die, and the gallery.
#include "tumble/scenes/library.hpp"

#include "basic_colliding/experiments.hpp"
#include "support/catch.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

using namespace tumble;
using namespace tumble::chapters;

namespace {

std::vector<Figure> picture_figures() {
  std::vector<Figure> figures;
  add_picture_figures(figures);
  return figures;
}

double number_of(const Result& result, const std::string& name) {
  for (const Quantity& quantity : result.quantities) {
    if (quantity.name == name) return quantity.value;
  }
  throw std::invalid_argument("no quantity " + name);
}

}  // namespace

TEST_CASE("A thrown die first meets the ground within a microsecond of its exact flight",
          "[exact][basic_colliding]") {
  const Figure figure = picture_figures().front();
  REQUIRE(figure.name == "dice_strip");
  double worst = 0.0;     // [s] how early the impact was found
  double unbooked = 0.0;  // [-] of m g L
  bool late = false;
  for (const char* seed : {"1", "2", "3", "4", "5", "6"}) {
    Parameters settings = figure.parameters;
    settings.set("seed", seed);
    settings.set("interval", "0.03");  // up to 0.31 s: none of these dice has begun to rest
    const Result result = figure.experiment(settings);
    const double early = number_of(result, "the same from the exact flight") -
                         number_of(result, "time of the first impact");
    worst = std::max(worst, early);
    late = late || early < -1e-12;
    unbooked = std::max(unbooked, number_of(result, "energy change not booked, over m g L"));
    CHECK(result.drawings.size() == 6);
  }
  // [s] The search keeps the last moment without overlap, one resolution of 1e-6 s early at most.
  // Measured 5.7e-7.
  CHECK(worst <= 1e-6);
  CHECK_FALSE(late);
  // [-] Flight keeps the energy and an impact books what it takes: rounding. Measured 3e-15.
  CHECK(unbooked < 1e-13);
}

TEST_CASE("A strip that goes on until the die begins to rest, or ends before it lands, is refused",
          "[unit][basic_colliding]") {
  const Figure figure = picture_figures().front();
  Parameters settings = figure.parameters;
  settings.set("interval", "0.5");
  CHECK_THROWS_WITH(figure.experiment(settings), Catch::Matchers::Contains("begun to rest"));
  settings.set("interval", "0.001");
  CHECK_THROWS_WITH(figure.experiment(settings), Catch::Matchers::Contains("has not met"));
}

TEST_CASE("The gallery has one picture for each built-in scene of its own",
          "[unit][basic_colliding]") {
  const std::vector<Figure> figures = picture_figures();
  std::size_t scenes = 0;
  for (const SceneRecipe& recipe : scene_library()) {
    if (recipe.name.substr(0, 3) == "fig")
      continue;  // a figure of the thesis, or another name of one of the others: some have a picture
    ++scenes;
    const std::string name = "gallery_" + std::string(recipe.name);
    INFO(name);
    const auto found = std::count_if(figures.begin(), figures.end(),
                                     [&](const Figure& figure) { return figure.name == name; });
    CHECK(found == 1);
  }
  const auto of_thesis = std::count_if(figures.begin(), figures.end(), [](const Figure& figure) {
    return figure.name.rfind("gallery_fig", 0) == 0;
  });
  CHECK(figures.size() == scenes + static_cast<std::size_t>(of_thesis) + 1);
}

TEST_CASE("Each picture of the gallery shows all its boxes that are not hidden by the cage",
          "[unit][basic_colliding]") {
  for (const Figure& figure : picture_figures()) {
    if (figure.name == "dice_strip" || figure.name == "gallery_projectile")
      continue;  // slow, alike
    INFO(figure.name);
    Parameters settings = figure.parameters;
    settings.set("time", "0");
    const Result result = figure.experiment(settings);
    REQUIRE(result.drawings.size() == 1);
    CHECK(result.drawings.front().suffix == "boxes");
    CHECK(result.drawings.front().commands.find("border lc") != std::string::npos);
    CHECK(number_of(result, "rings of boxes drawn wrongly") == 0.0);
    const double fixed = figure.name == "gallery_cage"              ? 6.0
                         : figure.name == "gallery_crate_off_table" ? 1.0
                         : figure.name == "gallery_seesaw"          ? 1.0
                         : figure.name == "gallery_slope"           ? 1.0
                         : figure.name == "gallery_fig6_1"          ? 1.0
                                                                    : 0.0;
    CHECK(static_cast<double>(result.tables.front().rows.size()) ==
          number_of(result, "movable boxes") + fixed);
  }
  CHECK_THROWS_AS(measure_gallery("no_such_scene", Parameters()), std::invalid_argument);
}
