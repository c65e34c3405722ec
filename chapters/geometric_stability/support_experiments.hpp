/// \file
/// \brief Figures 5.3 to 5.5: which lower corners of a box are carried (thesis 5.4).
#pragma once

#include "driver/figure.hpp"

#include <vector>

namespace tumble::chapters {

/// The figures "fig5_3_one_corner", "fig5_4_all_corners" and "fig5_5_two_supports".
/// \return in this order
std::vector<Figure> support_figures();

/// Figure 5.3: a cube of which one corner is on another cube; then shifted further and further.
/// \param settings  shift, yaw, load, shifts
/// \return tables "" (lower corners of the top box), "points", "outlines" (as seen from above) and
///         "shifts" (accelerations against the shift); verdicts of both rules, accelerations by the
///         whole complementarity problem; drawings "boxes" and "told"
Result measure_one_corner(const Parameters& settings);

/// Figure 5.4: a cube whole on a larger box.
/// \param settings  offset, load
/// \return as of measure_one_corner(), with the verdict if nothing were under the bottom box, and
///         without the shifts
Result measure_all_corners(const Parameters& settings);

/// Figure 5.5: a box across two others.
/// \param settings  gap, yaw, load
/// \return as of measure_all_corners(), with the verdict if nothing were under the left box
Result measure_two_supports(const Parameters& settings);

}  // namespace tumble::chapters
