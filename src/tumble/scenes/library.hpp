/// \file
/// \brief The built-in scenes, by name.
#pragma once

#include "tumble/base/parameters.hpp"
#include "tumble/base/random.hpp"
#include "tumble/scenes/scene.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace tumble {

/// A built-in scene.
struct SceneRecipe {
  std::string_view name;     ///< its name in commands
  std::string_view section;  ///< thesis sections that it belongs to
  std::string_view summary;  ///< one line
  /// Declares its parameters with their defaults.
  Parameters (*parameters)();
  /// Builds it; `random` is used only by scenes with randomness.
  Scene (*build)(const Parameters& parameters, Random random);
};

/// All built-in scenes, in the order in which `tumble scenes` lists them.
const std::vector<SceneRecipe>& scene_library();

/// One built-in scene.
/// \throws std::invalid_argument listing the names if there is none of this name
const SceneRecipe& scene_recipe(std::string_view name);

/// A built-in scene with some of its parameters changed.
/// \param settings  each as key=value
/// \throws std::invalid_argument for a name, a key or a value that does not exist
Scene make_scene(std::string_view name, const std::vector<std::string>& settings = {},
                 std::uint64_t seed = 1);

}  // namespace tumble
