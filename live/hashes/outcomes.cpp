/// \file
/// \brief State hashes of every built-in scene under every technique.
#include "hashes/outcomes.hpp"

#include "tumble/record/run.hpp"

#include <stdexcept>
#include <utility>

namespace tumble::live {
namespace {

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

// Steps of a pair in the record: enough to fall and meet, few where each contact is a train of collisions.
int steps_of(std::string_view technique) {
  return technique == kDefaultTechnique ? 60 : technique == "microcollisions" ? 10 : 30;
}

// kind NAME KEY... Another default is another motion.
std::string declared(std::string_view kind, std::string_view name, const Parameters& settings) {
  std::string line(kind);
  line.append(" ").append(name);
  for (const Parameter& p : settings.all()) line.append(" ").append(p.key);
  return line;
}

}  // namespace

std::vector<Pair> pairs(bool full) {
  std::vector<Pair> all;
  for (const SceneRecipe& scene : scene_library()) {
    for (const TechniqueRecipe& technique : technique_library()) {
      Pair pair{scene, technique, scene.parameters(), ""};
      const bool as_it_is = full || technique.name == kDefaultTechnique;
      for (const Size& size : kSmaller) {
        if (as_it_is || size.scene != scene.name) continue;
        for (const auto& [key, value] : size.settings) {
          pair.settings.set(key, value);
          pair.size.append(pair.size.empty() ? "" : ",").append(key).append("=").append(value);
        }
      }
      if (pair.size.empty()) pair.size.append("-");
      all.push_back(std::move(pair));
    }
  }
  return all;
}

std::string outcome(const Pair& pair, int steps) {
  const RunSettings run{.dt = 1.0 / 60.0, .duration = steps / 60.0};
  try {
    const Scene scene = pair.scene.build(pair.settings, Random(run.seed));
    const auto stepper = pair.technique.make(pair.technique.options(), run.seed);
    const RunResult result = run_scene(scene, *stepper, run, {});
    return std::to_string(result.steps) + " " + result.state_hash;
  } catch (const std::invalid_argument& error) {
    return "refused " + std::string(message_of(error));
  }
}

std::vector<std::string> record() {
  std::vector<std::string> lines;
  for (const SceneRecipe& scene : scene_library())
    lines.push_back(declared("scene", scene.name, scene.parameters()));
  for (const TechniqueRecipe& technique : technique_library())
    lines.push_back(declared("technique", technique.name, technique.options()));
  for (const Pair& pair : pairs(false)) {
    const int steps = steps_of(pair.technique.name);
    const std::string result = outcome(pair, steps);
    std::string line(pair.scene.name);
    line.append(" ").append(pair.size).append(" ").append(pair.technique.name).append(" ");
    if (result.starts_with("refused"))  // the words of the reason may change
      line.append(std::to_string(steps)).append(" refused");
    else
      line.append(result);
    lines.push_back(std::move(line));
  }
  return lines;
}

}  // namespace tumble::live
