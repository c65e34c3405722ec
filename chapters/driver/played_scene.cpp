/// \file
/// \brief A built-in scene under a technique of the library, step by step.
#include "driver/played_scene.hpp"

#include "tumble/base/error.hpp"
#include "tumble/scenes/library.hpp"

#include "driver/csv.hpp"
#include "driver/settings.hpp"

#include <stdexcept>
#include <utility>

namespace tumble::chapters {

PlayedScene::PlayedScene(Scene start, const PlayedTechnique& played, std::uint64_t seed)
    : scene(std::move(start)),
      world(build_world(scene)),
      technique(technique_with(played.name, played.settings, seed)) {}

StepReport PlayedScene::step() {
  const double before = world.time();
  const StepReport report = technique->step(world, kStep);
  if (report.status == StepStatus::unsolved || report.status == StepStatus::not_finite)
    throw std::runtime_error("a step of " + std::string(technique->name()) + " failed");
  come_and_go(scene, before, world.time(), world);
  return report;
}

void PlayedScene::advance(double time, const std::function<void(const StepReport&)>& after) {
  while (world.time() < time - 0.5 * kStep) {
    const StepReport report = step();
    if (after) after(report);
  }
}

std::size_t PlayedScene::index(std::string_view name) const {
  const auto id = world.find(name);
  require::that(id.has_value(), "no body " + std::string(name));
  return static_cast<std::size_t>(world.index_of(*id));
}

double PlayedScene::speed(std::string_view name) const {
  const std::size_t k = index(name);
  return velocity(world.bodies()[k], world.states()[k]).x();
}

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
