/// \file
/// \brief The limits of masses, each with its reason.
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

}  // namespace tumble::tolerance
