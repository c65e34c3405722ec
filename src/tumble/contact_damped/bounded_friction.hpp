/// \file
/// \brief Friction of a contact patch: force and moment under one bound, solved exactly.
#pragma once

#include "tumble/base/types.hpp"

namespace tumble {

/// The impulse within a ball that removes most of the kinetic energy:
/// \f[ \min_{|\lambda| \le l} \tfrac12 \lambda^T A \lambda + u^T \lambda. \f]
/// It stops the motion, \f$A\lambda + u = 0\f$, if the ball allows it; otherwise it is at the bound and
/// directly against the remaining motion, \f$A\lambda + u = -\beta\lambda\f$ with \f$\beta > 0\f$. That is
/// Coulomb's law for two directions of friction and, with the moment over a lever as the third, for a patch.
/// \param inverse_mass  A: motion of a unit impulse, symmetric and positive definite
/// \param motion        u: the motion without friction
/// \param limit         l: at least 0
/// \return the impulse; 0 if the limit is
/// \note Cofactors once, then a few Newton steps on \f$1/|\lambda(\beta)|\f$, from below.
/// \see Moré and Sorensen 1983, Computing a trust region step; Howe and Cutkosky 1996 for the bound.
Vec3 bounded_friction(const Mat3& inverse_mass, const Vec3& motion, double limit);

}  // namespace tumble
