/// \file
/// \brief Declaring, changing and reading settings.
#include "tumble/base/parameters.hpp"

#include "tumble/base/error.hpp"
#include "tumble/base/number_text.hpp"
#include "tumble/base/suggestion.hpp"

#include <algorithm>
#include <cmath>

namespace tumble {
namespace {

std::string list_of(const std::vector<std::string>& words) {
  std::string out;
  for (const std::string& word : words) out += (out.empty() ? "" : ", ") + word;
  return out;
}

// What is wrong with a value, empty if nothing is.
std::string complaint(const Parameter& p, std::string_view value) {
  if (p.kind == ParameterKind::text) return value.empty() ? "expected a text" : "";
  if (p.kind == ParameterKind::flag)
    return value == "on" || value == "off" ? "" : "expected on or off";
  if (p.kind == ParameterKind::word) {
    const bool known = std::find(p.choices.begin(), p.choices.end(), value) != p.choices.end();
    return known ? "" : "expected one of: " + list_of(p.choices);
  }
  const std::optional<double> number = parse_number(value);
  const bool whole = p.kind == ParameterKind::number || number == std::floor(number.value_or(0.0));
  if (number && whole && number >= p.low && number <= p.high) return "";
  return std::string("expected a ") + (p.kind == ParameterKind::whole ? "whole " : "") +
         "number from " + shortest_text(p.low) + " to " + shortest_text(p.high) +
         (p.unit == "-" ? "" : " " + p.unit);
}

}  // namespace

namespace declare {

Parameter number(std::string key, double initial, double low, double high, std::string unit,
                 std::string meaning) {
  return {.key = std::move(key),
          .kind = ParameterKind::number,
          .value = shortest_text(initial),
          .unit = std::move(unit),
          .meaning = std::move(meaning),
          .low = low,
          .high = high};
}

Parameter whole(std::string key, std::int64_t initial, std::int64_t low, std::int64_t high,
                std::string meaning) {
  return {.key = std::move(key),
          .kind = ParameterKind::whole,
          .value = std::to_string(initial),
          .meaning = std::move(meaning),
          .low = static_cast<double>(low),
          .high = static_cast<double>(high)};
}

Parameter flag(std::string key, bool initial, std::string meaning) {
  return {.key = std::move(key),
          .kind = ParameterKind::flag,
          .value = initial ? "on" : "off",
          .meaning = std::move(meaning),
          .choices = {"on", "off"}};
}

Parameter word(std::string key, std::vector<std::string> choices, std::string meaning) {
  return {.key = std::move(key),
          .kind = ParameterKind::word,
          .value = choices.front(),
          .meaning = std::move(meaning),
          .choices = std::move(choices)};
}

Parameter text(std::string key, std::string initial, std::string meaning) {
  return {.key = std::move(key),
          .kind = ParameterKind::text,
          .value = std::move(initial),
          .meaning = std::move(meaning)};
}

}  // namespace declare

void Parameters::set(std::string_view key, std::string_view value) {
  for (Parameter& p : items_) {
    if (p.key != key) continue;
    const std::string wrong = complaint(p, value);
    require::that(wrong.empty(), p.key + " = " + std::string(value) + ": " + wrong);
    p.value = value;
    return;
  }
  std::vector<std::string_view> keys;
  for (const Parameter& p : items_) keys.push_back(p.key);
  refuse("unknown setting " + std::string(key) + ": " +
         (keys.empty() ? "there are none" : expected_names(key, keys)));
}

void Parameters::assign(std::string_view setting) {
  const std::size_t equals = setting.find('=');
  require::that(equals != std::string_view::npos, std::string(setting) + ": expected key=value");
  set(setting.substr(0, equals), setting.substr(equals + 1));
}

bool Parameters::has(std::string_view key) const {
  return std::any_of(items_.begin(), items_.end(),
                     [&](const Parameter& p) { return p.key == key; });
}

const Parameter& Parameters::get(std::string_view key) const {
  for (const Parameter& p : items_) {
    if (p.key == key) return p;
  }
  refuse("no setting was declared as " + std::string(key));
}

double Parameters::number(std::string_view key) const {
  return parse_number(get(key).value).value();  // set() has looked
}

std::int64_t Parameters::whole(std::string_view key) const {
  return static_cast<std::int64_t>(number(key));
}

bool Parameters::flag(std::string_view key) const { return get(key).value == "on"; }

const std::string& Parameters::word(std::string_view key) const { return get(key).value; }

}  // namespace tumble
