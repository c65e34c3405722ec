/// \file
/// \brief The figures of a program, each declared where it is measured.
#pragma once

#include "driver/figure.hpp"

#include <string_view>
#include <vector>

namespace tumble::chapters {

/// Adds a figure to those of the program: a constant at the end of the source that measures it.
///
/// \code
/// const Registered free_fall_figure{{.name = "free_fall",
///                                    .parameters = Parameters{}.add_number(...),
///                                    .quick = {"halvings=4"},
///                                    .experiment = measure_free_fall}};
/// \endcode
/// The order in which sources are linked does not matter.
class Registered {
 public:
  /// Adds one figure.
  /// \param figure  without section, title and caption, which stand in figures.toml
  explicit Registered(Figure figure);

  /// Adds figures that are made from lists, such as one for each scene.
  /// \param figures  makes them when they are first asked for
  explicit Registered(std::vector<Figure> (*figures)());
};

/// All figures of the program.
/// \return sorted by name, without section, title and caption
/// \throws std::invalid_argument if two have one name
std::vector<Figure> registered_figures();

/// One figure of the program.
/// \param name  of the figure
/// \return it, without section, title and caption
/// \throws std::invalid_argument if there is none
Figure registered_figure(std::string_view name);

}  // namespace tumble::chapters
