/// \file
/// \brief The column of figure 6.1 pushed along without turning (claim 6.2a).
#pragma once

#include "exterior_rotation/held_run.hpp"

namespace tumble::chapters {

// The column upright and alone, without gravity: as on a ground without friction, which carries its
// weight and does nothing else.
World lone_column(int boxes);

// The effect of a push.
struct PushedRun {
  double gap = 0.0;    // [m] largest opening or overlap of any joint after any step
  double way = 0.0;    // [m] of the first cube
  double force = 0.0;  // [N] largest in the glue
  std::vector<double>
      gaps;  // [m] largest magnitude of all joints, at the start and after each step
};

// Pushes the column sideways, half of the push at the middle of each of its two middle cubes (all of it
// at that of the middle one of an odd number), and steps as the thesis does.
//
// The glue's forces are right at the beginning of each step and held over it, \f$x^+ = x + h v\f$ and
// \f$v^+ = v + h a\f$. The push goes through the centre of the column, so nothing turns, and the
// acceleration is what JointForces::project() makes of the accelerations without glue.
// push: [N] of all cubes together
// dt: [s] of a step, above 0
PushedRun push_column(int boxes, double push, double dt, int steps);

}  // namespace tumble::chapters
