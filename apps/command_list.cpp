/// \file
/// \brief `tumble scenes`, `tumble techniques`, `tumble filters` and `tumble lcp --list`.
#include "tumble/base/error.hpp"
#include "tumble/base/number_text.hpp"
#include "tumble/filtering/filters.hpp"
#include "tumble/lcp_solvers/lcp.hpp"
#include "tumble/scenes/library.hpp"
#include "tumble/scenes/scene_file.hpp"
#include "tumble/techniques.hpp"

#include "request.hpp"

#include <algorithm>
#include <cstdio>
#include <span>
#include <string>
#include <vector>

namespace tumble::app {
namespace {

int width(std::string_view text) { return static_cast<int>(text.size()); }

std::string range_of(const Parameter& p) {
  if (p.kind == ParameterKind::number || p.kind == ParameterKind::whole)
    return shortest_text(p.low) + " to " + shortest_text(p.high);
  std::string words;
  for (const std::string& word : p.choices) words += (words.empty() ? "" : "|") + word;
  return words;
}

constexpr std::size_t kRangeWidth = 30;
constexpr std::size_t kSummaryWidth = 72;
constexpr std::size_t kWidth = 110;  // of a table of settings

// A text in lines of at most so many characters where it can be broken behind one of the separators.
std::vector<std::string> wrapped(std::string_view text, std::string_view separators,
                                 std::size_t most) {
  std::vector<std::string> lines = {""};
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find_first_of(separators, begin), text.size() - 1) + 1;
    if (!lines.back().empty() && lines.back().size() + end - begin > most) lines.emplace_back();
    lines.back().append(text, begin, end - begin);
    begin = end;
  }
  return lines;
}

// The widths of two columns in front of summaries.
struct Columns {
  int first = 0, second = 0;

  void fit(std::string_view name, std::string_view text) {
    first = std::max(first, width(name));
    second = std::max(second, width(text));
  }
};

void print_line(std::string_view name, std::string_view second, std::string_view summary,
                const Columns& columns) {
  for (std::string line : wrapped(summary, " ", kSummaryWidth)) {
    line.erase(line.find_last_not_of(' ') + 1);
    std::printf("%-*.*s  %-*.*s  %s\n", columns.first, width(name), name.data(), columns.second,
                width(second), second.data(), line.c_str());
    name = second = "";
  }
}

// All entries of a library, or one, each with its section of the thesis.
template <class Library>
void print_lines(const Library& library) {
  Columns columns;
  for (const auto& entry : library) columns.fit(entry.name, entry.section);
  for (const auto& entry : library) print_line(entry.name, entry.section, entry.summary, columns);
}

void print_settings(const Parameters& settings) {
  if (settings.all().empty()) std::printf("  (no settings)\n");
  std::size_t key = 3;
  std::size_t value = 7;
  std::size_t unit = 4;
  std::size_t range = 5;
  for (const Parameter& p : settings.all()) {
    key = std::max(key, p.key.size());
    value = std::max(value, p.value.size());
    unit = std::max(unit, p.unit.size());
    for (const std::string& line : wrapped(range_of(p), "|", kRangeWidth))
      range = std::max(range, line.size());
  }
  constexpr std::size_t least = 30;
  const std::size_t before = key + value + unit + range + 10;  // with the gaps
  const std::size_t meaning = before + least < kWidth ? kWidth - before : least;
  const auto row = [&](const std::string& k, const std::string& v, const std::string& u,
                       const std::string& r, const std::string& m) {
    std::string line;
    const auto column = [&](const std::string& text, std::size_t width) {
      line.append("  ").append(text).append(std::max(width, text.size()) - text.size(), ' ');
    };
    column(k, key);
    column(v, value);
    column(u, unit);
    column(r, range);
    column(m, 0);
    line.erase(line.find_last_not_of(' ') + 1);
    std::printf("%s\n", line.c_str());
  };
  row("key", "default", "unit", "range", "meaning");
  for (const Parameter& p : settings.all()) {
    const std::vector<std::string> ranges = wrapped(range_of(p), "|", kRangeWidth);
    const std::vector<std::string> meanings = wrapped(p.meaning, " ,", meaning);
    for (std::size_t k = 0; k < std::max(ranges.size(), meanings.size()); ++k)
      row(k == 0 ? p.key : "", k == 0 ? p.value : "", k == 0 ? p.unit : "",
          k < ranges.size() ? ranges[k] : "", k < meanings.size() ? meanings[k] : "");
  }
}

}  // namespace

int list_scenes(const std::string& name, bool as_toml, const std::vector<std::string>& settings,
                std::uint64_t seed) {
  if (name.empty()) {
    require::that(!as_toml && settings.empty(), "--toml and --set need the name of a scene");
    print_lines(scene_library());
    return kDone;
  }
  const SceneRecipe& recipe = scene_recipe(name);
  Parameters parameters = recipe.parameters();
  Parameters no_technique;
  apply(settings, parameters, no_technique);
  if (as_toml) {
    std::printf("%s", to_toml(checked(recipe.build(parameters, Random(seed)))).c_str());
    return kDone;
  }
  print_lines(std::span(&recipe, 1));
  print_settings(parameters);
  return kDone;
}

int list_techniques(const std::string& name) {
  if (name.empty()) {
    print_lines(technique_library());
    return kDone;
  }
  const TechniqueRecipe& recipe = technique_recipe(name);
  print_lines(std::span(&recipe, 1));
  print_settings(recipe.options());
  return kDone;
}

int list_filters() {
  Columns columns;
  for (const FilterRecipe& f : filter_library()) columns.fit(f.name, f.form);
  for (const FilterRecipe& f : filter_library()) print_line(f.name, f.form, f.summary, columns);
  return kDone;
}

int list_lcp_solvers() {
  print_lines(lcp_solvers());
  return kDone;
}

}  // namespace tumble::app
