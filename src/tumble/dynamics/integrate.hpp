/// \file
/// \brief Free motion under gravity: two Euler steps and the exact flight (thesis 3.1, 3.3.1).
#pragma once

#include "tumble/dynamics/advance_pose.hpp"

namespace tumble {

// All functions of this file leave an immovable body as it is, and change nothing to the last bit
// if dt is 0. Gravity stands for any acceleration that is the same for the whole step.

/// Forward Euler: first moves with the old velocity, then changes the velocity.
///
/// \f$x \leftarrow x + \Delta t\,v,\; v \leftarrow v + \Delta t\,g\f$. Order 1: after a time t of
/// free fall the position is off by \f$-g\,t\,\Delta t/2\f$ (too high), at any dt.
/// \param dt         [s] may be negative
/// \throws std::invalid_argument if the angular momentum is not finite
void step_forward_euler(const BodyProperties& body, BodyState& state, const Vec3& gravity_w,
                        double dt, RotationRule rule);

/// Semi-implicit (symplectic) Euler: first changes the velocity, then moves with the new one.
///
/// \f$v \leftarrow v + \Delta t\,g,\; x \leftarrow x + \Delta t\,v\f$. Order 1: after a time t of
/// free fall the position is off by \f$+g\,t\,\Delta t/2\f$ (too low), at any dt. It is the inverse
/// of a forward Euler step of -dt.
/// \param dt         [s] may be negative
/// \throws std::invalid_argument if the angular momentum is not finite
void step_semi_implicit(const BodyProperties& body, BodyState& state, const Vec3& gravity_w,
                        double dt, RotationRule rule);

/// Ballistic flight: the exact parabola.
///
/// Half of the momentum before the move and half after it,
/// \f[ P \leftarrow P + \tfrac12 m g\,\Delta t, \quad x \leftarrow x + \Delta t\,P/m, \quad
///     P \leftarrow P + \tfrac12 m g\,\Delta t, \f]
/// which is \f$x + v\,\Delta t + \tfrac12 g\,\Delta t^2\f$. For the translation this is a flow:
/// flying for a and then for b is flying for a + b, to rounding, as a search for collision times
/// needs it. The rotation is a flow only where its rule is exact (see RotationRule); elsewhere
/// flying in two parts differs from flying in one by the error of the rule. So a search evaluates
/// all poses from one state, the one after the last event, and never continues from a pose tried.
/// \param dt         [s] may be negative
/// \throws std::invalid_argument if the angular momentum is not finite
void fly(const BodyProperties& body, BodyState& state, const Vec3& gravity_w, double dt,
         RotationRule rule);

/// Ballistic flight in steps of a fixed length and a last one for the rest.
///
/// Still a continuous function of dt, and closer to a flow: what parts differ by shrinks like the
/// error of the rule at `micro_step`.
/// \param dt          [s] may be negative
/// \param micro_step  [s] above 0; infinity: one step, as fly() does it
/// \throws std::invalid_argument if micro_step is not above 0 or dt is a million times longer, or
///         the angular momentum is not finite
void fly_in_micro_steps(const BodyProperties& body, BodyState& state, const Vec3& gravity_w,
                        double dt, RotationRule rule, double micro_step);

}  // namespace tumble
