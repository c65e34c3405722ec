/// \file
/// \brief The listing DAMPENOBJECTS as it is printed (thesis A.2).
#pragma once

#include "tumble/dynamics/advance_pose.hpp"
#include "tumble/dynamics/world.hpp"
#include "tumble/impulse_damped/as_printed/printed_objects.hpp"
#include "tumble/impulse_damped/damped_numbers.hpp"

#include <cstdint>
#include <span>

namespace tumble {

/// The constants of the listing as it has them: the same for all bodies and all steps.
struct PrintedNumbers {
  DampedThresholds eps;  ///< absolute
  DampedFactors k;       ///< of a step, however long it is (DM8)
};

/// Changes of DAMPENOBJECTS: its energy and its bodies.
struct DampenReport {
  double damping = 0.0;  ///< [J] change of kinetic energy in lines 4 to 21
  double repair = 0.0;   ///< [J] change of potential energy in lines 26 to 28
  int damped = 0;        ///< bodies in contact
  int moved = 0;         ///< bodies advanced
  int frozen = 0;        ///< movable bodies put back in lines 27 and 28
};

/// DAMPENOBJECTS, one statement for each printed line.
///
/// Momenta of bodies in contact are scaled, small components are set to 0, boxes that lie nearly flat
/// are turned upright, then all bodies move, and each that has hardly moved is put back.
///
/// The listing leaves some points open; they are taken as follows. Index 0 is x, as in COLLIDE, so that a loop from 1 to 3 comes
/// by y, by z, and by a component that does not exist (DM2). `isSmall(x, ε)` is x < ε (DM4). An
/// alignment without tolerance is exact (DM16). Of two orientations the four numbers are subtracted
/// (DM13). STANDARD_GRAVITY adds g Δt to the velocity that bodies move with, although line 3 of
/// DAMPEDINTEGRATION has done so already (D5). The box is turned about its centre (DM14). Old poses
/// are those right before line 22.
/// \param touched   by index: whether the body has had a contact interaction. When that is forgotten
///                  again is not said (DM5): it is the caller's
/// \param repaired  the errata that are mended. D5, DM1 to DM4, DM13 and DM16 make a difference
/// \throws std::invalid_argument if there is not one flag for each body, or for a dt not above 0
/// \algorithm{DAMPENOBJECTS as printed: appendix A.2}
/// \verified{With all its misprints, the listing ends whatever is negative along y and z}
DampenReport dampen_objects_as_printed(World& world, std::span<const std::uint8_t> touched,
                                       const PrintedNumbers& numbers, double dt,
                                       RotationRule rotation, const DampedErrata& repaired);

}  // namespace tumble
