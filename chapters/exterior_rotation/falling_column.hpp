/// \file
/// \brief The column of figure 6.1 as if it were one body: closed forms, by GSL, and measures of the
///        simulated one (thesis 6.2).
#pragma once

#include "tumble/dynamics/world.hpp"

namespace tumble::chapters {

/// From the pivot to the centre of a column of unit cubes that stands on its lower right edge.
/// \param count  cubes, 1 or more
/// \return [m] R, half of the diagonal
double column_radius(int count = 4);

/// The rate of a column's fall, \f$p = \sqrt{3g/4R}\f$.
/// \param count  cubes, 1 or more
/// \return [1/s]
double column_frequency(int count = 4);

/// Lean of a column less that of its centre: \f$\alpha = \arctan(1/n)\f$.
/// \param count  n, cubes, 1 or more
/// \return [rad] tilt of the column's axis less the angle of its centre from the vertical
double column_tilt(int count = 4);

/// The angle of the centre of a glued column that falls from rest.
///
/// The pendulum \f$\ddot\phi = p^2\sin\phi\f$, solved by Jacobi's elliptic functions with modulus
/// \f$k = \cos\tfrac{\phi_0}2\f$:
/// \f[ \tan\tfrac\phi2 = \frac{\sin\frac{\phi_0}2}{k\operatorname{cn}(pt)} . \f]
/// \param time   [s] since it was released
/// \param phi0   [rad] at the start, above 0 and below pi
/// \param count  cubes
/// \return [rad] as seen from the pivot, from the vertical, falling
double column_angle(double time, double phi0, int count = 4);

/// Rate of that angle.
/// \param time   [s] since it was released
/// \param phi0   [rad] at the start, above 0 and below pi
/// \param count  cubes
/// \return [rad/s]
double column_rate(double time, double phi0, int count = 4);

/// Rate of a column that has fallen to an angle: \f$\sqrt{2p^2(\cos\phi_0 - \cos\phi)}\f$.
/// \param angle  [rad] phi, phi0 to pi
/// \param phi0   [rad] at the start
/// \param count  cubes
/// \return [rad/s]
double column_rate_at(double angle, double phi0, int count = 4);

/// When a column has fallen to an angle: the inverse of column_angle(), by an elliptic integral.
/// \param angle  [rad] phi, phi0 to pi
/// \param phi0   [rad] at the start, above 0
/// \param count  cubes
/// \return [s] since it was released
double column_time(double angle, double phi0, int count = 4);

/// Force of the larger box on a column at the pivot.
struct PivotForce {
  double normal = 0.0;      ///< [N] upwards
  double tangential = 0.0;  ///< [N] horizontal, in the direction of the fall
};

/// The force at the pivot while a column of 1 kg cubes falls from rest.
///
/// \f$N/Mg = 1 - \tfrac34\sin^2\phi - \tfrac32(\cos\phi_0-\cos\phi)\cos\phi\f$ and
/// \f$T/Mg = \tfrac34\sin\phi\cos\phi - \tfrac32(\cos\phi_0-\cos\phi)\sin\phi\f$, with M of all cubes.
/// \param angle  [rad] phi, phi0 to pi
/// \param phi0   [rad] at the start
/// \param count  cubes
/// \return as it is just then
PivotForce pivot_force(double angle, double phi0, int count = 4);

/// Force of the lower part of a column on its upper part.
struct GlueForce {
  double shear = 0.0;      ///< [N] across the column, towards the side that is above (backwards)
  double normal = 0.0;     ///< [N] along the column, above 0 if pressed
  double from_edge = 0.0;  ///< [m] centre of pressure from the edge on the pivot's side, across
};

/// The glue forces while a column of 1 kg cubes falls from rest.
/// \param joint  1 between the lowest two cubes, up to count - 1
/// \param angle  [rad] phi of the column's centre, phi0 to pi
/// \param phi0   [rad] at the start
/// \param count  cubes
/// \return as they are just then
GlueForce glue_force(int joint, double angle, double phi0, int count = 4);

/// Where a joint without glue would open first if all others held: its centre of pressure is at the edge
/// far from the pivot's side.
/// \param joint  1 between the lowest two cubes, up to count - 1
/// \param phi0   [rad] at the start, below 0.6
/// \param count  cubes
/// \return [rad] phi of the column's centre; the column's own tilt is column_tilt() more
/// \throws std::runtime_error if it holds until the centre is level with the pivot
double opening_angle(int joint, double phi0, int count = 4);

/// The world of figure 6.1.
/// \param angle  [rad] of the column's centre, as seen from the pivot, from the vertical
/// \param spin   [rad/s] falling
/// \param count  cubes, 2 to 20
/// \return the scene "fig6_1"; of its bodies the cubes are those that are movable, the lowest first
World column_world(double angle, double spin = 0.0, int count = 4);

/// The pivot of column_world().
/// \return [m] on top of the larger box
Vec3 column_pivot();

/// The angle of the centre of all movable bodies about the pivot.
/// \param world  column_world(), later
/// \return [rad] phi, from the vertical, falling; -pi to pi
double centre_angle(const World& world);

/// By how much neighbouring centres of the column are too far apart, along the lowest cube's axis.
/// \param world  column_world(), later
/// \return [m] above 0 a gap, below 0 overlap; of all neighbours the one with the largest magnitude
double column_gap(const World& world);

}  // namespace tumble::chapters
