/// \file
/// \brief The lists of scenes and techniques as JSON.
#include "catalogue.hpp"

#include "tumble/base/version.hpp"
#include "tumble/record/json.hpp"
#include "tumble/scenes/library.hpp"
#include "tumble/techniques.hpp"

#include "session.hpp"

namespace tumble::live {
namespace {

std::string_view name_of(ParameterKind kind) {
  switch (kind) {
    case ParameterKind::number: return "number";
    case ParameterKind::whole: return "whole";
    case ParameterKind::flag: return "flag";
    case ParameterKind::word: return "word";
    case ParameterKind::text: return "text";
  }
  return "text";
}

void write(const Parameters& settings, Json& out) {
  out.key("settings").begin_list();
  for (const Parameter& p : settings.all()) {
    out.begin();
    out.field("key", p.key).field("kind", name_of(p.kind)).field("value", p.value);
    out.field("unit", p.unit).field("meaning", p.meaning);
    if (p.kind == ParameterKind::number || p.kind == ParameterKind::whole)
      out.field("low", p.low).field("high", p.high);
    if (!p.choices.empty()) {
      out.key("choices").begin_list();
      for (const std::string& word : p.choices) out.item(word);
      out.end_list();
    }
    out.end();
  }
  out.end_list();
}

template <class Recipe>
Json& head(const Recipe& recipe, Json& out) {
  out.begin();
  return out.field("name", recipe.name)
      .field("section", recipe.section)
      .field("summary", recipe.summary);
}

}  // namespace

std::string catalogue() {
  Json out;
  out.begin();
  out.field("version", build_info().version).field("default_technique", kDefaultTechnique);
  out.key("numbers").begin_list();
  for (const std::string_view name : Session::number_names()) out.item(name);
  out.end_list();
  out.key("scenes").begin_list();
  for (const SceneRecipe& scene : scene_library()) {
    head(scene, out);
    write(scene.parameters(), out);
    out.end();
  }
  out.end_list();
  out.key("techniques").begin_list();
  for (const TechniqueRecipe& technique : technique_library()) {
    head(technique, out);
    write(technique.options(), out);
    out.end();
  }
  out.end_list();
  out.end();
  return out.text();
}

}  // namespace tumble::live
