/// \file
/// \brief The figures on the order of collisions: figure 5.1, and the queue at work.
#pragma once

#include "driver/figure.hpp"

#include <vector>

namespace tumble::chapters {

/// Figure 5.1 and the queue of collisions.
/// \return both figures
std::vector<Figure> order_figures();

}  // namespace tumble::chapters
