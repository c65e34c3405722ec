/// \file
/// \brief Settings as a command line has them, for experiments and tests.
#pragma once

#include "tumble/base/parameters.hpp"
#include "tumble/techniques.hpp"

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace tumble::chapters {

/// Changes several parameters.
/// \param parameters  in and out
/// \param settings    each as key=value
/// \throws std::invalid_argument as Parameters::set()
inline void set_all(Parameters& parameters, const std::vector<std::string>& settings) {
  for (const std::string_view setting : settings) {
    const std::size_t equals = setting.find('=');
    parameters.set(setting.substr(0, equals), setting.substr(equals + 1));
  }
}

/// A technique of the library with some of its options changed.
/// \param name      for example "analytic"
/// \param settings  each as key=value
/// \param seed      of everything random
/// \return the technique
/// \throws std::invalid_argument for a name, a key or a value that there is not
inline std::unique_ptr<Technique> technique_with(std::string_view name,
                                                 const std::vector<std::string>& settings = {},
                                                 std::uint64_t seed = 1) {
  const TechniqueRecipe& recipe = technique_recipe(name);
  Parameters options = recipe.options();
  set_all(options, settings);
  return recipe.make(options, seed);
}

}  // namespace tumble::chapters
