/// \file
/// \brief The column of figure 6.1 as if it were one body: closed forms, by GSL, and measures of the
///        simulated one (thesis 6.2).
#pragma once

#include "tumble/dynamics/world.hpp"

namespace tumble::chapters {

// From the pivot to the centre of a column of unit cubes that stands on its lower right edge.
// Returns [m] R, half of the diagonal
double column_radius(int count = 4);

// The rate of a column's fall, \f$p = \sqrt{3g/4R}\f$ [1/s].
double column_frequency(int count = 4);

// Lean of a column less that of its centre: \f$\alpha = \arctan(1/n)\f$.
// Returns [rad] tilt of the column's axis less the angle of its centre from the vertical
double column_tilt(int count = 4);

// The angle of the centre of a glued column that falls from rest.
//
// The pendulum \f$\ddot\phi = p^2\sin\phi\f$, solved by Jacobi's elliptic functions with modulus
// \f$k = \cos\tfrac{\phi_0}2\f$:
// \f[ \tan\tfrac\phi2 = \frac{\sin\frac{\phi_0}2}{k\operatorname{cn}(pt)} . \f]
// time: [s] since it was released
// phi0: [rad] at the start, above 0 and below pi
// Returns [rad] as seen from the pivot, from the vertical, falling
double column_angle(double time, double phi0, int count = 4);

// Rate of that angle.
// time: [s] since it was released
// phi0: [rad] at the start, above 0 and below pi
// Returns [rad/s]
double column_rate(double time, double phi0, int count = 4);

// Force of the lower part of a column on its upper part.
struct GlueForce {
  double shear = 0.0;      // [N] across the column, towards the side that is above (backwards)
  double normal = 0.0;     // [N] along the column, above 0 if pressed
  double from_edge = 0.0;  // [m] centre of pressure from the edge on the pivot's side, across
};

// The glue forces while a column of 1 kg cubes falls from rest.
// angle: [rad] phi of the column's centre, phi0 to pi
// phi0: [rad] at the start
GlueForce glue_force(int joint, double angle, double phi0, int count = 4);

// The world of figure 6.1.
// angle: [rad] of the column's centre, as seen from the pivot, from the vertical
// spin: [rad/s] falling
World column_world(double angle, double spin = 0.0, int count = 4);

// The pivot of column_world() [m], on top of the larger box.
Vec3 column_pivot();

// The angle of the centre of all movable bodies about the pivot.
// Returns [rad] phi, from the vertical, falling; -pi to pi
double centre_angle(const World& world);

// By how much neighbouring centres of the column are too far apart, along the lowest cube's axis.
// Returns [m] above 0 a gap, below 0 overlap; of all neighbours the one with the largest magnitude
double column_gap(const World& world);

}  // namespace tumble::chapters
