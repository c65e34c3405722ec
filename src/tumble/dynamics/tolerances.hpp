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

/// [m] Largest edge of a body, and largest coordinate of a joint. Reason: squares of what a step makes of them, such as the
/// angular momentum of a body that gravity has moved for a step, stay within what a double holds. (3.1)
inline constexpr double largest_value = 1e20;

/// [-] Largest coordinate of a body at the start, in its shortest edges. Reason: there a double resolves a millionth of
/// the edge, and contacts are no better. (3.1)
inline constexpr double farthest = 1e10;

/// [m/s] Largest speed of any point of a body at the start; gravity leads at most to it within a second. Reason: the
/// speed of light, from which on Newton's laws say nothing. (3.1)
inline constexpr double largest_speed = 299792458.0;

/// [-] Largest coefficient of friction. Reason: a slope of 89.9999 degrees holds what lies on it, and six of the 16
/// digits of a double are used up in products of friction and normal forces. (3.3)
inline constexpr double largest_friction = 1e6;

/// [s] Shortest step. Reason: a box with the smallest mass and edge falls through its edge in some 1e-11 s. (3.1)
inline constexpr double shortest_step = 1e-15;

/// [s] Longest step. Reason: that of largest_value. (3.1)
inline constexpr double longest_step = 1e20;

/// [-] The time is resolved to this share of a step. Reason: it is, for as many steps as the command takes, 1e12. (3.1)
inline constexpr double step_share = 1e-3;

}  // namespace tumble::tolerance
