/// \file
/// \brief The figures of impulses without damping: chatter, and the pass that ends overlap
///        (thesis 3.3.2, 4.4).
#pragma once

#include "driver/figure.hpp"

#include <vector>

namespace tumble::chapters {

/// Adds the figures of claims 3.3.2a, 4.4a and 4.4b.
/// \param list  gets "claim_3_3_2a_oscillation", "claim_4_4a_push_energy" and
///              "claim_4_4b_overlap_left"
void add_impulse_figures(std::vector<Figure>& list);

}  // namespace tumble::chapters
