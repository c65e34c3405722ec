/// \file
/// \brief The limits on where a body may be, and how fast.
#pragma once

#include "tumble/dynamics/body.hpp"

namespace tumble {

/// Refuses a place or a motion that a double does not resolve, or that no body has.
///
/// Coordinates are at most tolerance::farthest times the shortest edge, and no point of a body is faster than
/// tolerance::largest_speed.
/// \param body                a box
/// \throws std::invalid_argument naming the value, the limit and the remedy
/// \verified{Values out of the range of a scene are refused with body, value and remedy}
void require_motion_limits(const BodyProperties& body, const Vec3& position_w,
                           const Vec3& velocity_w, const Vec3& angular_velocity_w);

/// The same for a state.
/// \param body   a box
/// \param state  finite
/// \throws std::invalid_argument as above
void require_motion_limits(const BodyProperties& body, const BodyState& state);

/// Refuses a coefficient of friction that is none.
/// \param friction  [-] from 0 to tolerance::largest_friction
/// \throws std::invalid_argument naming the value, the limit and the remedy
void require_friction(double friction);

/// Refuses a gravity that would make a body faster than tolerance::largest_speed within a second.
/// \throws std::invalid_argument naming the value, the limit and the remedy
void require_gravity(const Vec3& gravity_w);

/// Refuses the length of a step.
/// \param dt    [s] from tolerance::shortest_step to longest_step
/// \param time  [s] when the step begins; has to be resolved to tolerance::step_share of dt
/// \throws std::invalid_argument naming the value, the limit and the remedy
void require_step_limits(double dt, double time);

}  // namespace tumble
