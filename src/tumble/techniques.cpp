/// \file
/// \brief The list of techniques.
#include "tumble/techniques.hpp"

#include "tumble/base/error.hpp"
#include "tumble/base/suggestion.hpp"
#include "tumble/basic_colliding/basic.hpp"

#include <string>

namespace tumble {
namespace {

Parameters basic_options() {
  const BasicOptions standard;
  Parameters p;
  p.add_number("resolution", standard.resolution, 1e-15, 1.0, "s",
               "how exactly the moment of an impact is searched for");
  p.add_whole("event_cap", standard.event_cap, 1, 1000000, "collisions allowed in one step");
  p.add_word("impacts", {"simultaneous", "sequential"},
             "how collisions at the same moment are resolved");
  p.add_word("search", {"discrete", "conservative"},
             "look at the end of a step only (thesis 3.2), or never pass a contact");
  p.add_word("rotation", {"splitting", "frozen", "midpoint", "rk4"}, "how bodies turn in flight");
  return p;
}

std::unique_ptr<Technique> make_basic(const Parameters& p, std::uint64_t) {
  BasicOptions options;
  options.resolution = p.number("resolution");
  options.event_cap = p.count("event_cap");
  options.impacts =
      p.word("impacts") == "simultaneous" ? ImpactOrder::simultaneous : ImpactOrder::sequential;
  options.search =
      p.word("search") == "discrete" ? SearchMethod::discrete : SearchMethod::conservative;
  options.rotation = rotation_rule_from(p.word("rotation"));
  return std::make_unique<Basic>(options);
}

}  // namespace

const std::vector<TechniqueRecipe>& technique_library() {
  static const std::vector<TechniqueRecipe> library = {
      {"basic", "2.1", "advance, find an overlap, search back for the impact, resolve, go on",
       basic_options, make_basic},
  };
  return library;
}

const TechniqueRecipe& technique_recipe(std::string_view name) {
  std::vector<std::string_view> names;
  for (const TechniqueRecipe& recipe : technique_library()) {
    if (recipe.name == name) return recipe;
    names.push_back(recipe.name);
  }
  require::that(false,
                "unknown technique " + std::string(name) + ": " + expected_names(name, names));
  return technique_library().front();  // not reached
}

}  // namespace tumble
