/// \file
/// \brief Friction of an area: force and moment under one bound.
#include "tumble/impulse_damped/bounded_friction.hpp"

#include <Eigen/LU>

namespace tumble {

Vec3 bounded_friction(const Mat3& inverse_mass, const Vec3& motion, double limit) {
  if (!(limit > 0.0)) return Vec3::Zero();
  // lambda(beta) = -(A + beta I)^-1 u shrinks as beta grows; 1/|lambda| is nearly straight in beta, and
  // Newton's steps from beta = 0 never pass the root.
  double beta = 0.0;
  Vec3 impulse = Vec3::Zero();
  for (int step = 0; step < 30; ++step) {
    // By cofactors: without roots, so that powers of two of the mass give the same bits.
    const Mat3 yields = (inverse_mass + beta * Mat3::Identity()).inverse();
    impulse = -yields * motion;
    const double size = impulse.norm();
    if (size <= limit * (1.0 + 1e-14)) {
      // Stopped (beta = 0), or the bound is met to rounding.
      return impulse;
    }
    // |lambda|' = -lambda' (A + beta I)^-1 lambda / |lambda|
    const double slope = impulse.dot(yields * impulse);
    beta += size * size / slope * (size - limit) / limit;
  }
  return impulse * (limit / impulse.norm());
}

}  // namespace tumble
