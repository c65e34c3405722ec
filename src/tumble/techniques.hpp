/// \file
/// \brief The techniques, by name.
#pragma once

#include "tumble/base/parameters.hpp"
#include "tumble/dynamics/technique.hpp"

#include <memory>
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

/// All techniques.
/// \return in the order in which `tumble techniques` lists them
const std::vector<TechniqueRecipe>& technique_library();

/// One technique.
/// \param name its name
/// \return the recipe
/// \throws std::invalid_argument listing the names if there is none of this name
const TechniqueRecipe& technique_recipe(std::string_view name);

}  // namespace tumble
