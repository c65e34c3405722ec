/// \file
/// \brief How exactly balance finds the limits of structures, and what friction leaves open (thesis 6.3.1).
#pragma once

#include "driver/figure.hpp"
#include "geometric_stability/balance_probe.hpp"

namespace tumble::chapters {

/// A plank that leans on a wall without friction.
struct LeaningPlank {
  double length = 2.0;     ///< [m]
  double thickness = 0.1;  ///< [m]
  double angle = 60.0;     ///< [deg] from the ground
  double turn = 0.0;       ///< [rad] of plank and wall together, about the vertical
};

/// Builds it.
/// \param plank     see there
/// \param friction  [-] of plank and ground
/// \return ground, wall and plank
Structure leaning_plank(const LeaningPlank& plank, double friction);

/// The coefficient of friction from which a plank stays, by hand.
///
/// Moments about the foot: the wall pushes with \f$m g\,(\cot\theta/2 - t/(2L))\f$, and friction at
/// the foot holds as much, up to \f$\mu m g\f$. For t = 0 that is \f$\tan\theta \ge 1/(2\mu)\f$.
/// \param plank  see there
/// \return [-]
double friction_by_hand(const LeaningPlank& plank);

/// Claim 6.3.1d: errors of all thresholds, and two rules that go level by level, for contrast.
/// \param settings  steps, rows
/// \return tables "" (figure 6.5 against the offset), "stairs" (figure 6.4 against the number of
///         blocks), "edge" (blocks over an edge)
Result measure_thresholds(const Parameters& settings);

/// What balance with friction says and what it does not: a plank between the edges of the pyramid, and a
/// box wedged between two walls.
/// \param settings  angle, edges, friction, duration
/// \return tables "" (the plank against the number of edges), "falls" (the box over time)
Result measure_weakly_stable(const Parameters& settings);

}  // namespace tumble::chapters
