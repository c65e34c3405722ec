/// \file
/// \brief The listing COLLIDE as it is printed (thesis A.2).
#pragma once

#include "tumble/contact/contact.hpp"
#include "tumble/impulse_damped/as_printed/printed_objects.hpp"

namespace tumble {

/// Whether COLLIDE and the prediction of positions see the velocities that gravity will make.
enum class PrintedGravity : std::uint8_t {
  velocity_no_gravity,   ///< as they are
  velocity_plus_gravity  ///< with gravity added for the time being
};

/// What COLLIDE takes from the step around it.
struct PrintedCollide {
  DampedErrata repaired;          ///< C1 to C4, C6 and C7 are looked at
  Vec3 gravity_w = Vec3::Zero();  ///< [m/s²] GRAVITY_VECTOR, world frame
  double dt = 0.0;                ///< [s] used only where C1 is mended, above 0
  /// [-] Number of a vector's first component (C10). The [1] of the listing is y if it is 0, and x
  /// if it is 1, as the loop of DAMPENOBJECTS counts; a component that does not exist is not
  /// written.
  int index_base = 0;
};

/// What COLLIDE did.
struct PrintedCollision {
  Vec3 point_w = Vec3::Zero();  ///< [m] contact point, world frame
  double impulse = 0.0;         ///< [N s] along the normal, on the second body; below 0 it attracts
  bool approached = false;  ///< whether the bodies approached, though a stable one was not moved
  /// [J] change of kinetic energy by the impulse. With gravity it is that at the middle of the
  /// step, v + g Δt/2, where it is 0 for a body that rests.
  double energy = 0.0;
  double damping = 0.0;  ///< [J] ditto, by lines 11 to 14
};

/// The one contact point of a pair: the centre of the points of its contact area, each weighted by
/// its overlap; equally, if none overlaps (C8).
/// \param collision  the pair, with one point or more
/// \return [m] world frame
[[nodiscard]] Vec3 find_contact_point(const Contact& collision);

/// COLLIDE, one statement for each printed line.
///
/// Gravity is added to both velocities for the time being, an impulse lets the pair part as
/// restitution says, gravity is taken back, and a geometrically stable body loses what it must not
/// have. The impulse is Newton's at one point and without friction,
/// \f[ j = -\frac{(1+e)\,n\cdot u}{n^{\mathsf T} K n} . \f]
///
/// As printed gravity is an acceleration that is added to a velocity (C1), also to that of
/// immovable bodies (C2); stable bodies are freed of vertical momentum when gravity is out of it
/// again (C3) and take part in the impulse like any other body (C4); pairs that part get an
/// impulse, too (C7).
/// \param first        the body that the normal leaves; in and out
/// \param second       the body that the normal enters; in and out
/// \param collision    contact points and normal
/// \param restitution  [-] e, from -1 to 1
/// \param gravity      whether gravity is added for the time being
PrintedCollision collide_as_printed(PrintedObject& first, PrintedObject& second,
                                    const Contact& collision, double restitution,
                                    PrintedGravity gravity, const PrintedCollide& how);

}  // namespace tumble
