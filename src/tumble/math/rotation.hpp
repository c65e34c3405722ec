/// \file
/// \brief Orientations: rotation vectors, turning, and the angle between two.
#pragma once

#include "tumble/base/types.hpp"

namespace tumble {

/// The matrix of a cross product: skew(a) b = a × b.
/// \param a [any] the left factor
/// \return antisymmetric
Mat3 skew(const Vec3& a);

/// The same orientation with length 1.
/// \param q [-] any length from 1e-150 to 1e150
/// \throws std::invalid_argument for a length outside that range or a component not finite
Quat normalised(const Quat& q);

/// Exponential map: the rotation about an axis by an angle.
///
/// \f$q = (\cos\tfrac\theta2,\; \tfrac12 \operatorname{sinc}\tfrac\theta2\; r)\f$ with
/// \f$\theta = |r|\f$, which has no special case at 0.
/// \param rotation_w [rad] axis times angle, world frame, length up to 1e150; may exceed π
/// \return length 1 to rounding; applied from the left it turns in the world frame
/// \throws std::invalid_argument for a vector that is longer or not finite
Quat rotation_from_vector(const Vec3& rotation_w);

/// Logarithm: axis times angle, the shortest way, so q and -q give the same bits.
///
/// The inverse of rotation_from_vector() for angles below π. For exactly half a turn, where both
/// ways are equally short, the first component that is not zero is positive.
/// \param q [-] an orientation; need not be of length 1 exactly
/// \return [rad] length 0 to π
/// \throws std::invalid_argument for a length outside 1e-150 to 1e150 or a component not finite
Vec3 rotation_vector(const Quat& q);

/// Turns an orientation by a constant angular velocity, exactly, and renormalises.
///
/// \f$q(t + \Delta t) = \exp(\Delta t\,\omega)\, q(t)\f$. Adding \f$\tfrac12\Delta t\,\omega q\f$
/// instead would turn by the arc tangent of the half angle and lengthen q.
/// \param q_wb     [-] body to world
/// \param dt       [s] may be negative
/// \return [-] body to world, length 1
/// \throws std::invalid_argument if a value is not finite or q_wb has no direction
Quat turned(const Quat& q_wb, const Vec3& omega_w, double dt);

/// How far a point gets in a time in which it goes along with a frame that turns at a constant rate.
///
/// With \f$\theta = |r|\f$,
/// \f[ V d, \qquad V = 1 + \frac{1-\cos\theta}{\theta^2}\,[r]_\times
///     + \frac{\theta-\sin\theta}{\theta^3}\,[r]_\times^2 , \f]
/// the translation of the exponential of a twist: d is how far it would get on a straight line, at the
/// velocity that it has at the start. All points of a body that turns about an axis at rest keep their
/// distance from that axis.
/// \param rotation_w [rad] r, axis times the angle turned in that time, world frame
/// \param straight_w [m] d, velocity at the start times the time, world frame
/// \return [m] world frame
/// \throws std::invalid_argument for a rotation that is not finite or longer than 1e150
Vec3 along_arc(const Vec3& rotation_w, const Vec3& straight_w);

/// The rate of a rotation vector whose rotation turns at an angular velocity.
///
/// For \f$q(t) = \exp(r(t))\,q_0\f$ and angular velocity \f$\omega\f$,
/// \f[ \dot r = \omega - \tfrac12\, r\times\omega
///     + \frac{1 - \frac\theta2\cot\frac\theta2}{\theta^2}\; r\times(r\times\omega). \f]
/// \param rotation_w [rad] r, shorter than 2π
/// \return [rad/s] \f$\omega\f$ itself if r is 0 or along it
/// \throws std::invalid_argument for a rotation of 2π or more, or one that is not finite
Vec3 rotation_vector_rate(const Vec3& rotation_w, const Vec3& omega_w);

/// The smallest angle that turns one orientation into another (their geodesic distance).
///
/// \f$4 \operatorname{atan2}(\min|p \mp q|,\; \max|p \mp q|)\f$: full relative accuracy for small angles,
/// where the arc cosine of the inner product loses half the digits.
/// \param p [-] length 1
/// \param q [-] length 1
/// \return [rad] 0 to π; 0 exactly for q = ±p
double angle_between(const Quat& p, const Quat& q);

/// An orientation on the way from one to another: the shorter way, about one axis, at an even rate.
/// \param from   [-] length 1
/// \param to     [-] length 1; it and its negative are the same orientation
/// \param share  [-] of the way, 0 to 1
/// \return [-] length 1; `from` itself, bit by bit, if `to` is the same
/// \verified{On the way from one orientation to another the angle grows evenly, the shorter way round}
Quat rotation_between(const Quat& from, const Quat& to, double share);

/// Turns about the world's x axis, then its y axis, then its z axis.
///
/// Multiples of 90 degrees give the exact components 0, ±1/2, ±√½ (rounded once) and ±1.
/// \param xyz_deg [degrees] one angle per axis
/// \return [-] length 1
/// \throws std::invalid_argument for an angle that is not finite
Quat rotation_from_degrees(const Vec3& xyz_deg);

}  // namespace tumble
