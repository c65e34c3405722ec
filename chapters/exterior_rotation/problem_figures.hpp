/// \file
/// \brief Figures 6.1 to 6.3 of the thesis, and whether the trouble is turning (thesis 6.2).
#pragma once

#include "driver/figure.hpp"

#include <vector>

namespace tumble::chapters {

/// The problem shown: fig6_1_column, fig6_2_one_box, fig6_3_nested, claim_6_2a_turning.
/// \return the figures, in the order of the page
std::vector<Figure> problem_figures();

}  // namespace tumble::chapters
