/// \file
/// \brief Built-in scenes as worlds, for tests.
#pragma once

#include "tumble/scenes/library.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tumble::test {

// Settings of a scene or a technique, as a user writes them.
using Settings = std::vector<std::pair<std::string, std::string>>;

// A built-in scene.
inline Scene built(std::string_view name, const Settings& set = {}, std::uint64_t seed = 1) {
  const SceneRecipe& recipe = scene_recipe(name);
  Parameters p = recipe.parameters();
  for (const auto& [key, value] : set) p.set(key, value);
  return checked(recipe.build(p, Random(seed)));
}

// A built-in scene as a world.
inline World world_of(std::string_view name, const Settings& set = {}, std::uint64_t seed = 1) {
  return build_world(built(name, set, seed));
}

// The shape of a box of a scene.
inline Box shape_of(const SceneBox& box) {
  return make_box(box.position_w, box.orientation_wb, box.size);
}

}  // namespace tumble::test
