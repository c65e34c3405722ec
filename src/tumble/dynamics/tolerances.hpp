/// \file
/// \brief The limits of masses and of what else describes a body and its motion, each with its reason.
#pragma once

namespace tumble::tolerance {

// --- masses -----------------------------------------------------------------------------

/// [kg] Largest mass of a body, and largest moment of inertia in kg m². Reason: products of six of them stay
/// within what a double holds. (3.1)
inline constexpr double largest_mass = 1e30;

/// [kg] Smallest mass of a body, and smallest moment of inertia in kg m². Reason: the same for their inverses. (3.1)
inline constexpr double smallest_mass = 1e-30;

/// [-] How many times as heavy as another one a movable body may be. Reason: of the 16 digits of a double
/// contact solvers need six for their stiffness; from 1e14 on momentum is lost. (6.3.1)
inline constexpr double largest_mass_ratio = 1e10;

// --- lengths and motion --------------------------------------------------------------------

/// [m] Smallest edge of a body. Reason: the same as of smallest_mass. (3.1)
inline constexpr double smallest_edge = 1e-20;

/// [m, m/s, rad/s, m/s², s] Largest edge, coordinate, speed, spin, gravity and time step of a scene, each in its SI unit.
/// Reason: squares of what a step makes of them, such as the angular momentum of a body that gravity has moved
/// for a step, stay within what a double holds. (3.1)
inline constexpr double largest_value = 1e20;

}  // namespace tumble::tolerance
