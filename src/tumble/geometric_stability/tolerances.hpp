/// \file
/// \brief The small numbers of `geometric_stability`.
#pragma once

namespace tumble::tolerance {

// --- geometric_stability ------------------------------------------------------------------

/// [-] How far a support may miss a corner sideways and still hold it, as a share of the body's
/// shortest edge. Reason: the lever of what is held then is shorter by a hundredth; boxes that
/// stand edge on edge differ by as much after they have been put upright. (5.4)
inline constexpr double corner_support = 1e-2;

/// [-] How far a support may miss a corner there, as a share of the body's shortest edge. Reason: as
/// for exact_vertical; poses of resting boxes differ by less. (5.4)
inline constexpr double exact_corner = 1e-6;

/// [-] Bodies are in balance if they would accelerate by less than this share of how they would
/// without contacts. Reason: rounding leaves 1e-12 in a pile of a hundred boxes; thresholds come out
/// to about this share. (6.3.1)
inline constexpr double exact_balance = 1e-9;

/// [-] Bodies slower than this share of sqrt(gL) stand still. Reason: 3 nm/s for a box of 1 m, a decimetre in
/// a year; rounding leaves 1e-12. (6.3.1)
inline constexpr double standstill = 1e-9;

}  // namespace tumble::tolerance
