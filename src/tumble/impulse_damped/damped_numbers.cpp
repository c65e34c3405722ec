/// \file
/// \brief The constants of damped integration, made ready for a body and a time step.
#include "tumble/impulse_damped/damped_numbers.hpp"

#include "tumble/base/error.hpp"
#include "tumble/math/elementary.hpp"

#include <algorithm>
#include <cmath>

namespace tumble {

DampedFactors factors_of(const DampedNumbers& numbers, double dt) {
  const double exponent = kDampedStepsPerSecond * dt * numbers.k_scale;
  const auto factor = [&](double k) { return elementary::pow(k, exponent); };
  return DampedFactors{.momentum = factor(numbers.k1),
                       .spin = factor(numbers.k2),
                       .settled_spin = factor(numbers.k3),
                       .slow = factor(numbers.k5),
                       .slow_spin = factor(numbers.k7)};
}

DampedThresholds thresholds_of(const DampedNumbers& numbers, const BodyProperties& body,
                               double gravity, double dt) {
  const double length = body.size.minCoeff();
  const double momentum = numbers.eps_scale * body.mass * std::sqrt(gravity * length);
  const double share = kDampedStepsPerSecond * dt;  // of a step of 1/60 s
  const double step = numbers.eps_scale * share;
  // What a step stops has to be less than what gravity sets in motion.
  const double stopped = std::min(
      share * momentum, numbers.eps_scale * tolerance::damped_stop * body.mass * gravity * dt);
  const double fall = tolerance::damped_halt * gravity;
  const double frozen =
      step * std::min(length, fall / (kDampedStepsPerSecond * kDampedStepsPerSecond));
  return DampedThresholds{
      .push = numbers.eps_scale * numbers.eps1 * length,
      .aligned = numbers.eps_scale * numbers.eps2,
      .settled = numbers.eps3 * stopped,
      .tilt = numbers.eps4 * step,
      .slow = numbers.eps5 * momentum,
      .still = numbers.eps6 * stopped,
      .slow_spin = numbers.eps7 * momentum * length,
      .still_spin = numbers.eps8 * stopped * length,
      .rising = numbers.eps9 * momentum * share,
      .frozen = numbers.eps10 * frozen,
      .frozen_in_flight = numbers.eps10 * std::min(frozen, numbers.eps_scale * fall * dt * dt),
      .frozen_angle = numbers.eps11 * step};
}

void check(const DampedNumbers& n) {
  require::not_negative(n.eps1, "eps1");
  require::not_negative(n.eps2, "eps2");
  require::not_negative(n.eps3, "eps3");
  require::not_negative(n.eps4, "eps4");
  require::not_negative(n.eps5, "eps5");
  require::not_negative(n.eps6, "eps6");
  require::not_negative(n.eps7, "eps7");
  require::not_negative(n.eps8, "eps8");
  require::not_negative(n.eps9, "eps9");
  require::not_negative(n.eps10, "eps10");
  require::not_negative(n.eps11, "eps11");
  require::within(n.k1, 0.0, 1.0, "k1");
  require::within(n.k2, 0.0, 1.0, "k2");
  require::within(n.k3, 0.0, 1.0, "k3");
  require::within(n.k5, 0.0, 1.0, "k5");
  require::within(n.k7, 0.0, 1.0, "k7");
  require::not_negative(n.eps_scale, "eps_scale");
  require::not_negative(n.k_scale, "k_scale");
}

}  // namespace tumble
