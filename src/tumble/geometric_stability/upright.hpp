/// \file
/// \brief Tolerances of the vertical (thesis 5.4).
#pragma once

#include "tumble/contact/tolerances.hpp"
#include "tumble/dynamics/world.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tumble {

/// Whether a normal is along the positive or negative y axis.
/// \param tolerance  [-] largest sine of the angle to the axis
[[nodiscard]] inline bool is_vertical(const Vec3& normal_w, double tolerance) {
  return std::sqrt(normal_w.x() * normal_w.x() + normal_w.z() * normal_w.z()) <= tolerance;
}

/// Whether gravity acts along the negative y axis, as the thesis assumes.
[[nodiscard]] inline bool gravity_is_down(const World& world) {
  return world.gravity_w.y() < 0.0 && world.gravity_w.x() == 0.0 && world.gravity_w.z() == 0.0;
}

/// Largest deviation of a normal from the vertical for boxes left out of the system of contact forces.
///
/// A load has this share of itself as a horizontal force on its support, so that a light body under a
/// heavy one needs a more exact support.
/// \return [-] tolerance::exact_vertical times the lightest movable mass over the heaviest
[[nodiscard]] inline double exact_vertical(const World& world) {
  double lightest = std::numeric_limits<double>::infinity(), heaviest = 0.0;
  for (const BodyProperties& body : world.bodies()) {
    if (!body.movable()) continue;
    lightest = std::min(lightest, body.mass);
    heaviest = std::max(heaviest, body.mass);
  }
  return heaviest > 0.0 ? tolerance::exact_vertical * (lightest / heaviest)
                        : tolerance::exact_vertical;
}

/// Upper bound on the vertical speed of a body's rim as it rises, sinks or tips [m/s], at least 0.
[[nodiscard]] inline double tipping_speed(const BodyProperties& body, const BodyState& state) {
  const Vec3 omega_w = angular_velocity(body, state);
  const double tips = std::sqrt(omega_w.x() * omega_w.x() + omega_w.z() * omega_w.z());
  return std::abs(velocity(body, state).y()) + 0.5 * body.size.norm() * tips;
}

}  // namespace tumble
