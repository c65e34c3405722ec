/// \file
/// \brief Friction by point, as the direct solver has it: impulses of single points of a patch and Coulomb's cone (thesis 6.3.1).
#pragma once

#include "tumble/contact_patches/contact_patch.hpp"

#include <cmath>

namespace tumble {

/// Adds an impulse at a point to that of the patch.
/// \param along   [m] its place
/// \param across  [m] ditto
/// \param push    [N s] along, across, normal
/// \param sum     of the patch; in and out
inline void add_push(double along, double across, const Vec3& push, Six& sum) {
  sum[0] += push[0];
  sum[1] += push[1];
  sum[2] += push[2];
  sum[3] += across * push[2];
  sum[4] -= along * push[2];
  sum[5] += along * push[1] - across * push[0];
}

/// What a unit impulse along the normal at a point moves it by.
/// \param K       motion of the middle of the patch for unit impulses there
/// \param along   [m] place of the point
/// \param across  [m] ditto
/// \return [1/kg]
inline double inverse_mass_at(const SixBySix& K, double along, double across) {
  return K[2][2] + 2.0 * (across * K[2][3] - along * K[2][4]) + across * across * K[3][3] -
         2.0 * across * along * K[3][4] + along * along * K[4][4];
}

/// The nearest point of Coulomb's cone \f$|f| \le \mu p\f$.
/// \param a   [N s] along, across, normal
/// \param mu  [-] at least 0
/// \return [N s]
inline Vec3 into_cone(const Vec3& a, double mu) {
  const double size = std::sqrt(a[0] * a[0] + a[1] * a[1]);
  if (mu * size <= -a[2])
    return Vec3::Zero();  // before the next test, which a pull without friction would pass
  if (size <= mu * a[2]) return a;
  const double p = (a[2] + mu * size) / (1.0 + mu * mu);
  return {mu * p * a[0] / size, mu * p * a[1] / size, p};
}

/// How far a patch is from Coulomb's law at each of its points with the impulses of the direct solver: the largest change that one
/// projection makes, \f$k\,|P_C(\lambda - (u + \mu |u_t|\, n)/k) - \lambda|\f$, u being the motion over its target, and k the inverse
/// mass of the point. What was added to the patch as a whole since then counts as well.
/// \param motion  of its bodies
/// \return [m/s]
[[nodiscard]] double error_at_points(const ContactPatch& patch, const Six& motion);

}  // namespace tumble
