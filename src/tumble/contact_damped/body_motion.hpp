/// \file
/// \brief Motion of a body by itself in a part of a step (thesis 6.3.1).
#pragma once

#include "tumble/contact/moving_body.hpp"
#include "tumble/contact_damped/island.hpp"
#include "tumble/dynamics/advance_pose.hpp"

#include <span>

namespace tumble {

/// How bodies move in a part of a step, apart from those that others carry (PivotUpdate).
struct BodyMotion {
  double dt = 0.0;                                  ///< [s] of the part
  RotationRule rotation = RotationRule::splitting;  ///< how orientations are integrated
  std::span<const char> in_flight;                  ///< by body index: those that nothing holds
};

/// Moves a body: along its parabola if it is in flight, else with its velocity at the end of the step. One that turns by more
/// than tolerance::turn_at_once does so bit by bit, since no rule of rotation keeps its energy at once.
/// \param k       its index, a movable body
/// \param turn    [rad] by which it turns
/// \param world   its constant part and gravity
/// \param state   its pose at the start of the step, its momenta at the end; in and out
int move_by_itself(const BodyMotion& motion, int k, double turn, const World& world,
                   BodyState& state);

/// Where a body would be at the end of the step by itself.
/// \param end     its velocities at the end of the step
/// \param world   with its pose at the start of the step
/// \return its state then; an immovable body's as it is
[[nodiscard]] BodyState state_after(const BodyMotion& motion, int k, const MovingBody& end,
                                    const World& world);

/// Clears `in_flight` of the bodies that do not fly their parabola. Those fly it that are pushed by nothing, or only by each other:
/// then all of a group that touches falls alike. Impulses of rounding push nothing: velocities of such bodies are `free` again.
/// \param in_flight  by body index, set for all bodies of the island
void decide_flight(const Island& island, std::span<char> in_flight);

}  // namespace tumble
