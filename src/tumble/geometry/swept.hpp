/// \file
/// \brief When two moving boxes first touch, between two instants (thesis 3.2, 5.1).
///
/// A test at discrete instants misses boxes that meet and part within one step. Two tests here do
/// not: an exact one for boxes that do not turn, and a safe one for any motion.
#pragma once

#include "tumble/base/error.hpp"
#include "tumble/geometry/box.hpp"
#include "tumble/geometry/separation.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

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
/// \param first                  the one box, at the start
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
/// \param bound     how fast it can shrink
/// \return [s] up to when `speed` τ + `acceleration` τ²/2 stays at or below the distance; infinite:
///         for ever
[[nodiscard]] double safe_time(double distance, const ClosingBound& bound);

/// How an advance ended.
enum class AdvanceStatus : std::uint8_t {
  no_hit,               ///< apart until the end
  hit,                  ///< closer than the gap that counts as contact, and closing
  cap_reached,          ///< apart until `time`; what comes later is not known
  overlapping_at_start  ///< they overlap or touch at the start already
};

/// How far two bodies were advanced.
struct AdvanceResult {
  AdvanceStatus status = AdvanceStatus::no_hit;  ///< which of the four
  double time = 0.0;      ///< [s] there is no contact before; the end, if nothing is hit
  int iterations = 0;     ///< how often the separation was computed
  Separation separation;  ///< at that time; above 0 unless they overlap at the start
};

/// When to stop an advance.
struct AdvanceLimits {
  /// [m] a gap up to this counts as contact. Use a fraction of the size of the bodies.
  double gap = 0.0;
  int iterations = 256;  ///< how often the separation may be computed, at least 1
};

/// Advances two moving bodies to their first contact without ever passing it.
///
/// Conservative advancement: a separating direction found at one time stays one for as long as the
/// bodies cannot close their gap along it, so the time may be advanced by that much and the gap
/// measured again. Each step aims at half the gap that counts as contact, and therefore ends with
/// the bodies apart and makes progress. The gap shrinks at least geometrically while the bound is
/// within a constant factor of the truth; a grazing pass of fast spinning bodies is slow and may
/// reach the cap.
///
/// \tparam SeparationAt    callable: Separation(double time)
/// \tparam ClosingBoundAt  callable: ClosingBound(double time, const Separation& then)
/// \param separation_at  distance at a time, or a lower bound of it, and the direction from the
///                       first body to the second along which it was found
/// \param closing_bound  how fast it can shrink along that direction, from that time to t1
/// \param t0             [s] start
/// \param t1             [s] end, at least t0
/// \param limits         when to stop
/// \return time and status. Contact at a gap that is not closing (speed at most 0 and not
///         growing) is no hit: bodies that have just bounced may start as close as they like.
/// \throws std::invalid_argument for times that are not finite or not in order, a gap not above 0
///         or a cap below 1
/// \see Mirtich, *Impulse-based Dynamic Simulation of Rigid Body Systems*, PhD thesis, 1996.
/// \algorithm{Swept volumes: section 3.2}
/// \verified{Conservative advancement never passes a contact of tumbling boxes}
template <class SeparationAt, class ClosingBoundAt>
AdvanceResult advance_conservatively(const SeparationAt& separation_at,
                                     const ClosingBoundAt& closing_bound, double t0, double t1,
                                     const AdvanceLimits& limits) {
  require::finite(t0, "t0");
  require::finite(t1, "t1");
  require::that(t0 <= t1, "t1 is before t0: give times in order");
  require::positive(limits.gap, "limits.gap");
  require::that(limits.iterations >= 1, "limits.iterations: give at least 1");

  AdvanceResult out;
  out.time = t0;
  while (true) {
    out.separation = separation_at(out.time);
    ++out.iterations;
    const double distance = out.separation.distance;
    if (out.iterations == 1 && distance <= 0.0) {
      out.status = AdvanceStatus::overlapping_at_start;
      return out;
    }
    const ClosingBound bound = closing_bound(out.time, out.separation);
    assert(std::isfinite(bound.speed) && std::isfinite(bound.acceleration));
    const bool closing = bound.speed > 0.0 || (bound.speed == 0.0 && bound.acceleration > 0.0);
    if (distance <= limits.gap && closing) {
      out.status = AdvanceStatus::hit;
      return out;
    }
    if (out.time >= t1) {
      out.status = AdvanceStatus::no_hit;
      return out;
    }
    if (out.iterations >= limits.iterations) {
      out.status = AdvanceStatus::cap_reached;
      return out;
    }
    const double spare = std::max(distance - 0.5 * limits.gap, 0.0);
    out.time = std::min(t1, out.time + safe_time(spare, bound));
  }
}

/// A box in free motion at constant angular velocity and constant acceleration.
struct RigidMotion {
  Box start;                               ///< at time 0
  Vec3 velocity_w = Vec3::Zero();          ///< [m/s] of the centre at time 0, world frame
  Vec3 angular_velocity_w = Vec3::Zero();  ///< [rad/s] about the centre, world frame
  Vec3 acceleration_w = Vec3::Zero();      ///< [m/s²] of the centre, world frame
};

/// Where a moving box is.
/// \param motion  how it moves
/// \param time    [s]
/// \return the box, turned by the exponential of ω t about its centre
[[nodiscard]] Box box_at(const RigidMotion& motion, double time);

/// How fast two moving boxes can approach along a direction from now on.
///
/// Along n, centres close by \f$n\cdot(v_1 - v_2)\,\tau + \tfrac12 n\cdot(a_1 - a_2)\,\tau^2\f$ exactly.
/// A point at most ρ from its centre moves against the centre at
/// \f$n\cdot(\omega\times\rho) = \rho\cdot(n\times\omega)\f$, so turning adds at most
/// \f$|n\times\omega_i|\,\rho_i\f$ each, with half the diagonal of the box for ρ. A common gravity
/// drops out, and so does spin about the normal.
/// \param first     the one box
/// \param second    the other
/// \param normal_w  [-] world frame, length 1, from the first to the second
/// \param time      [s] from which on
/// \return the bound, valid for all later times
[[nodiscard]] ClosingBound closing_bound(const RigidMotion& first, const RigidMotion& second,
                                         const Vec3& normal_w, double time);

/// Advances two boxes in free motion to their first contact.
/// \param first     the one box
/// \param second    the other
/// \param duration  [s] at least 0
/// \param limits    when to stop; a gap of 0 stands for `tolerance::contact_gap` times the shortest
///                  edge of the two
/// \return time and status, as advance_conservatively() tells them
/// \throws std::invalid_argument for a velocity or acceleration that is not finite, a duration
///         below 0 or limits out of range
[[nodiscard]] AdvanceResult first_contact(const RigidMotion& first, const RigidMotion& second,
                                          double duration, AdvanceLimits limits = {});

}  // namespace tumble
