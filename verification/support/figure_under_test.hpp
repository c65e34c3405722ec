/// \file
/// \brief A chapter's figure, computed small, and its numbers.
#pragma once

#include "driver/quick.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace tumble::chapters {

/// Runs a figure's experiment as --quick does.
class FigureUnderTest {
 public:
  /// Computes it.
  /// \param figures  a chapter's
  /// \param name     of the figure
  /// \param set      further settings, each as key=value
  FigureUnderTest(const std::vector<Figure>& figures, std::string_view name,
                  const std::vector<std::string>& set = {})
      : result(run_quickly(figures, name, set)) {}

  /// A number of the figure.
  /// \param quantity  its name
  /// \return its value
  [[nodiscard]] double number(std::string_view quantity) const {
    return quantity_of(result, quantity).value;
  }

  Result result;  ///< all that was computed
};

}  // namespace tumble::chapters
