/// \file
/// \brief Looking up scenes, techniques and settings.
#include "request.hpp"

#include "tumble/base/error.hpp"
#include "tumble/base/suggestion.hpp"
#include "tumble/filtering/adaptive_step.hpp"
#include "tumble/filtering/filters.hpp"
#include "tumble/scenes/library.hpp"
#include "tumble/scenes/scene_file.hpp"
#include "tumble/techniques.hpp"

namespace tumble::app {
namespace {

// The recipe of a built-in scene, nullptr for a file. A built-in name is one even beside a file of this name.
const SceneRecipe* recipe_of(const std::string& scene) {
  const std::filesystem::path path(scene);
  if (path.extension() == ".toml" || path.has_parent_path()) return nullptr;
  for (const SceneRecipe& recipe : scene_library())
    if (recipe.name == scene) return &recipe;
  std::error_code failed;
  return std::filesystem::exists(path, failed) ? nullptr : &scene_recipe(scene);  // which throws
}

// Not checked yet.
Scene made(const Request& request, const SceneRecipe* recipe, const Parameters& settings) {
  if (recipe == nullptr) return read_scene(request.scene);
  return recipe->build(settings, Random(request.run.seed));
}

void apply_one(const std::string& setting, Parameters& scene, Parameters& technique) {
  const std::size_t equals = setting.find('=');
  require::that(equals != std::string::npos && equals > 0,
                "--set " + setting + ": expected key=value");
  const std::string key = setting.substr(0, equals);
  const std::string value = setting.substr(equals + 1);
  const auto after = [&](const std::string& prefix) {
    return key.compare(0, prefix.size(), prefix) == 0 ? key.substr(prefix.size()) : std::string();
  };
  if (const std::string name = after("scene."); !name.empty()) return scene.set(name, value);
  if (const std::string name = after("technique."); !name.empty())
    return technique.set(name, value);
  const bool both = scene.has(key) && technique.has(key);
  require::that(!both, "--set " + setting + ": the scene and the technique have this key: write " +
                           "scene." + key + " or technique." + key);
  if (scene.has(key)) return scene.set(key, value);
  if (technique.has(key)) return technique.set(key, value);
  std::vector<std::string_view> known;
  for (const Parameter& p : scene.all()) known.push_back(p.key);
  for (const Parameter& p : technique.all()) known.push_back(p.key);
  const std::string_view place =
      scene.all().empty() ? " (those of a scene file are in the file)" : "";
  refuse("--set " + setting + ": unknown key; " + expected_names(key, known).append(place));
}

// A folder for output may not hold the scene file that is read.
void require_not_in(const std::filesystem::path& folder, const std::string& scene) {
  const std::filesystem::path file(scene);
  std::error_code none;
  require::that(!std::filesystem::equivalent(file, folder / file.filename(), none),
                "--out " + folder.string() + " holds the scene that is read, " + scene +
                    ": give another folder");
}

}  // namespace

void apply(const std::vector<std::string>& settings, Parameters& scene, Parameters& technique) {
  for (const std::string& setting : settings) apply_one(setting, scene, technique);
}

std::filesystem::path output_folder(const Request& request, const std::string& kind,
                                    const std::string& last) {
  namespace fs = std::filesystem;
  std::error_code none;
  const std::string scene = fs::path(request.scene).stem().string();
  const std::string first =
      request.out.empty() ? (fs::path("runs") / (scene + "-" + kind)).string() : request.out;
  require_not_in(first, request.scene);
  if (request.force || !fs::exists(fs::path(first) / last, none)) return first;
  require::that(request.out.empty(), "--out " + first + " holds a run: give another " +
                                         "folder, or replace that run with --force");
  int number = 2;
  while (fs::exists(fs::path(first + "-" + std::to_string(number)) / last, none)) ++number;
  return first + "-" + std::to_string(number);
}

Scene resolve_scene(const Request& request) {
  const SceneRecipe* recipe = recipe_of(request.scene);
  Parameters settings = recipe != nullptr ? recipe->parameters() : Parameters();
  Parameters no_technique;
  apply(request.settings, settings, no_technique);
  return made(request, recipe, settings);
}

ResolvedRequest resolve(const Request& request) {
  require_run_settings(request.run);
  RunDescription d;
  d.scene = request.scene;
  d.technique = request.technique.empty() ? std::string(kDefaultTechnique) : request.technique;
  d.run = request.run;
  d.contacts = request.contacts;
  if (request.filter) d.filter = filter_of(*request.filter)->text();
  d.halvings = request.halvings;
  const TechniqueRecipe& technique = technique_recipe(d.technique);
  d.technique_settings = technique.options();
  const SceneRecipe* recipe = recipe_of(request.scene);
  if (recipe != nullptr) d.scene_settings = recipe->parameters();
  apply(request.settings, d.scene_settings, d.technique_settings);
  Scene scene = made(request, recipe, d.scene_settings);
  std::unique_ptr<Technique> stepper = technique.make(d.technique_settings, request.run.seed);
  if (d.halvings > 0)
    stepper = std::make_unique<AdaptiveStep>(std::move(stepper),
                                             AdaptiveStepOptions{.halvings = d.halvings});
  Simulation simulation(std::move(scene), std::move(stepper));
  d.ignored_physics = simulation.technique().ignores(simulation.world());
  std::filesystem::path folder = output_folder(request, d.technique, "summary.json");
  return {std::move(simulation), std::move(d), std::move(folder)};
}

}  // namespace tumble::app
