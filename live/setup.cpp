/// \file
/// \brief Reading a request.
#include "tumble/base/error.hpp"
#include "tumble/scenes/library.hpp"
#include "tumble/scenes/scene_file.hpp"
#include "tumble/techniques.hpp"

#include "session.hpp"

#include <charconv>

namespace tumble::live {
namespace {

// What the lines of a request say.
struct Words {
  std::string_view scene;
  std::string_view toml;
  bool has_toml = false;
  std::string_view technique = kDefaultTechnique;
  std::uint64_t seed = 1;
  std::vector<std::string_view> settings;
};

std::uint64_t seed_of(std::string_view text) {
  std::uint64_t seed = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), seed);
  require::that(error == std::errc() && end == text.data() + text.size(),
                "seed " + std::string(text) + ": expected a whole number from 0");
  return seed;
}

Words words_of(std::string_view request) {
  Words words;
  while (!request.empty()) {
    const std::size_t end = request.find('\n');
    const std::string_view line = request.substr(0, end);
    request.remove_prefix(end == std::string_view::npos ? request.size() : end + 1);
    const std::size_t blank = line.find(' ');
    const std::string_view word = line.substr(0, blank);
    const std::string_view rest =
        blank == std::string_view::npos ? std::string_view() : line.substr(blank + 1);
    if (word == "scene") {
      words.scene = rest;
    } else if (word == "technique") {
      words.technique = rest;
    } else if (word == "seed") {
      words.seed = seed_of(rest);
    } else if (word == "set") {
      words.settings.push_back(rest);
    } else if (word == "toml") {
      require::that(words.scene.empty(), "scene " + std::string(words.scene) +
                                             " and toml: expected a name or a text, not both");
      words.toml = request;
      words.has_toml = true;
      break;
    } else {
      require::that(word.empty(), "unknown word " + std::string(word) +
                                      ": expected scene, technique, seed, set or toml");
    }
  }
  return words;
}

void apply(std::string_view setting, Parameters& scene, Parameters& technique) {
  const std::size_t equals = setting.find('=');
  const std::size_t dot = setting.find('.');
  const std::string_view whose = setting.substr(0, dot);
  require::that(
      equals != std::string_view::npos && dot < equals &&
          (whose == "scene" || whose == "technique"),
      "set " + std::string(setting) + ": expected scene.KEY=VALUE or technique.KEY=VALUE");
  Parameters& settings = whose == "scene" ? scene : technique;
  settings.set(setting.substr(dot + 1, equals - dot - 1), setting.substr(equals + 1));
}

}  // namespace

Setup make_setup(std::string_view request) {
  const Words words = words_of(request);
  const TechniqueRecipe& technique = technique_recipe(words.technique);
  Parameters scene_settings;
  Parameters technique_settings = technique.options();
  const SceneRecipe* recipe = words.has_toml ? nullptr : &scene_recipe(words.scene);
  if (recipe != nullptr) scene_settings = recipe->parameters();
  for (const std::string_view setting : words.settings)
    apply(setting, scene_settings, technique_settings);
  Setup setup;
  setup.scene = recipe != nullptr ? checked(recipe->build(scene_settings, Random(words.seed)))
                                  : parse_scene(words.toml, "scene.toml");
  setup.technique = technique.make(technique_settings, words.seed);
  return setup;
}

}  // namespace tumble::live
