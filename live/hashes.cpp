/// \file
/// \brief Native state hashes of every built-in scene under every technique, for comparison with the module.
#include "tumble/record/run.hpp"
#include "tumble/scenes/library.hpp"
#include "tumble/techniques.hpp"

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace {

using namespace tumble;

// In most techniques large scenes take minutes at full size, natively too.
struct Size {
  std::string_view scene;
  std::vector<std::pair<std::string_view, std::string_view>> settings;
};
const std::vector<Size> kSmaller = {
    {"pyramid", {{"rows", "3"}}},
    {"pyramid3d", {{"rows", "2"}}},
    {"wall", {{"courses", "3"}, {"bricks", "3"}}},
    {"fig5_6", {{"rows", "3"}}},
    {"clump", {{"per_edge", "2"}}},
    {"projectile", {{"rows", "3"}, {"appears", "0.5"}}},
    {"fig6_6", {{"rows", "3"}, {"appears", "0.5"}}},
    {"fig6_7", {{"per_edge", "2"}}},
};

// The scene's settings; `text` becomes KEY=VALUE,KEY=VALUE or "-".
Parameters settings_of(const SceneRecipe& scene, bool full, std::string& text) {
  Parameters settings = scene.parameters();
  text.clear();
  for (const Size& size : kSmaller) {
    if (full || size.scene != scene.name) continue;
    for (const auto& [key, value] : size.settings) {
      settings.set(key, value);
      text.append(text.empty() ? "" : ",").append(key).append("=").append(value);
    }
  }
  if (text.empty()) text.append("-");
  return settings;
}

// Where a run stops: its hash, or why it cannot be made.
std::string outcome(const SceneRecipe& recipe, const Parameters& settings,
                    const TechniqueRecipe& technique, int steps) {
  const RunSettings run{.dt = 1.0 / 60.0, .duration = steps / 60.0};
  try {
    const Scene scene = recipe.build(settings, Random(run.seed));
    const auto stepper = technique.make(technique.options(), run.seed);
    const RunResult result = run_scene(scene, *stepper, run, {});
    return std::to_string(result.steps) + " " + result.state_hash;
  } catch (const std::invalid_argument& error) {
    return "refused " + std::string(message_of(error));
  }
}

}  // namespace

/// Prints a line for each scene and technique: SCENE SIZE TECHNIQUE STEPS HASH, or `refused` and why in place
/// of the last two. SIZE has the settings of a scene that is smaller than by default.
/// \param count      of the arguments
/// \param arguments  steps; then `full` for all scenes at the size that they have by default. The default
///                   technique always gets that. Then a scene and a technique for these alone
/// \return 0, or 2 for other arguments
int main(int count, char** arguments) {
  const int steps = count > 1 ? std::atoi(arguments[1]) : 0;
  const bool full = count > 2 && std::string_view(arguments[2]) == "full";
  const bool alone = count == 5;
  if (steps < 1 || (count != 2 && !(full && (count == 3 || alone)))) {
    std::fprintf(stderr, "usage: live_hashes STEPS [full [SCENE TECHNIQUE]]\n");
    return 2;
  }
  for (const SceneRecipe& scene : scene_library()) {
    for (const TechniqueRecipe& technique : technique_library()) {
      if (alone && (scene.name != arguments[3] || technique.name != arguments[4])) continue;
      std::string size;
      const Parameters settings =
          settings_of(scene, full || technique.name == kDefaultTechnique, size);
      std::string line(scene.name);
      line.append(" ").append(size).append(" ").append(technique.name).append(" ");
      line.append(outcome(scene, settings, technique, steps));
      std::printf("%s\n", line.c_str());
      std::fflush(stdout);
    }
  }
  return 0;
}
