/// \file
/// \brief The figures on towers, balance and thresholds (thesis 6.3.1).
#pragma once

#include "driver/figure.hpp"

#include <vector>

namespace tumble::chapters {

/// Figures 6.4 and 6.5 of the thesis, claim 6.3.1d, and what friction leaves open.
/// \return "fig6_4_one_block", "fig6_5_heavy_top", "claim_6_3_1d_equilibrium" and "weakly_stable"
std::vector<Figure> balance_figures();

}  // namespace tumble::chapters
