/// \file
/// \brief Yielding of a pair of bodies to an impulse at a point (thesis 2.5.1, 5.2).
#pragma once

#include "tumble/contact/moving_body.hpp"

namespace tumble {

/// Velocity of a body's material at a point, \f$v + \omega \times r\f$.
/// \return [m/s] world frame
inline Vec3 velocity_at(const MovingBody& body, const Vec3& point_w) {
  return body.velocity_w + body.angular_velocity_w.cross(point_w - body.position_w);
}

/// Velocity of the second body's material as seen from the first one's, at a point.
/// \return [m/s] world frame, \f$u = v_{second} - v_{first}\f$
inline Vec3 relative_velocity(const MovingBody& first, const MovingBody& second,
                              const Vec3& point_w) {
  return velocity_at(second, point_w) - velocity_at(first, point_w);
}

/// The inverse mass of one body as felt at a point.
///
/// \f[ K = \operatorname{diag}(m^{-1}) - [r]_\times\, I_w^{-1}\, [r]_\times \f]
/// An impulse j at the point changes the velocity there by K j.
/// \return [1/kg] symmetric, positive semidefinite; 0 for an immovable body
Mat3 inverse_mass_at(const MovingBody& body, const Vec3& point_w);

/// The inverse mass of a pair as felt at a point: the sum of both.
///
/// An impulse j on the second body and -j on the first change u of relative_velocity() by K j.
/// \return [1/kg] symmetric, positive semidefinite; positive definite as soon as one of the bodies
///         is movable along all three axes
/// \see Mirtich, Canny, "Impulse-based simulation of rigid bodies", I3D 1995.
Mat3 inverse_mass_at(const MovingBody& first, const MovingBody& second, const Vec3& point_w);

/// The mass of a pair as felt at a point along a direction, \f$1 / (n^{\mathsf T} K n)\f$.
/// \param direction_w  [-] world frame, length 1
/// \return [kg] infinite if neither body can be moved that way
double effective_mass(const MovingBody& first, const MovingBody& second, const Vec3& point_w,
                      const Vec3& direction_w);

/// Applies an impulse to a pair: to the second body, and its opposite to the first.
/// \param first      changed unless immovable
/// \param second     changed unless immovable
/// \param point_w    [m] where it acts, world frame
/// \param impulse_w  [N s] on the second body, world frame
void apply_impulse(MovingBody& first, MovingBody& second, const Vec3& point_w,
                   const Vec3& impulse_w);

/// Two directions across a normal.
struct Tangents {
  Vec3 first_w = Vec3::UnitX();   ///< [-] length 1
  Vec3 second_w = Vec3::UnitZ();  ///< [-] length 1, across the first
};

/// Chooses two directions that make a right-handed frame (first, second, normal).
/// \return always the same two for the same normal. They jump where its smallest component
///         changes, so nothing that a user sees may depend on the choice
Tangents tangents_of(const Vec3& normal_w);

}  // namespace tumble
