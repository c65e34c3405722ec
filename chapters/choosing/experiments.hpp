/// \file
/// \brief The figures of the page on choosing a technique.
#pragma once

#include "driver/figure.hpp"

#include <vector>

namespace tumble::chapters {

/// All figures of this page, in its order.
/// \return each with its parameters, their defaults, and the function that computes it
std::vector<Figure> choosing_figures();

}  // namespace tumble::chapters
