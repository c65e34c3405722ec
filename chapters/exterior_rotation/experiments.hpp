/// \file
/// \brief The figures of the chapter on exterior rotation.
#pragma once

#include "driver/figure.hpp"

#include <vector>

namespace tumble::chapters {

/// All figures of this chapter, in the order of the page.
/// \return each with its parameters, their defaults, and the function that computes it
std::vector<Figure> exterior_rotation_figures();

}  // namespace tumble::chapters
