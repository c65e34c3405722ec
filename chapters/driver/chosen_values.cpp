/// \file
/// \brief Values that were chosen, read where they are defined.
#include "driver/chosen_values.hpp"

#include "tumble/scenes/library.hpp"
#include "tumble/techniques.hpp"

#include <algorithm>
#include <sstream>
#include <stdexcept>

namespace tumble::chapters {
namespace {

[[noreturn]] void refuse(const Choice& choice, const std::string& what) {
  throw std::invalid_argument(choice.place + "from: " + what);
}

ChosenValue setting(const Choice& choice, const Parameters& parameters, const std::string& owner,
                    const std::string& key) {
  for (const Parameter& one : parameters.all())
    if (one.key == key) return {key, one.value, one.unit, one.meaning};
  refuse(choice, owner + " has no setting '" + key + '\'');
}

ChosenValue constant(const Choice& choice, const std::vector<Tolerance>& constants,
                     const std::string& name) {
  const auto found =
      std::ranges::find_if(constants, [&](const Tolerance& one) { return one.name == name; });
  if (found == constants.end()) refuse(choice, "there is no constant '" + name + '\'');
  return {name, found->value, found->unit, found->meaning};
}

// A figure's parameter, "rows = 5 [-] of the pyramid".
ChosenValue parameter(const Choice& choice, const DrawnFigure& figure, const std::string& key) {
  if (figure.head.empty()) return {key, "", "-", "of the figure " + figure.name};
  for (const std::string& line : figure.parameters) {
    const std::size_t equals = line.find(" = ");
    const std::size_t unit = line.find(" [", equals);
    const std::size_t end = line.find("] ", unit);
    if (end == std::string::npos || line.substr(0, equals) != key) continue;
    return {key, line.substr(equals + 3, unit - equals - 3), line.substr(unit + 2, end - unit - 2),
            line.substr(end + 2)};
  }
  refuse(choice, "figure " + figure.name + " has no parameter '" + key + '\'');
}

// One source, "scene fig6_6: rows speed".
void append_source(const Choice& choice, const ValueSources& sources, const std::string& source,
                   std::vector<ChosenValue>& values) {
  const std::size_t colon = source.find(':');
  if (colon == std::string::npos) refuse(choice, '\'' + source + "' has no ':' before its keys");
  std::istringstream head(source.substr(0, colon));
  std::string kind;
  std::string name;
  head >> kind >> name;
  std::istringstream keys(source.substr(colon + 1));
  for (std::string key; keys >> key;) {
    try {
      if (kind == "scene") {
        values.push_back(setting(choice, scene_recipe(name).parameters(), name, key));
      } else if (kind == "technique") {
        values.push_back(setting(choice, technique_recipe(name).options(), name, key));
      } else if (kind == "constants") {
        values.push_back(constant(choice, sources.constants, key));
      } else if (kind == "figure") {
        const DrawnFigure* figure = figure_of(sources.figures, name);
        if (figure == nullptr) refuse(choice, "there is no figure '" + name + '\'');
        values.push_back(parameter(choice, *figure, key));
      } else {
        refuse(choice, '\'' + kind + "': give scene, technique, constants or figure");
      }
    } catch (const std::invalid_argument& error) {
      const std::string text = error.what();
      if (text.starts_with(choice.place)) throw;
      refuse(choice, text);  // a scene or technique that does not exist
    }
  }
}

}  // namespace

std::vector<ChosenValue> chosen_values(const Choice& choice, const ValueSources& sources) {
  std::vector<ChosenValue> values;
  std::istringstream parts(choice.from);
  for (std::string part; std::getline(parts, part, ';');)
    append_source(choice, sources, part, values);
  if (values.empty() && !choice.from.empty()) refuse(choice, "no keys are named");
  return values;
}

}  // namespace tumble::chapters
