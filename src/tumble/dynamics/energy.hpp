/// \file
/// \brief Conserved quantities of a closed system: energy and momenta of a whole world.
#pragma once

#include "tumble/dynamics/world.hpp"

namespace tumble {

/// Mechanical energy of the movable bodies.
struct Energy {
  double kinetic = 0.0;    ///< [J] of translation and rotation, at least 0
  double potential = 0.0;  ///< [J] in gravity; 0 with the centre of mass at the origin

  /// Both [J].
  [[nodiscard]] double total() const { return kinetic + potential; }
};

/// Energy of one body.
/// \return \f$\tfrac12 P\cdot v + \tfrac12 L\cdot\omega\f$ and \f$-m\,g\cdot x\f$, which is m g
///         times the height above y = 0 for the usual gravity; 0 for an immovable body
Energy energy_of(const BodyProperties& body, const BodyState& state, const Vec3& gravity_w);

/// Energy of all movable bodies, summed in the order of the ids [J].
Energy energy_of(const World& world);

/// Energy to lift each movable body by its longest edge, \f$\sum m\,g\,L\f$: with the kinetic energy, the scale of
/// energy that is gained or lost by mistake.
/// \return [J] 0 without gravity
double lifting_energy(const World& world);

/// Linear momentum of all movable bodies, summed in the order of the ids [kg m/s], world frame.
Vec3 linear_momentum(const World& world);

/// Angular momentum of all movable bodies about the origin, \f$\sum x \times P + L\f$ [kg m²/s], world frame.
Vec3 angular_momentum(const World& world);

}  // namespace tumble
