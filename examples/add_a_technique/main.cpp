/// \file
/// \brief Built-in scenes under the technique of this folder and under contact_damped, side by side.
#include "cushion.hpp"

#include <cstdio>
#include <optional>
#include <stdexcept>
#include <tumble/base/error.hpp>
#include <tumble/record/run_files.hpp>
#include <tumble/scenes/library.hpp>

namespace {

using namespace tumble;
using Words = std::vector<std::string>;  // a scene, then key=value

// [tried]
// What is compared if nothing else is asked for.
const std::vector<Words> kTried = {{"stack", "count=1"},   {"stack", "count=3"},
                                   {"stack", "count=10"},  {"stack", "count=2", "top_mass=100"},
                                   {"pyramid", "rows=4"},  {"table"},
                                   {"slope", "angle=10"},  {"bouncing_box"},
                                   {"clump", "per_edge=3"}};
// [tried]

// [describe]
// A key is one of the scene, or else of the technique of this folder.
RunDescription describe(const Words& words, const TechniqueRecipe& technique, bool ours) {
  RunDescription d;
  d.scene = words.front();
  d.technique = technique.name;
  d.scene_settings = scene_recipe(d.scene).parameters();
  d.technique_settings = technique.options();
  for (std::size_t k = 1; k < words.size(); ++k) {
    const std::size_t equals = words[k].find('=');
    require::that(equals != std::string::npos, words[k] + ": expected key=value");
    const std::string key = words[k].substr(0, equals);
    const std::string value = words[k].substr(equals + 1);
    if (d.scene_settings.has(key)) {
      d.scene_settings.set(key, value);
    } else if (ours) {
      d.technique_settings.set(key, value);
    }
  }
  return d;
}
// [describe]

// [run]
void run(RunDescription d, const TechniqueRecipe& recipe, bool recorded) {
  const Random random(d.run.seed);
  const Scene scene = checked(scene_recipe(d.scene).build(d.scene_settings, random));
  const auto technique = recipe.make(d.technique_settings, d.run.seed);
  d.ignored_physics = technique->ignores(build_world(scene));

  std::optional<RunFiles> files;
  std::vector<RunObserver*> observers;
  if (recorded) {
    files.emplace("runs/" + d.scene + "-" + d.technique, d, scene);
    observers.push_back(&*files);
  }
  const RunResult result = run_scene(scene, *technique, d.run, observers);
  if (files) files->finish(result);
  // [run]
  std::printf("  %-15s %-9s %11.3g %11.3g %11.3g %11.3g   %s\n", d.technique.c_str(),
              std::string(name_of(result.end)).c_str(), result.worst_metrics.deepest_overlap,
              result.last.fastest, result.last.chatter.amplitude,
              result.worst_metrics.energy_error_share, result.state_hash.c_str());
}

void compare(const Words& words, bool recorded) {
  std::printf("%s", words.front().c_str());
  for (std::size_t k = 1; k < words.size(); ++k) std::printf(" %s", words[k].c_str());
  std::printf("\n");
  const TechniqueRecipe ours = example::cushion_recipe();
  const TechniqueRecipe& other = technique_recipe("contact_damped");
  run(describe(words, ours, true), ours, recorded);
  run(describe(words, other, false), other, recorded);
}

}  // namespace

/// Runs ten seconds of each scene, and prints a line for each technique.
/// \param count      of the arguments
/// \param arguments  a scene and its settings, recorded into runs/; nothing: those above
/// \return 0, or 2 for a scene or a setting that there is not
int main(int count, char** arguments) try {
  std::printf("  %-15s %-9s %11s %11s %11s %11s   %s\n", "technique", "end", "overlap_m",
              "speed_m_s", "chatter_m", "energy_err", "state_hash");
  if (count > 1) compare(Words(arguments + 1, arguments + count), true);
  if (count == 1)
    for (const Words& words : kTried) compare(words, false);
  return 0;
} catch (const std::invalid_argument& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 2;
}
