/// \file
/// \brief The least value of a quadratic function within a ball.
#include "tumble/math/minimum_in_ball.hpp"

#include "tumble/base/tolerances.hpp"

#include <algorithm>
#include <cmath>

namespace tumble {

Vec3 minimum_in_ball(const Mat3& A, const Vec3& u, double radius) {
  if (!(radius > 0.0) || u == Vec3::Zero()) return Vec3::Zero();
  // Squares of very small numbers vanish. Powers of two give the same bits.
  if (u.cwiseAbs().maxCoeff() < tolerance::ball_smallest) {
    const double unit = std::ldexp(1.0, tolerance::ball_power);
    return minimum_in_ball(A, unit * u, unit * radius) / unit;
  }
  const double steepest = u.norm();
  const double curvature = A.norm();
  // Too small to change the slope at all; the formulas below would overflow.
  if (radius * curvature <= tolerance::ball_negligible * steepest) return u * (-radius / steepest);
  // lambda(beta) = -(A + beta I)^-1 u shrinks as beta grows; 1/|lambda| is nearly straight in beta, and
  // Newton steps from below never pass the root. With cofactors numerator and denominator are polynomials,
  //   lambda = -p/d,  p = adj(A + beta I) u = (adj(A) + beta (tr(A) I - A) + beta^2 I) u,
  //   d = det(A + beta I) = det(A) + beta tr(adj(A)) + beta^2 tr(A) + beta^3,
  // so that a step costs no inverse; and powers of two of A give the same bits.
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
  // Lower bound from |lambda| >= |u| / (|A| + beta). Above 0 the minimum is on the sphere.
  double beta = std::max(0.0, steepest / radius - curvature);
  const Vec3 p0 = cofactors * u;
  const Vec3 p1 = trace * u - A * u;
  Vec3 p = p0;
  for (int step = 0; step < tolerance::ball_newton_steps; ++step) {
    p = p0 + beta * (p1 + beta * u);
    const double d = d0 + beta * (d1 + beta * (trace + beta));
    const double square = p.squaredNorm();
    const double most = radius * d;
    const double excess = std::sqrt(square) - most;
    if (excess <= tolerance::ball_rounding * most)
      return -p / d;  // inside (beta = 0), or on the sphere to rounding
    // lambda' = -(A + beta I)^-1 lambda; one division leads to the next beta.
    const Vec3 follows = adjoined(beta, p);
    const double more = square * excess / (radius * p.dot(follows));
    if (excess < tolerance::ball_last_step * most) return (more / d * follows - p) / d;
    beta += more;
  }
  return p * (-radius / p.norm());
}

}  // namespace tumble
