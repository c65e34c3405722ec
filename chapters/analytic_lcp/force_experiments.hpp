/// \file
/// \brief What is measured to show what contact forces are, how pivoting finds them, and where there
///        are none.
#pragma once

#include "driver/figure.hpp"

namespace tumble::chapters {

/// The forces in a pyramid of bricks: on feet, where they are determined, and on full faces, where
/// only a range of them is (thesis 2.6, 3.3.1).
/// \param settings  rows, spacing
/// \return tables "" (a row for each pair of faces: its force on feet; on full faces the smallest, the
///         largest and those of four solvers), "bricks" and "feet"; the loads of the lowest row, errors
/// \throws std::runtime_error if a solver fails
Result measure_pyramid_forces(const Parameters& settings);

/// Baraff's algorithm as the thesis describes it, step by step on two planks with five contacts
/// (thesis 3.3.1).
/// \param settings  centre, post
/// \return tables "" (the set of each contact in each step, and what ended the step), "path" (forces
///         and accelerations after each step), "bodies" and "contacts"; the forces beside their
///         closed form
/// \throws std::runtime_error if the algorithm fails
Result measure_index_sets(const Parameters& settings);

/// Painlevé's rod: how many forces obey the laws of contact and friction, and what a time step does
/// (thesis 2.6.3).
/// \param settings  spin, step, friction_steps
/// \return tables "" (what a time step does, over angle and friction), "still" and "spinning" (the
///         number of solutions over angle and friction), "boundary" (its closed form), "least" (its lowest point) and "impulses"
///         (against the time step); the numbers of rods at 60 degrees
Result measure_painleve_map(const Parameters& settings);

}  // namespace tumble::chapters
