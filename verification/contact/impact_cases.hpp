/// \file
/// \brief Bodies for tests of impacts, and what tests ask of them.
#pragma once

#include "tumble/base/random.hpp"
#include "tumble/contact/effective_mass.hpp"

#include <cmath>

namespace tumble::impact_cases {

// A body with its mass and inertia, which a MovingBody has only as inverses.
struct Heavy {
  MovingBody moving;
  double mass = 0.0;              // [kg] 0 for an immovable body
  Mat3 inertia_w = Mat3::Zero();  // [kg m²]
};

// A movable box.
inline Heavy box(const Vec3& position_w, const Vec3& size, double mass, const Vec3& velocity_w,
                 const Vec3& omega_w = Vec3::Zero(),
                 const Quat& orientation_wb = Quat::Identity()) {
  const BodyProperties body = box_properties(size, mass);
  const Mat3 r = orientation_wb.toRotationMatrix();
  Heavy h{.mass = mass, .inertia_w = r * body.inertia_b.asDiagonal() * r.transpose()};
  h.moving.position_w = position_w;
  h.moving.velocity_w = velocity_w;
  h.moving.angular_velocity_w = omega_w;
  h.moving.inverse_mass = Vec3::Constant(1.0 / mass);
  h.moving.inverse_inertia_w = inverse_inertia_w(body, orientation_wb);
  return h;
}

// An immovable body.
inline Heavy fixed() { return {}; }

// [J]
inline double kinetic_energy(const Heavy& h) {
  const Vec3& omega = h.moving.angular_velocity_w;
  return 0.5 * h.mass * h.moving.velocity_w.squaredNorm() + 0.5 * omega.dot(h.inertia_w * omega);
}

// [kg m/s]
inline Vec3 momentum(const Heavy& h) { return h.mass * h.moving.velocity_w; }

// [kg m²/s] about the origin
inline Vec3 angular_momentum(const Heavy& h) {
  return h.moving.position_w.cross(momentum(h)) + h.inertia_w * h.moving.angular_velocity_w;
}

// 10 to the power of a number between -reach and reach.
inline double magnitude(Random& random, double reach) {
  return std::pow(10.0, random.uniform(-reach, reach));
}

// A box of random size (edges 0.3 to 3 m), mass (1 g to 1 t), orientation and motion.
inline Heavy random_box(Random& random) {
  const double w = magnitude(random, 0.5);
  const double h = magnitude(random, 0.5);
  const double d = magnitude(random, 0.5);
  const double mass = magnitude(random, 3.0);
  const Vec3 position = random.in_cube(2.0);
  const Vec3 velocity = random.in_cube(5.0);
  const Vec3 omega = random.in_cube(5.0);
  return box(position, Vec3(w, h, d), mass, velocity, omega, random.orientation());
}

}  // namespace tumble::impact_cases
