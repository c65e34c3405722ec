/// \file
/// \brief The small numbers of the chapter on geometric stability, in the form of those of the
///        layers; include `tumble/base/tolerance.hpp`, which has all.
#pragma once

namespace tumble::tolerance {

// --- geometric_stability ------------------------------------------------------------------

/// [-] How far surfaces may be apart and still hold up a body, as a share of the shortest edge of
/// the two, when it is asked who stands firm. Reason: repair leaves gaps of up to ε1. (5.4)
inline constexpr double stability_margin = 2e-3;

/// [-] Largest sine between a contact normal and the vertical at which the contact counts as
/// vertical. Reason: upright boxes of a pile lean by less than 1e-3; at 3e-3 a load of 300 pushes
/// aside with a weight of one. (5.4)
inline constexpr double vertical_normal = 3e-3;

/// [-] How far a support may miss a corner sideways and still hold it, as a share of the body's
/// shortest edge. Reason: the lever of what is held then is shorter by a hundredth; boxes that
/// stand edge on edge differ by as much after they have been put upright. (5.4)
inline constexpr double corner_support = 1e-2;

/// [-] Largest sine between a contact normal and the vertical at which the contact counts as vertical
/// where boxes leave the system of exact forces. Reason: what is pushed aside then is a tenth of
/// what the forces may miss (tolerance::force_residual). (5.4)
inline constexpr double exact_vertical = 1e-6;

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
