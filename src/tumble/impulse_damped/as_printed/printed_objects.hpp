/// \file
/// \brief Bodies as the listings of damped integration see them, and the errata of these (thesis A.2).
#pragma once

#include "tumble/base/errata_set.hpp"
#include "tumble/contact/moving_body.hpp"
#include "tumble/dynamics/advance_pose.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace tumble {

/// The errata of A.2: D1 to D6 (DAMPEDINTEGRATION), C1 to C11 (COLLIDE), RK1 to RK4 and RC1 to RC4
/// (RESOLVECOLLISIONS, RESOLVECONTACTS), DM1 to DM17 (DAMPENOBJECTS), X1 to X7
/// (FIXCONTACTCONSTRAINTS) and G1 to G8 (SETGEOMETRICALLYSTABLE).
inline const ErrataList& errata_of_damped_integration() {
  static const ErrataList list(std::array<ErrataGroup, 7>{
      {{"D", 6}, {"C", 11}, {"RK", 4}, {"RC", 4}, {"DM", 17}, {"X", 7}, {"G", 8}}});
  return list;
}

/// Errata of A.2 that are repaired.
using DampedErrata = ErrataSetOf<errata_of_damped_integration>;

/// One body as the listings see it: with a velocity and with a momentum.
///
/// The listings write both (C6) and do not say which one is stored. As printed they are two stores:
/// an impulse changes both, a statement that names one changes that one. A stage begins with
/// \f$v = P/m\f$, so what was written to a velocity only is lost at its end. Mended, there is one
/// store, and writing one of them changes the other.
struct PrintedObject {
  MovingBody moving;                       ///< velocities; position: the predicted centre
  Vec3 linear_momentum_w = Vec3::Zero();   ///< [kg m/s] world frame
  Vec3 angular_momentum_w = Vec3::Zero();  ///< [kg m²/s] world frame
  double mass = 1.0;                       ///< [kg] infinite for an immovable body
  Mat3 inertia_w = Mat3::Zero();           ///< [kg m²] world frame; 0 for an immovable body
  bool movable = true;                     ///< whether its mass is finite
  bool geometrically_stable = false;       ///< as SETGEOMETRICALLYSTABLE left it
  bool one_store = false;                  ///< C6 mended

  /// Writes the velocity.
  /// \param value [m/s] world frame
  void set_velocity(const Vec3& value);

  /// Writes a component of the linear momentum.
  /// \param axis   0, 1 or 2: x, y or z
  /// \param value  [kg m/s] world frame
  void set_linear_momentum(int axis, double value);

  /// Writes a component of the angular momentum.
  /// \param value  [kg m²/s] world frame
  void set_angular_momentum(int axis, double value);

  /// Changes velocities and momenta alike, as an impulse does.
  /// \param velocity_w          [m/s] to be added, world frame
  /// \param angular_velocity_w  [rad/s] ditto
  void change(const Vec3& velocity_w, const Vec3& angular_velocity_w);

  /// Kinetic energy of the momenta.
  /// \param boost_w  [m/s] added to the velocity before
  /// \return [J] 0 for an immovable body
  [[nodiscard]] double kinetic_energy(const Vec3& boost_w) const;
};

/// The bodies of a world as the listings see them, and the positions that they are put back to.
class PrintedObjects {
 public:
  /// Begins a stage: velocities out of momenta.
  /// \param stable    by index: whether a body is geometrically stable
  /// \param fixed_w   [m/s] by index: velocities that immovable bodies were given (D6)
  /// \param repaired  C6 and RC4 are looked at
  void begin(const World& world, std::span<const std::uint8_t> stable,
             std::span<const Vec3> fixed_w, const DampedErrata& repaired);

  /// integrateObjectPositions of the listings, \f$x + \Delta t\,(v + a)\f$.
  /// \param world    poses in and out; momenta are not touched
  /// \param ahead_w  [m/s] a: 0 or what gravity will add in the step
  /// \return how many bodies were moved
  int integrate_positions(World& world, double dt, const Vec3& ahead_w, RotationRule rule);

  /// revertToOriginalPositions of the listings. RC4: positions, as the name has it; mended, the
  /// orientations as well.
  void revert_to_original_positions(World& world) const;

  /// Ends a stage: momenta of bodies that were changed go into the world.
  void end(World& world) const;

  /// The objects: one for each body index.
  [[nodiscard]] std::span<PrintedObject> all() { return objects_; }

 private:
  std::vector<PrintedObject> objects_;
  std::vector<BodyState> original_;
  bool whole_pose_ = false;  // RC4 mended
};

}  // namespace tumble
