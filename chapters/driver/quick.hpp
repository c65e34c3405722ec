/// \file
/// \brief Running a figure small and asking for a number of it, as tests do.
#pragma once

#include "driver/played_scene.hpp"
#include "driver/registry.hpp"

#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tumble::chapters {

// Computes a figure with its quick settings.
inline Result run_quickly(const Figure& figure, const std::vector<std::string>& set = {}) {
  Parameters settings = figure.parameters;
  set_all(settings, figure.quick);
  set_all(settings, set);
  return figure.experiment(settings);
}

// One number of a figure.
inline const Quantity& quantity_of(const Result& result, std::string_view name) {
  for (const Quantity& quantity : result.quantities)
    if (quantity.name == name) return quantity;
  throw std::invalid_argument("no quantity " + std::string(name));
}

// A column of a table; empty if it has none of this name.
inline std::vector<double> column_of(const Table& table, std::string_view name) {
  std::vector<double> numbers;
  for (std::size_t k = 0; k < table.columns.size(); ++k)
    if (table.columns[k].name == name)
      for (const std::vector<double>& row : table.rows) numbers.push_back(row[k]);
  return numbers;
}

// A figure's experiment as --quick runs it, or with other settings: once in a program, however many tests look at it.
class FigureUnderTest {
 public:
  // Computes a figure of the program.
  explicit FigureUnderTest(std::string_view name, const std::vector<std::string>& set = {})
      : result(result_of(std::string(name), set)) {}

  // A number of the figure.
  [[nodiscard]] double number(std::string_view quantity) const {
    return quantity_of(result, quantity).value;
  }

  const Result& result;  // all that was computed

 private:
  static const Result& result_of(const std::string& name, const std::vector<std::string>& set) {
    static std::map<std::pair<std::string, std::vector<std::string>>, Result> results;
    const auto found = results.find({name, set});
    if (found != results.end()) return found->second;
    return results[{name, set}] = run_quickly(registered_figure(name), set);
  }
};

}  // namespace tumble::chapters
