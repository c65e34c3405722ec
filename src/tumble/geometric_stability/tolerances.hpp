/// \file
/// \brief The small numbers of `geometric_stability`.
#pragma once

namespace tumble::tolerance {

// --- geometric_stability ------------------------------------------------------------------

/// [-] Horizontal distance between a corner and a support point that still holds it, as a share of the body's
/// shortest edge. Reason: the lever arm is then shorter by a hundredth; boxes that stand edge on
/// edge differ by as much after they have been set upright. (5.4)
inline constexpr double corner_support = 1e-2;

/// [-] The same for boxes left out of the system of contact forces. Reason: as for exact_vertical; poses
/// of resting boxes differ by less. (5.4)
inline constexpr double exact_corner = 1e-6;

/// [-] Bodies are in equilibrium if their acceleration is less than this share of the one without
/// contacts. Reason: rounding leaves 1e-12 in a pile of a hundred boxes; thresholds are accurate to
/// about this share. (6.3.1)
inline constexpr double exact_balance = 1e-9;

/// [-] Bodies slower than this share of sqrt(gL) stand still. Reason: 3 nm/s for a box of 1 m, a
/// decimetre in a year; rounding leaves 1e-12. (6.3.1)
inline constexpr double standstill = 1e-9;

}  // namespace tumble::tolerance
