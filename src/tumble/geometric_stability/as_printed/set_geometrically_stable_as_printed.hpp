/// \file
/// \brief The listing SETGEOMETRICALLYSTABLE as it is printed (thesis 5.4, A.2).
#pragma once

#include "tumble/contact/contact.hpp"
#include "tumble/dynamics/world.hpp"

#include <cstdint>
#include <span>

namespace tumble {

/// What SETGEOMETRICALLYSTABLE knows of a body. The caller keeps it from step to step.
struct PrintedStability {
  bool stable = false;       ///< whether the body is geometrically stable
  std::uint8_t corners = 0;  ///< a bit for each of its four lower corners: marked
};

/// Which errata of SETGEOMETRICALLYSTABLE are mended.
struct PrintedStabilityRepairs {
  bool both_bodies = false;      ///< G2: a contact with another normal speaks against both bodies
  bool vetoes_last = false;      ///< G3: what speaks against a body cannot be overruled later
  bool immovable = false;        ///< G4: nothing speaks against an immovable body
  bool fresh_corners = false;    ///< G5: corners are unmarked at the start
  bool rising = false;           ///< G7: a body that goes up is not stable
  bool tolerances = false;       ///< G8: directions and corners are compared with tolerances
  double upward_momentum = 0.0;  ///< [kg m/s] G7: from which on a body goes up, at least 0
};

/// SETGEOMETRICALLYSTABLE, one statement for each printed line.
///
/// Bodies are stable if they are immovable. Then contact points are visited from the lowest to the
/// highest: one on a stable body, with a normal straight down, marks the corner that it lies under,
/// and with four marks the upper body is stable; any other one makes it unstable, unless its normal
/// points straight up.
///
/// What is not said is taken as follows. The top object is the one with the higher centre; of equals,
/// the second. In line 13 the contact is asked for its body (G1; the listing asks the body). Corners
/// are those of the face that looks down most. Equal means equal (G8).
/// \param world     the bodies
/// \param contacts  who touched whom when they were gathered
/// \param repairs   the errata that are mended
/// \param bodies    one for each body index; in and out
/// \throws std::invalid_argument if there is not one entry for each body, or a contact of a body that
///         there is not
/// \algorithm{SETGEOMETRICALLYSTABLE as printed: appendix A.2}
/// \verified{As printed, a stack of cubes is stable from the ground up}
void set_geometrically_stable_as_printed(const World& world, std::span<const Contact> contacts,
                                         const PrintedStabilityRepairs& repairs,
                                         std::span<PrintedStability> bodies);

}  // namespace tumble
