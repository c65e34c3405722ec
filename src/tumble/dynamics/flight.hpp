/// \file
/// \brief Bodies in flight: where they are at any time of a step, and how far apart (thesis 3.2).
#pragma once

#include "tumble/dynamics/integrate.hpp"
#include "tumble/dynamics/world.hpp"
#include "tumble/geometry/broad_phase.hpp"
#include "tumble/geometry/swept.hpp"

#include <limits>
#include <span>

namespace tumble {

/// How bodies move until the next event: each on its own arc from its last valid state.
///
/// All times of a search are counted from one origin; the start of the step is the best one, since
/// times far from 0 have fewer digits left. The arrays are the caller's and have to outlive the
/// flight.
struct Flight {
  std::span<const BodyProperties> bodies;  ///< by index
  std::span<const BodyState> states;       ///< by index, each at its valid time
  /// [s] by index: the valid times, when bodies have different ones (thesis
  /// 5.1). Empty: all are 0.
  std::span<const double> valid_times = {};
  /// [m/s²] by index, world frame: what each body's centre is accelerated by, for a caller that
  /// knows of contact forces. Empty: gravity_w for every movable body.
  std::span<const Vec3> accelerations_w = {};
  Vec3 gravity_w = Vec3(0.0, -9.81, 0.0);       ///< [m/s²] world frame
  RotationRule rule = RotationRule::splitting;  ///< how bodies turn
  /// [s] Bodies turn in steps of this length and a last one for the rest. Infinity: in one step.
  double micro_step = std::numeric_limits<double>::infinity();
  /// [s] by index: micro-steps of their own. Empty: `micro_step` for all.
  std::span<const double> micro_steps = {};
};

/// Whether a body in flight turns at a constant rate, so that its rotation rule takes it to the same
/// place in any number of steps: all its moments of inertia are equal, or it does not turn. The rule
/// `rk4` follows no rotation exactly.
/// \return true for cubes, but for rk4, and for an immovable body
[[nodiscard]] bool turns_evenly(const BodyProperties& body, const BodyState& state,
                                RotationRule rule);

/// Checks a flight before it is searched.
/// \param start  [s] from which on
/// \throws std::invalid_argument if an array has another length than `bodies`, a number is not
///         finite, or a body is valid only after the start
void require_valid(const Flight& flight, double start);

/// Where a body is at a time, flown there in one go from its valid state.
///
/// Always from the valid state: a body flown to a time found by a search has the very bits that
/// the search saw.
/// \param time  [s] may be before its valid time
/// \throws std::invalid_argument if the angular momentum is not finite
BodyState state_at(const Flight& flight, int body, double time);

/// How far two bodies are apart, or how deep they overlap.
///
/// For two boxes the largest separation over all 15 axes: above 0 a lower bound of the distance,
/// below 0 the exact depth. For a box and the ground the height of the lowest corner. Touching is
/// 0 and does not count as overlap here. Two grounds do not exist.
/// \param first   constant part of the body with the smaller index
/// \param second  constant part of the other one
/// \return signed distance [m] and the direction from the first to the second body
Separation gap_between(const BodyProperties& first, const BodyState& first_state,
                       const BodyProperties& second, const BodyState& second_state);

/// How fast a body's centre moves at a time, without turning it there.
/// \param time  [s]
/// \return [m/s] world frame
Vec3 velocity_at(const Flight& flight, int body, double time);

/// What a body's centre is accelerated by [m/s²], world frame; 0 for an immovable body.
Vec3 acceleration_of(const Flight& flight, int body);

/// How far two bodies in flight are apart at a time.
/// \param time  [s]
/// \return as gap_between() has it
/// \throws std::invalid_argument if an angular momentum is not finite
Separation gap_at(const Flight& flight, const IndexPair& pair, double time);

/// Bounds of all of a body's way in flight, for finding pairs that may meet.
/// \param start      its state now
/// \param time       [s] of the flight
/// \param reach      [m] of the body from its centre, whichever way it turns; at least half its
///                   diagonal
/// \return bounds of the parabola's chord, widened by the reach and by how far a parabola leaves its
///         chord; those of the body alone if it is immovable
Bounds bounds_of_flight(const BodyProperties& body, const BodyState& start, const Vec3& gravity_w,
                        double time, double reach);

/// Pairs of bodies that may meet in free flight: those whose ways, as wide as their reach, overlap.
/// \param time         [s] of the flight
/// \param reach        gets an index; gives that body's reach, see bounds_of_flight() [m]
/// \param bounds       storage; overwritten
/// \param pairs        overwritten, sorted
template <class Reach>
void find_flight_pairs(const World& world, double time, const Reach& reach, BroadPhase& broad_phase,
                       std::vector<Bounds>& bounds, std::vector<IndexPair>& pairs) {
  // [S4.1]
  // Bodies may meet in the time that is left if their ways overlap.
  bounds.clear();
  for (std::size_t k = 0; k < world.bodies().size(); ++k)
    bounds.push_back(
        bounds_of_flight(world.bodies()[k], world.states()[k], world.gravity_w, time, reach(k)));
  broad_phase.find_pairs(bounds, pairs);
  // [S4.1]
}

/// How fast the gap of two bodies along a fixed direction can close from a time to an end.
///
/// Centres close along n by \f$n\cdot(v_1-v_2)\,\tau + \tfrac12 n\cdot(a_1-a_2)\,\tau^2\f$ exactly.
/// Turning adds at most \f$W_i \rho_i\f$ per body, with angular_speed_bound() of one (micro) step for
/// W and half the diagonal for ρ.
/// \param normal_w  [-] world frame, length 1, from the first to the second
/// \param time      [s] from which on, not before the valid times
/// \param end       [s] until when
ClosingBound closing_bound(const Flight& flight, const IndexPair& pair, const Vec3& normal_w,
                           double time, double end);

}  // namespace tumble
