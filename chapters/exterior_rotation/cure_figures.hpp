/// \file
/// \brief The cure: bodies moved by one twist each, and what it leaves (thesis 6.2).
#pragma once

#include "driver/figure.hpp"

#include <vector>

namespace tumble::chapters {

/// The figures on the cure: "claim_6_2d_one_twist", "twist_any_step", "claim_6_2c_one_pivot",
/// "which_centre".
/// \return them, in the order of the page
std::vector<Figure> cure_figures();

/// Claim 6.2d: the column of figure 6.1 with forces held over a step, each body moved by one twist.
/// \param settings  angle, rate, duration
/// \return tables "" (by time: gaps with centre and orientation moved apart, and by one twist) and
///         "angles" (by scheme: error of the column's angle, both ways); the claim's number
Result measure_one_twist(const Parameters& settings);

/// The same at any step, in the plane, on a ball joint, and in free flight.
/// \param settings  angle, spin, duration, coarsest, finest, steps
/// \return table "" (by step: gaps, errors of angles, of the path of a group in flight); orders
Result measure_any_step(const Parameters& settings);

/// Claim 6.2c: what one rotation for the whole group leaves in figure 6.3, and one for each body.
/// \param settings  rate, steps, spins
/// \return tables "" (by spins and step: the joint's mismatch, measured and predicted) and "spins" (by the
///         upper box's spin: what each way of moving leaves in a step); the claim's number
Result measure_one_pivot(const Parameters& settings);

/// Which point a body that sticks, slides or flies has to be turned about.
/// \param settings  spin, speed, tilt, steps
/// \return table "" (by situation, centre and step: gap and bend, measured and predicted)
Result measure_which_centre(const Parameters& settings);

}  // namespace tumble::chapters
