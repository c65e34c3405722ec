/// \file
/// \brief A technique of the list by its name.
#include "tumble/base/error.hpp"
#include "tumble/base/suggestion.hpp"
#include "tumble/techniques.hpp"

namespace tumble {

const TechniqueRecipe& technique_recipe(std::string_view name) {
  std::vector<std::string_view> names;
  for (const TechniqueRecipe& recipe : technique_library()) {
    if (recipe.name == name) return recipe;
    names.push_back(recipe.name);
  }
  refuse("unknown technique " + std::string(name) + ": " + expected_names(name, names));
}

std::unique_ptr<Technique> make_technique(std::string_view name,
                                          const std::vector<std::string>& settings,
                                          std::uint64_t seed) {
  const TechniqueRecipe& recipe = technique_recipe(name);
  Parameters options = recipe.options();
  for (const std::string& setting : settings) options.assign(setting);
  return recipe.make(options, seed);
}

}  // namespace tumble
