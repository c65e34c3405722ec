/// \file
/// \brief Independent judges of the falling column: GSL's integrator of high order, and the size of the
///        gaps to leading order, by quadrature (thesis 6.2).
#pragma once

#include "exterior_rotation/falling_column.hpp"

namespace tumble::chapters {

// Angle and rate of a fall.
struct ReferenceFall {
  double angle = 0.0;  // [rad] of the column's centre, from the vertical
  double rate = 0.0;   // [rad/s]
  double gap = 0.0;    // [m] largest distance between glued points; 0 for one degree of freedom
};

// The pendulum \f$\ddot\phi = p^2\sin\phi\f$ by Prince and Dormand's method of order 8.
// time: [s] since it was released
// phi0: [rad] at the start
ReferenceFall integrated_pendulum(double time, double phi0, int count = 4);

// The cubes as bodies of their own in a plane, with glue and pivot as linear equations for their
// accelerations, by the same method.
//
// Not a line of it is the library's: positions and angles are unknowns, the equations are set up about
// the corners that are glued, and GSL solves them.
// time: [s] since it was released
// phi0: [rad] at the start
ReferenceFall integrated_column(double time, double phi0, int count = 4);

// Gaps of the column at the end of a fall, divided by the step and by the distance of neighbouring
// centres, in the limit of short steps.
//
// With \f$\omega\f$ and \f$\alpha\f$ of the closed form and \f$c = \cos(\phi(T)-\phi)\f$,
// \f$s = \sin(\phi(T)-\phi)\f$:
// \f[ \tfrac12\!\int\!\omega^2 c\,dt, \qquad \int (T-t)\,\omega\alpha\,c\,dt, \qquad
//     2\!\int (T-t)\,\omega\alpha\,c\,dt + \int (T-t)\,\omega^3 s\,dt . \f]
struct GapConstants {
  double impulse = 0.0;        // [1/s] the first
  double semi_implicit = 0.0;  // [1/s] the second
  double forward_euler = 0.0;  // [1/s] the third
};

// Computes them.
// time: [s] T, since it was released
// phi0: [rad] at the start
GapConstants gap_constants(double time, double phi0, int count = 4);

}  // namespace tumble::chapters
