/// \file
/// \brief What is measured for the chapter on basic colliding and for the layers below it.
#pragma once

#include "driver/figure.hpp"

#include <vector>

namespace tumble::chapters {

/// All figures of this chapter, in the order of the page.
/// \return each with its parameters, their defaults, and the function below that computes it
std::vector<Figure> basic_colliding_figures();

/// A tumbling box under each rotation rule beside Euler's exact solution (thesis 3.1).
///
/// The box is spun about its middle axis, which is unstable, and turns over again and again. The
/// exact angular velocity is made of Jacobi's elliptic functions.
/// \param settings  step, duration
/// \return tables "" (middle angular velocity and energy error over time) and "flips" (error of the
///         first flip for each step and rule); the first flip and the largest errors
Result measure_rotation_rules(const Parameters& settings);

/// The error of each rotation rule against the step (thesis 3.1).
/// \param settings  time, halvings
/// \return table "" (angle from the true orientation); the measured orders
Result measure_rotation_order(const Parameters& settings);

/// The error of a fall under forward Euler, semi-implicit Euler and ballistic flight (thesis 3.1).
/// \param settings  height, duration, halvings
/// \return table "" (error of the height for each step); the measured orders and errors
Result measure_free_fall(const Parameters& settings);

/// A ball-like drop of a box with ever smaller bounces (thesis 4.3).
/// \param settings  height, restitution, threshold
/// \return tables "" (height over time) and "impacts" (time and rebound speed of each impact beside
///         the closed form); the number of bounces and the time until the rebound is slow
Result measure_zeno(const Parameters& settings);

/// Newton's cradle, with all impulses at once and one after the other (thesis 3.2).
/// \param settings  boxes, moving, restitution
/// \return table "" (velocity of each box before and after, in both readings); energies and errors
Result measure_cradle(const Parameters& settings);

/// How many passes one-contact-at-a-time needs for a stack (thesis 3.3).
/// \param settings  most, accuracy
/// \return table "" (passes against the height of the stack beside the closed form); some of them
Result measure_stack_convergence(const Parameters& settings);

/// The contact area of a cube that stands turned on another one (thesis 3.2).
/// \param settings  size, steps
/// \return tables "" (area and number of contact points against the angle) and "polygons" (three of
///         the areas); the largest error
Result measure_box_overlap(const Parameters& settings);

}  // namespace tumble::chapters
