/// \file
/// \brief The least value of a quadratic function within a ball, found exactly.
#pragma once

#include "tumble/base/types.hpp"

namespace tumble {

/// The point of a ball about 0 at which a quadratic function is least, a *trust region problem*:
/// \f[ \min_{|\lambda| \le r} \tfrac12 \lambda^T A \lambda + u^T \lambda. \f]
/// It is where the slope vanishes, \f$A\lambda + u = 0\f$, if that is in the ball; otherwise it is on the sphere and
/// directly against the remaining slope, \f$A\lambda + u = -\beta\lambda\f$ with \f$\beta > 0\f$. With A the
/// motion of a unit impulse and u the motion without friction, that is Coulomb's law for two directions of friction and,
/// with the moment over a lever as the third, for a contact patch.
/// \param A       [any] symmetric and positive definite
/// \param u       [any] slope at 0
/// \param radius  [any] of the ball; at least 0
/// \return the point; 0 if the radius is
/// \note Cofactors once, then a few Newton steps on \f$1/|\lambda(\beta)|\f$, from below.
/// \see Moré and Sorensen 1983, Computing a trust region step; Howe and Cutkosky 1996 for friction.
/// \verified{Friction within a ball stops the motion\, or is at the bound and directly against the remaining one}
[[nodiscard]] Vec3 minimum_in_ball(const Mat3& A, const Vec3& u, double radius);

}  // namespace tumble
