/// \file
/// \brief Figures on exterior rotation under every technique of the library (thesis 6.2).
#pragma once

#include "driver/figure.hpp"

#include <vector>

namespace tumble::chapters {

/// The figures: gaps by technique and scene, and why they differ.
/// \return in the order of the page
std::vector<Figure> technique_figures();

}  // namespace tumble::chapters
