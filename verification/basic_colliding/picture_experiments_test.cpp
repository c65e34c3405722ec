/// \file
/// \brief The strip of a thrown die, and the gallery.

#include "driver/figure_texts.hpp"
#include "driver/quick.hpp"
#include "support/test.hpp"

#include <filesystem>

using namespace tumble::chapters;

namespace {

std::vector<Figure> gallery() {
  std::vector<Figure> figures = registered_figures();
  std::erase_if(figures, [](const Figure& figure) { return !figure.name.starts_with("gallery_"); });
  return figures;
}

double number_of(const Result& result, const char* name) { return quantity_of(result, name).value; }

// The caption of a picture: the command that makes it.
std::string command_for(const Figure& figure, const SceneRecipe& recipe) {
  const std::string time = shortest_text(figure.parameters.number("time"));
  std::string command = "tumble run " + std::string(recipe.name);
  if (time == "0") {
    command = "At the start: " + command;
  } else {
    command = "After " + time + " s under the basic technique: " + command +
              " --technique basic --set event_cap=" +
              std::to_string(figure.parameters.whole("event_cap"));
  }
  const Parameters defaults = recipe.parameters();
  for (std::size_t k = 0; k < defaults.all().size(); ++k) {
    const Parameter& set = figure.parameters.all()[k];
    if (set.value != defaults.all()[k].value) command += " --set " + set.key + '=' + set.value;
  }
  if (!recipe.build(defaults, Random(1)).joints.empty())
    command += " --technique glued --set contacts=collide";
  return command;
}

}  // namespace

TEST_CASE("A thrown die first meets the ground within a microsecond of its exact flight",
          "[exact][basic_colliding]") {
  const Figure figure = registered_figure("dice_strip");
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

TEST_CASE("The gallery has one picture for each built-in scene of its own",
          "[unit][basic_colliding]") {
  const std::vector<Figure> figures = gallery();
  std::size_t scenes = 0;
  for (const SceneRecipe& recipe : scene_library()) {
    if (recipe.name.substr(0, 3) == "fig")
      continue;  // a figure of the thesis, or another name of one of the others: some have a picture
    ++scenes;
    const std::string name = "gallery_" + std::string(recipe.name);
    INFO(name);
    const auto found =
        std::ranges::count_if(figures, [&](const Figure& figure) { return figure.name == name; });
    CHECK(found == 1);
  }
  const auto of_thesis = std::ranges::count_if(
      figures, [](const Figure& figure) { return figure.name.starts_with("gallery_fig"); });
  CHECK(figures.size() == scenes + static_cast<std::size_t>(of_thesis));
}

TEST_CASE("Each picture of the gallery shows all its boxes that are not hidden by the cage",
          "[unit][basic_colliding]") {
  for (const Figure& figure : gallery()) {
    if (figure.name == "gallery_projectile") continue;  // slow, alike
    INFO(figure.name);
    Parameters settings = figure.parameters;
    settings.set("time", "0");
    const Result result = figure.experiment(settings);
    REQUIRE(result.drawings.size() == 1);
    CHECK(result.drawings.front().suffix == "boxes");
    CHECK(result.drawings.front().commands.find("border lc") != std::string::npos);
    const double fixed = figure.name == "gallery_cage"              ? 6.0
                         : figure.name == "gallery_crate_off_table" ? 1.0
                         : figure.name == "gallery_seesaw"          ? 1.0
                         : figure.name == "gallery_slope"           ? 1.0
                         : figure.name == "gallery_fig6_1"          ? 1.0
                         : figure.name == "gallery_chain"           ? 1.0
                         : figure.name == "gallery_pendulum"        ? 1.0
                         : figure.name == "gallery_crane"           ? 1.0
                         : figure.name == "gallery_plank_bridge"    ? 2.0
                                                                    : 0.0;
    CHECK(static_cast<double>(result.tables.front().rows.size()) ==
          number_of(result, "movable boxes") + fixed);
  }
}

TEST_CASE("The caption of each picture of the gallery is the command that makes it",
          "[unit][basic_colliding]") {
  const std::filesystem::path source = TUMBLE_SOURCE_DIR;
  const auto texts = read_figure_texts(source / "chapters/basic_colliding/figures.toml");
  for (const Figure& figure : gallery()) {
    const SceneRecipe& recipe = scene_recipe(figure.name.substr(std::string("gallery_").size()));
    const auto text =
        std::ranges::find_if(texts, [&](const FigureText& one) { return one.name == figure.name; });
    REQUIRE(text != texts.end());
    CHECK(text->caption == command_for(figure, recipe));
    CHECK(text->section == recipe.section);
  }
}
