/// \file
/// \brief The techniques, by name.
#pragma once

#include "tumble/base/parameters.hpp"
#include "tumble/dynamics/technique.hpp"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace tumble {

/// A technique that a user can name.
struct TechniqueRecipe {
  std::string_view name;     ///< what a user calls it
  std::string_view section;  ///< thesis sections
  std::string_view summary;  ///< one line
  /// Declares its options with their defaults.
  Parameters (*options)();
  /// Makes it; `seed` is used by techniques with chance in them and by no others.
  std::unique_ptr<Technique> (*make)(const Parameters& options, std::uint64_t seed);
};

/// The technique of a run that names none.
inline constexpr std::string_view kDefaultTechnique = "contact_damped";

/// All techniques, in the order in which `tumble techniques` lists them.
const std::vector<TechniqueRecipe>& technique_library();

/// The recipe of a technique.
/// \throws std::invalid_argument listing the names if there is none of this name
const TechniqueRecipe& technique_recipe(std::string_view name);

/// A technique with some of its options changed.
/// \param settings  each as key=value
/// \throws std::invalid_argument for a name, a key or a value that does not exist
std::unique_ptr<Technique> make_technique(std::string_view name,
                                          const std::vector<std::string>& settings = {},
                                          std::uint64_t seed = 1);

}  // namespace tumble
