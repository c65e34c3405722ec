/// \file
/// \brief Bodies as impulses see them: velocities, and how easily they are changed.
#pragma once

#include "tumble/dynamics/world.hpp"

#include <span>
#include <vector>

namespace tumble {

/// A body as impulses see it: how it moves, and how easily it is moved.
///
/// Solvers work on an array of these, one for each body index, and write the velocities back into
/// the momenta at their end. A technique may make a body heavier than it is (infinitely heavy for
/// shock propagation, or along chosen axes for geometric stability) by changing the inverses.
struct MovingBody {
  Vec3 velocity_w = Vec3::Zero();          ///< [m/s] of the centre of mass, world frame
  Vec3 angular_velocity_w = Vec3::Zero();  ///< [rad/s] world frame
  Vec3 position_w = Vec3::Zero();          ///< [m] centre of mass, world frame
  Vec3 inverse_mass = Vec3::Zero();        ///< [1/kg] along the world's axes; 0 is immovable
  Mat3 inverse_inertia_w = Mat3::Zero();   ///< [1/(kg m²)] world frame; 0 cannot turn
  /// Whether a velocity was changed since it was loaded. Code that changes one sets this
  /// (apply_impulse() does); bodies without it keep the bits of their momenta.
  bool changed = false;
};

/// The speed of a body's fastest point.
/// \return [m/s] an upper bound: |v| + half the diagonal times |omega|
[[nodiscard]] inline double fastest_point_speed(const BodyProperties& body, const Vec3& velocity_w,
                                                const Vec3& angular_velocity_w) {
  return velocity_w.norm() + 0.5 * body.size.norm() * angular_velocity_w.norm();
}

/// The speed of the fastest point in the change of a body's velocity, in the sense of fastest_point_speed().
/// \return [m/s]
[[nodiscard]] inline double fastest_point_change(const BodyProperties& body, const MovingBody& from,
                                                 const MovingBody& to) {
  return fastest_point_speed(body, to.velocity_w - from.velocity_w,
                             to.angular_velocity_w - from.angular_velocity_w);
}

/// Reads the velocity of a body, \f$v = P/m\f$ and \f$\omega = I_w^{-1} L\f$.
[[nodiscard]] MovingBody moving_body_of(const BodyProperties& body, const BodyState& state);

/// Writes the velocity of a body back, \f$P = m v\f$ and \f$L = I_w\,\omega\f$, if it was changed.
/// \param moving  as loaded from this body
/// \param body    its constant part; its mass and inertia are used, whatever the inverses were set to
/// \param state   momenta in and out; nothing happens to those of an immovable body
void store_moving_body(const MovingBody& moving, const BodyProperties& body, BodyState& state);

/// Reads the velocities of all bodies, \f$v = P/m\f$ and \f$\omega = I_w^{-1} L\f$.
/// \param out  one for each body index, none of them changed. Its capacity is kept
void load_moving_bodies(const World& world, std::vector<MovingBody>& out);

/// Writes the velocities of changed bodies back, \f$P = m v\f$ and \f$L = I_w\,\omega\f$.
///
/// Mass and inertia are those of the world, whatever the inverses were set to in between.
/// Momenta of immovable bodies stay 0. Positions are not written.
/// \param bodies  as loaded from this world, one for each body index
/// \param world   the bodies; momenta in and out
/// \throws std::invalid_argument if there is not one entry for each body
void store_moving_bodies(std::span<const MovingBody> bodies, World& world);

}  // namespace tumble
