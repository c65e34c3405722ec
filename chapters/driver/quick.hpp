/// \file
/// \brief Running a figure small and asking for a number of it, as tests do.
#pragma once

#include "driver/registry.hpp"
#include "driver/settings.hpp"

#include <stdexcept>
#include <string>
#include <string_view>
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

// Runs a figure's experiment as --quick does.
class FigureUnderTest {
 public:
  // Computes a figure of the program.
  explicit FigureUnderTest(std::string_view name, const std::vector<std::string>& set = {})
      : result(run_quickly(registered_figure(name), set)) {}

  // A number of the figure.
  [[nodiscard]] double number(std::string_view quantity) const {
    return quantity_of(result, quantity).value;
  }

  Result result;  // all that was computed
};

}  // namespace tumble::chapters
