/// \file
/// \brief Simulations of built-in scenes for experiments.
#include "driver/played_scene.hpp"

#include "tumble/base/index.hpp"
#include "tumble/scenes/library.hpp"

#include "driver/csv.hpp"
#include "driver/finished.hpp"
#include "driver/settings.hpp"

namespace tumble::chapters {

StepReport PlayedScene::step() {
  const StepReport report = finished(Simulation::step(kStep));
  settle();
  return report;
}

void PlayedScene::advance(double time, const std::function<void(const StepReport&)>& after) {
  while (world().time() < time - 0.5 * kStep) {
    const StepReport report = step();
    if (after) after(report);
  }
}

std::size_t PlayedScene::index(std::string_view name) const { return idx(world().index_of(name)); }

double PlayedScene::speed(std::string_view name) const { return body(name).velocity_w().x(); }

Scene scene_with(std::string_view name, const std::vector<std::string>& settings,
                 std::uint64_t seed) {
  const SceneRecipe& recipe = scene_recipe(name);
  Parameters parameters = recipe.parameters();
  set_all(parameters, settings);
  return recipe.build(parameters, Random(seed));
}

std::string setting(std::string_view key, double value) {
  return std::string(key) + '=' + full_text(value);
}

}  // namespace tumble::chapters
