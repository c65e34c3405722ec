/// \file
/// \brief The figures on orders, work and forces of the glued column (thesis 6.2).
#pragma once

#include "driver/figure.hpp"

#include <vector>

namespace tumble::chapters {

/// The figures "claim_6_2b_order", "one_step_gap", "rotation_work", "claim_6_2e_steps", "pivot_forces" and
/// "swing_periods".
/// \return them
std::vector<Figure> integration_order_figures();

}  // namespace tumble::chapters
