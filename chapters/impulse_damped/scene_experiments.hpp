/// \file
/// \brief The thesis's own scenes under damped integration, drawn (thesis 1.1, 6.1).
#pragma once

#include "driver/figure.hpp"

#include <vector>

namespace tumble::chapters {

/// Adds the figures on friction, see add_friction_figures(), and those of scenes:
/// "fig6_6_projectile", "fig6_6_projectile_curves", "fig6_7_clump" and "crate_off_table".
/// \param list  gets them
void add_scene_figures(std::vector<Figure>& list);

/// Figure 6.6: a cube is shot at a pyramid.
/// \param settings  rows, height, speed, mass, appears, and the times of six frames
/// \return table "" (a row for each frame), six drawings; how the pyramid stands before the shot
Result measure_projectile(const Parameters& settings);

/// Energy, overlap and chatter of figure 6.6 over time.
/// \param settings  rows, height, speed, mass, appears, duration
/// \return table "" (a row for each step); the largest overlap, chatter before and after
Result measure_projectile_curves(const Parameters& settings);

/// Figure 6.7: cubes fly together and settle.
/// \param settings  per_edge, speed, duration
/// \return tables "" (chatter of each cube) and "bar" (the colours), two drawings; how much
///         chatter is left
Result measure_clump_settles(const Parameters& settings);

/// The crate of thesis 1.1: it slides off a table and tumbles.
/// \param settings  speed, damped_speed, friction, and the times of four frames
/// \return table "" (a row for each frame), eight drawings: damped first, then with Coulomb's
///         friction; how each ends
Result measure_crate(const Parameters& settings);

}  // namespace tumble::chapters
