/// \file
/// \brief Friction of an area: force and moment under one bound.
#include "tumble/contact_damped/bounded_friction.hpp"

#include "tumble/contact_damped/tolerances.hpp"

#include <algorithm>
#include <cmath>

namespace tumble {
namespace {

constexpr double kLittle = 1e-17;  // of a motion: less than rounding
constexpr double kNearly =
    1e-7;  // of the bound: so near to it that a straight step ends within rounding

}  // namespace

Vec3 bounded_friction(const Mat3& inverse_mass, const Vec3& motion, double limit) {
  if (!(limit > 0.0)) return Vec3::Zero();
  const double speed = motion.norm();
  const double yield = inverse_mass.norm();
  // So little that it changes nothing of the motion; what follows would overflow.
  if (limit * yield <= kLittle * speed) return motion * (-limit / speed);
  // lambda(beta) = -(A + beta I)^-1 u shrinks as beta grows; 1/|lambda| is nearly straight in beta, and
  // Newton's steps from below never pass the root. With cofactors numerator and denominator are polynomials,
  //   lambda = -p/d,  p = adj(A + beta I) u = (adj(A) + beta (tr(A) I - A) + beta^2 I) u,
  //   d = det(A + beta I) = det(A) + beta tr(adj(A)) + beta^2 tr(A) + beta^3,
  // so that a step costs no inverse; and powers of two of the mass give the same bits.
  const Mat3& A = inverse_mass;
  const Vec3& u = motion;
  const double c00 = A(1, 1) * A(2, 2) - A(1, 2) * A(1, 2);
  const double c01 = A(0, 2) * A(1, 2) - A(0, 1) * A(2, 2);
  const double c02 = A(0, 1) * A(1, 2) - A(0, 2) * A(1, 1);
  const double c11 = A(0, 0) * A(2, 2) - A(0, 2) * A(0, 2);
  const double c12 = A(0, 1) * A(0, 2) - A(0, 0) * A(1, 2);
  const double c22 = A(0, 0) * A(1, 1) - A(0, 1) * A(0, 1);
  const double trace = A(0, 0) + A(1, 1) + A(2, 2);
  const double d0 = A(0, 0) * c00 + A(0, 1) * c01 + A(0, 2) * c02;
  const double d1 = c00 + c11 + c22;
  Mat3 cofactors;
  cofactors << c00, c01, c02, c01, c11, c12, c02, c12, c22;
  // adj(A + beta I) x
  const auto adjoined = [&](double beta, const Vec3& x) -> Vec3 {
    return cofactors * x + beta * ((trace + beta) * x - A * x);
  };
  // From |lambda| >= |u| / (|A| + beta): above 0 it says that the ball does not allow to stop.
  double beta = std::max(0.0, speed / limit - yield);
  const Vec3 p0 = cofactors * u;
  const Vec3 p1 = trace * u - A * u;
  Vec3 p = p0;
  for (int step = 0; step < 30; ++step) {
    p = p0 + beta * (p1 + beta * u);
    const double d = d0 + beta * (d1 + beta * (trace + beta));
    const double square = p.squaredNorm();
    const double most = limit * d;
    const double excess = std::sqrt(square) - most;
    if (excess <= tolerance::friction_rounding * most)
      return -p / d;  // stopped (beta = 0), or the bound is met to rounding
    // lambda' = -(A + beta I)^-1 lambda; one division leads to the next beta.
    const Vec3 follows = adjoined(beta, p);
    const double more = square * excess / (limit * p.dot(follows));
    if (excess < kNearly * most) return (more / d * follows - p) / d;
    beta += more;
  }
  return p * (-limit / p.norm());
}

}  // namespace tumble
