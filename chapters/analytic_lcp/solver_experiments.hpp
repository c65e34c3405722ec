/// \file
/// \brief What is measured of solvers for contact forces: their work, their tolerance, what drifts (thesis
///        2.6.2, 3.3.1, 5.3).
#pragma once

#include "driver/figure.hpp"

namespace tumble::chapters {

/// Multiplications of least constraint and of contact forces against contacts per body (thesis 2.6.2).
/// \param settings  most, seeds
/// \return a row for each number of contacts; from where on least constraint wins, chains of ten boxes
///         deciding
/// \throws std::runtime_error if a problem is not solved
Result measure_least_constraint(const Parameters& settings);

/// Multiplications per pivot with friction and new factors, without friction and with updated ones
/// (thesis 5.3).
/// \param settings  friction, seeds
/// \return a row for 8 to 64 contacts: unknowns, entries of the matrix, work; the ratio at 64
/// \throws std::runtime_error if a problem is not solved
Result measure_friction_cost(const Parameters& settings);

/// How the loop of the thesis's program ends, for tolerances from 0 to 1e-3 m/s² (thesis 3.3.1).
/// \param settings  problems
/// \return tables "" (stacks of cubes on four corners) and "repeated" (contacts given twice): endings
///         and pivots for each tolerance; the share that needs it; what zeroing forces does
Result measure_tolerance(const Parameters& settings);

/// Depth against time of cubes at rest whose contact forces come from the thesis's program (thesis 3.3.1).
/// \param settings  duration, cubes
/// \return a row for each moment, a column for each run: negative forces left, or set to zero, and a load
///         below the tolerance; the exponents
/// \throws std::runtime_error if a problem is not solved
Result measure_negative_forces(const Parameters& settings);

}  // namespace tumble::chapters
