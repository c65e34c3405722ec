/// \file
/// \brief The figures of a program, each declared where it is measured.
#pragma once

#include "driver/figure.hpp"

#include <string_view>
#include <vector>

namespace tumble::chapters {

// Adds a figure to those of the program: a constant at the end of the source that measures it.
//
// \code
// const Registered zeno_figure{{.name = "zeno",
//                               .parameters = {number(...)},
//                               .quick = {"restitution=0.5"},
//                               .experiment = measure_zeno}};
// \endcode
// The order in which sources are linked does not matter.
class Registered {
 public:
  // Adds one figure.
  explicit Registered(Figure figure);

  // Adds figures that are made from lists, such as one for each scene.
  explicit Registered(std::vector<Figure> (*figures)());
};

// All figures of the program.
std::vector<Figure> registered_figures();

// One figure of the program.
Figure registered_figure(std::string_view name);

}  // namespace tumble::chapters
