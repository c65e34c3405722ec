/// \file
/// \brief The independent judge of tumbling: a free body's exact motion, by GSL.
#pragma once

#include "tumble/base/types.hpp"

namespace tumble::chapters {

// Euler's exact solution for a free body with three different moments of inertia.
//
// With energy T and angular momentum L such that \f$L^2 > 2 T I_2\f$,
// \f[ \omega = (w_1\,\mathrm{cn}\,u,\; w_2\,\mathrm{sn}\,u,\; w_3\,\mathrm{dn}\,u), \qquad
//     u = u_0 + \lambda t, \f]
// with Jacobi's elliptic functions of parameter m.
// \see Landau, Lifshitz, *Mechanics*, section 37
class FreeRotation {
 public:
  // A motion from its start.
  // inertia_b: [kg m²] ascending principal moments, all different
  // omega_b: [rad/s] at time 0, body frame; second component at least 0, third above 0
  FreeRotation(const Vec3& inertia_b, const Vec3& omega_b);

  // The angular velocity at a time.
  // time: [s]
  // Returns [rad/s] body frame
  [[nodiscard]] Vec3 at(double time) const;

  // When the second component is 0 for the first time: the body turns over.
  // Returns [s]
  [[nodiscard]] double first_flip() const;

  // How long the body takes from one such time to the next.
  // Returns [s]
  [[nodiscard]] double flip_interval() const;

 private:
  Vec3 amplitude_;    // [rad/s] w1, w2, w3
  double rate_;       // [rad/s] lambda
  double parameter_;  // [-] m
  double quarter_;    // [-] quarter period K(m)
  double phase_;      // [-] u0
};

// The orientation of a free body after a time, by an eighth-order integrator at the limit of double
// precision, from equations in the body's frame (the library's rules use the world's).
// inertia_b: [kg m²] principal moments
// omega_b: [rad/s] at time 0, body frame; the orientation is 1 then
// time: [s] above 0
// Returns [-] body to world
Quat free_orientation(const Vec3& inertia_b, const Vec3& omega_b, double time);

}  // namespace tumble::chapters
