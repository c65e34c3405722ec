/// \file
/// \brief Free motion under gravity: two Euler steps and the exact flight (thesis 3.1, 3.3.1).
#include "tumble/dynamics/integrate.hpp"

#include "tumble/base/error.hpp"
#include "tumble/base/number_text.hpp"

#include <cmath>

namespace tumble {
namespace {

// P += m g dt. An immovable body's mass is infinite, so it is left out here and not by a factor 0.
void accelerate(const BodyProperties& body, BodyState& state, const Vec3& gravity_w, double dt) {
  if (dt == 0.0 || !body.movable()) return;
  state.linear_momentum_w += dt * (body.mass * gravity_w);
}

}  // namespace

void step_forward_euler(const BodyProperties& body, BodyState& state, const Vec3& gravity_w,
                        double dt, RotationRule rule) {
  advance_pose(body, state, dt, rule);
  accelerate(body, state, gravity_w, dt);
}

void step_semi_implicit(const BodyProperties& body, BodyState& state, const Vec3& gravity_w,
                        double dt, RotationRule rule) {
  accelerate(body, state, gravity_w, dt);
  advance_pose(body, state, dt, rule);
}

void fly(const BodyProperties& body, BodyState& state, const Vec3& gravity_w, double dt,
         RotationRule rule) {
  accelerate(body, state, gravity_w, 0.5 * dt);
  advance_pose(body, state, dt, rule);
  accelerate(body, state, gravity_w, 0.5 * dt);
}

void fly_in_micro_steps(const BodyProperties& body, BodyState& state, const Vec3& gravity_w,
                        double dt, RotationRule rule, double micro_step) {
  constexpr double most_steps = 1e6;
  const double full_steps = std::floor(std::abs(dt) / micro_step);
  // Searches come here often: no message is made unless it is needed.
  if (!(micro_step > 0.0))
    refuse("micro_step = " + shortest_text(micro_step) + ": expected a number above 0");
  if (full_steps > most_steps)
    refuse("micro_step = " + shortest_text(micro_step) +
           ": expected at least a millionth of dt = " + shortest_text(dt));
  const double step = dt < 0.0 ? -micro_step : micro_step;
  for (double i = 0.0; i < full_steps; i += 1.0) fly(body, state, gravity_w, step, rule);
  // For an infinite micro_step there was no full one, and 0 times infinity is not a number.
  const double rest = full_steps > 0.0 ? dt - full_steps * step : dt;
  fly(body, state, gravity_w, rest, rule);
}

}  // namespace tumble
