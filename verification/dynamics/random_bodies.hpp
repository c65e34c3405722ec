/// \file
/// \brief Random boxes in random motion, for properties that hold for all of them.
#pragma once

#include "tumble/base/random.hpp"
#include "tumble/dynamics/body.hpp"

namespace tumble {

// A movable box with edges of 0.2 to 2 m and a mass of 0.5 to 10 kg.
inline BodyProperties random_box(Random& random) {
  const Vec3 size = Vec3::Constant(1.1) + random.in_cube(0.9);
  const double mass = random.uniform(0.5, 10.0);
  return box_properties(size, mass);
}

// A state anywhere in a cube, at any orientation.
// extent: [m] half the edge of the cube for the position
// speed: [m/s] largest component of the velocity
// spin: [rad/s] largest component of the angular velocity
inline BodyState random_state(Random& random, const BodyProperties& body, double extent,
                              double speed, double spin) {
  const Vec3 position = random.in_cube(extent);
  const Quat orientation = random.orientation();
  const Vec3 velocity_w = random.in_cube(speed);
  const Vec3 omega_w = random.in_cube(spin);
  return make_state(body, position, orientation, velocity_w, omega_w);
}

// Whether two states are equal to the last bit, +0 and -0 counted as equal.
inline bool same_state(const BodyState& a, const BodyState& b) {
  return a.position_w == b.position_w && a.orientation_wb.coeffs() == b.orientation_wb.coeffs() &&
         a.linear_momentum_w == b.linear_momentum_w && a.angular_momentum_w == b.angular_momentum_w;
}

}  // namespace tumble
