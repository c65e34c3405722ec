/// \file
/// \brief Orders, work and forces of the glued column's integration (thesis 6.2, claims 6.2b and 6.2e).
#pragma once

#include "driver/figure.hpp"

namespace tumble::chapters {

/// Claim 6.2b: error of the column's angle and gap in it against the step, and the gap constants of the
/// methods of first order.
///
/// An order is the slope of a straight line, by least squares in logarithms, through the four shortest
/// steps at which both errors are above `floor`: twenty times what rounding leaves.
/// \param settings  phi0, time, doublings, floor
/// \return tables "" (by step), "orders" (by scheme) and "constants" (by step); the claim's number
Result measure_glued_order(const Parameters& settings);

/// The gap that a single step from a state without one leaves, against the step.
/// \param settings  angle, spin, doublings
/// \return table "" (by step); gaps at 1/60 s
Result measure_one_step_gap(const Parameters& settings);

/// Errors of all schemes against the number of force solves.
/// \param settings  phi0, time, doublings
/// \return tables "" (by steps) and "adaptive" (by accuracy)
Result measure_rotation_work(const Parameters& settings);

/// Claim 6.2e: how many steps and force solves keep the column's gap small during its fall.
///
/// The gap is column_gap() after any step, whatever its sign. The number of steps is found by doubling
/// and then between whole numbers.
/// \param settings  phi0, time, gap
/// \return table "" (by scheme); the claim's number
Result measure_steps_for_gap(const Parameters& settings);

/// Forces at the pivot during the fall against the closed form.
/// \param settings  phi0, time, rate
/// \return tables "" (by time) and "marks"
Result measure_pivot_forces(const Parameters& settings);

/// Periods of boxes that swing on an edge against the closed form.
/// \param settings  accuracy
/// \return tables "" (by amplitude) and "exact" (the closed form at every degree)
Result measure_swing_periods(const Parameters& settings);

}  // namespace tumble::chapters
