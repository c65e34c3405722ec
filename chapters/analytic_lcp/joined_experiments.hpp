/// \file
/// \brief What the joined simulator, impacts in the order of time and analytic contact forces, is
///        measured on (thesis 3.3.1, 4.3).
#pragma once

#include "driver/figure.hpp"

#include <string>

namespace tumble::chapters {

/// A number as a setting has it.
/// \param value  any finite number
/// \return 17 significant digits
std::string setting_text(double value);

/// Bounce, sticky collision, rest, sliding and toppling in one world (thesis 3.3.1; claim 3.3.1d).
/// \param settings  step, duration
/// \return table "" (what each body does over time); how many of the five phases are passed, and the
///         numbers that decide each
Result measure_joined(const Parameters& settings);

/// What exact impact times cost against time stepping at equal error (thesis 3.3.1; claim 3.3.1e).
/// \param settings  cubes, duration, restitution, accepted, finest
/// \return tables "" (work and error of each step length) and "cubes" (the ratio against the number
///         of cubes); the ratio
Result measure_exact_times(const Parameters& settings);

/// Collisions until rest, with and without sticky ones (thesis 4.3; claim 4.3a).
/// \param settings  height, restitution, seeds
/// \return tables "" (collisions and work against the threshold) and "flat" (a flat drop beside its
///         closed form); the ratio, with intervals
Result measure_sticky(const Parameters& settings);

/// Bounces that are seen if every collision is sticky (thesis 4.3; claim 4.3b).
/// \param settings  height, restitution, seeds
/// \return tables "" (bounces and travel of each seed) and "path" (height of one die over time); the
///         ratio, with intervals
Result measure_all_sticky(const Parameters& settings);

}  // namespace tumble::chapters
