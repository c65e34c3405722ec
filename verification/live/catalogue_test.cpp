/// \file
/// \brief The page's lists: every scene, technique and setting is in them, as it was declared.
#include "catalogue.hpp"

#include "tumble/base/version.hpp"

#include "live/json.hpp"
#include "session.hpp"
#include "support/test.hpp"

namespace {

using tumble::test::JsonReader;
using tumble::test::JsonValue;

void check(const JsonValue& list, const Parameters& settings) {
  REQUIRE(list.kind == '[');
  REQUIRE(list.items.size() == settings.all().size());
  for (std::size_t k = 0; k < list.items.size(); ++k) {
    const JsonValue& entry = list.items[k];
    const Parameter& parameter = settings.all()[k];
    INFO(parameter.key);
    CHECK(entry.at("key").text == parameter.key);
    CHECK(entry.at("value").text == parameter.value);
    CHECK(entry.at("unit").text == parameter.unit);
    CHECK(entry.at("meaning").text == parameter.meaning);
    const std::string& kind = entry.at("kind").text;
    const bool bounded = kind == "number" || kind == "whole";
    CHECK((parameter.kind == ParameterKind::number) == (kind == "number"));
    CHECK((parameter.kind == ParameterKind::whole) == (kind == "whole"));
    CHECK((parameter.kind == ParameterKind::flag) == (kind == "flag"));
    CHECK((parameter.kind == ParameterKind::word) == (kind == "word"));
    CHECK((parameter.kind == ParameterKind::text) == (kind == "text"));
    CHECK(entry.fields.count("low") == (bounded ? 1 : 0));
    CHECK(entry.fields.count("high") == (bounded ? 1 : 0));
    if (bounded) {
      CHECK(entry.at("low").number == parameter.low);
      CHECK(entry.at("high").number == parameter.high);
      CHECK(parameter.low <= parameter.high);
    }
    CHECK(entry.fields.count("choices") == (parameter.choices.empty() ? 0 : 1));
    for (std::size_t c = 0; c < parameter.choices.size(); ++c)
      CHECK(entry.at("choices").items.at(c).text == parameter.choices[c]);
    // The default is one of the values that are accepted.
    Parameters again = settings;
    CHECK_NOTHROW(again.set(entry.at("key").text, entry.at("value").text));
  }
}

template <class Library>
void check_library(const JsonValue& list, const Library& library,
                   const std::function<Parameters(std::size_t)>& settings) {
  REQUIRE(list.items.size() == library.size());
  for (std::size_t k = 0; k < library.size(); ++k) {
    INFO(library[k].name);
    const JsonValue& entry = list.items[k];
    CHECK(entry.at("name").text == library[k].name);
    CHECK(entry.at("section").text == library[k].section);
    CHECK(entry.at("summary").text == library[k].summary);
    CHECK(entry.fields.size() == 4);
    check(entry.at("settings"), settings(k));
  }
}

}  // namespace

TEST_CASE("The catalogue has every scene, technique and setting as it was declared",
          "[unit][live]") {
  const JsonValue all = JsonReader::read(live::catalogue());
  CHECK(all.at("version").text == build_info().version);
  CHECK(all.at("default_technique").text == kDefaultTechnique);
  check_library(all.at("scenes"), scene_library(),
                [](std::size_t k) { return scene_library()[k].parameters(); });
  check_library(all.at("techniques"), technique_library(),
                [](std::size_t k) { return technique_library()[k].options(); });
  const auto& names = live::Session::number_names();
  REQUIRE(all.at("numbers").items.size() == names.size());
  for (std::size_t k = 0; k < names.size(); ++k) CHECK(all.at("numbers").items[k].text == names[k]);
}
