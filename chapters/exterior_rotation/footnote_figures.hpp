/// \file
/// \brief The figures on the footnote of thesis 6.2: joints without glue.
#pragma once

#include "driver/figure.hpp"

#include <vector>

namespace tumble::chapters {

/// The figures "joint_openings", "event_order" and "claim_6_2f_wrong_contacts".
/// \return them
std::vector<Figure> footnote_figures();

}  // namespace tumble::chapters
