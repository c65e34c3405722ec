/// \file
/// \brief The first touch of two boxes that move without turning, and the bound that conservative
///        advancement needs for all others (thesis 3.2, 5.1).
///
/// A test at discrete instants misses boxes that meet and separate within one step.
#pragma once

#include "tumble/base/error.hpp"
#include "tumble/geometry/box.hpp"
#include "tumble/geometry/separation.hpp"

namespace tumble {

/// How a sweep ended.
enum class SweepStatus : std::uint8_t {
  no_hit,               ///< the boxes stay apart all the way
  hit,                  ///< apart at the start, they touch on the way
  overlapping_at_start  ///< they overlap or touch at the start already
};

/// When two boxes that move without turning touch. Times are fractions of the motion.
struct SweepResult {
  SweepStatus status = SweepStatus::no_hit;  ///< which of the three
  /// [-] how much of the motion is free of contact: 1 if nothing is hit, 0 if they touch at once
  double enter = 1.0;
  /// [-] where they part again; may be above 1, and is infinite if they never do. Equal to `enter`
  /// if nothing is hit.
  double leave = 1.0;
  /// [-] world frame, length 1, from the first box to the second: the axis that separates them
  /// until they touch; of least overlap, if they touch at the start. Not for use if nothing is hit.
  Vec3 normal_w = Vec3::UnitX();
  AxisIndex axis = kNoAxis;  ///< which of the 15; the lowest of equal ones
};

/// Moves two boxes in straight lines without turning them, and finds their first contact.
///
/// On every axis n of the separating axis test the projections overlap during one interval,
/// \f$|n\cdot(d + t u)| \le r\f$ with the centres' difference d, the relative displacement u and the
/// sum r of both reaches. The boxes touch while all 15 intervals do.
///
/// \param displacement_first_w   [m] how far it moves, world frame
/// \param second                 the other box, at the start
/// \param displacement_second_w  [m] how far it moves, world frame
/// \return first and last contact; touching counts as contact. Exact to rounding; if edges are
///         almost parallel, by 1e-8, it may find contact 1e-8 of a half edge too far out
/// \throws std::invalid_argument for a displacement that is not finite
/// \par Cost
/// That of one separating axis test without early exit, about 400 operations.
/// \see Gottschalk, Lin, Manocha, "OBBTree", SIGGRAPH 1996, for the 15 axes.
[[nodiscard]] SweepResult sweep(const Box& first, const Vec3& displacement_first_w,
                                const Box& second, const Vec3& displacement_second_w);

/// How fast the separation along a fixed direction can shrink from now on.
///
/// After a time τ it has shrunk by at most `speed` τ + `acceleration` τ²/2. Both may be negative.
struct ClosingBound {
  double speed = 0.0;         ///< [m/s]
  double acceleration = 0.0;  ///< [m/s²]
};

/// The longest time for which a separation surely lasts.
/// \param distance  [m] at least 0
/// \return [s] up to when `speed` τ + `acceleration` τ²/2 stays at or below the distance; infinite:
///         for ever
[[nodiscard]] double safe_time(double distance, const ClosingBound& bound);

}  // namespace tumble
