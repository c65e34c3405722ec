/// \file
/// \brief The size of the falling column's gaps to leading order, by quadrature (thesis 6.2).
#pragma once

#include "exterior_rotation/falling_column.hpp"

namespace tumble::chapters {

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
