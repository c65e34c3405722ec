/// \file
/// \brief For how long two bodies in flight surely stay apart (thesis 3.2, 5.1).
#pragma once

#include "tumble/dynamics/flight.hpp"

namespace tumble {

/// For how long two bodies surely stay apart.
///
/// closing_bound() lets every corner come forward as fast as it can at all. That makes little of a
/// gap that is small while bodies spin past each other, and the search creeps. For bodies that turn at
/// a constant rate ω (all moments of inertia equal, or no spin) more is known. A plane with normal n
/// that turns at a rate ν keeps two boxes apart as long as no corner crosses it: with the arms
/// \f$\rho_1, \rho_2\f$ of two corners and the centres' difference d, they are apart along it by
/// \f[ s(\tau) \ge n\cdot(d - \rho_1 + \rho_2) + \tau\,\bigl(n\cdot\dot d + (\nu\times n)\cdot d
///      - n\cdot((\omega_1-\nu)\times\rho_1) + n\cdot((\omega_2-\nu)\times\rho_2)\bigr)
///      - \tfrac12 A\,\tau^2, \f]
/// \f[ A = (|\omega_1|+|\nu|)^2|\rho_1| + (|\omega_2|+|\nu|)^2|\rho_2| + |\nu|^2 |d|_{max}
///      + 2|\nu||\dot d|_{max} + |\ddot d|, \f]
/// and the shortest time of the 64 pairs of corners is safe. The plane turns with the face that it
/// lies in, or so that it keeps holding both of the edges that it lies between: with the plane that
/// touches both boxes the first two terms are those of the gap itself, and the search converges like
/// Newton's method, from the safe side.
/// \param gap   their separation at the time, not below 0, as gap_at() gives it
/// \param time  [s] from which on, not before the valid times
/// \param end   [s] until when
/// \return [s] the longer of this and of the time that closing_bound() allows; infinite: for ever
/// \verified{Bodies that spin past each other are searched in a few steps}
double safe_flight(const Flight& flight, const IndexPair& pair, const Separation& gap, double time,
                   double end);

}  // namespace tumble
