/// \file
/// \brief The listing SETGEOMETRICALLYSTABLE as printed (thesis 5.4, A.2).
#pragma once

#include "tumble/contact/contact.hpp"
#include "tumble/dynamics/world.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace tumble {

/// A contact point in the terms of FIXCONTACTCONSTRAINTS and SETGEOMETRICALLYSTABLE.
///
/// The listings do not define the upper one of two bodies. Here it is the one with the higher centre
/// (that of the ground is at height 0); of equals, the second.
struct PrintedContact {
  int upper = 0;                         ///< index of the upper body
  int lower = 0;                         ///< index of the lower body
  Vec3 lower_to_upper_w = Vec3::Zero();  ///< [-] the contact's normal, world frame
  Vec3 point_w = Vec3::Zero();           ///< [m] world frame
};

/// All contact points, the lowest first; of equals, the one that comes first in the list.
/// \param world     the bodies; their present poses decide which of two is the upper one
/// \param contacts  contacts when they were gathered
/// \throws std::invalid_argument for a contact of an unknown body
[[nodiscard]] std::vector<PrintedContact> sort_contact_points_ascending(
    const World& world, std::span<const Contact> contacts);

/// State of a body in SETGEOMETRICALLYSTABLE. The caller keeps it from step to step.
struct PrintedStability {
  bool stable = false;       ///< whether the body is geometrically stable
  std::uint8_t corners = 0;  ///< a bit for each marked lower corner
};

/// Errata of SETGEOMETRICALLYSTABLE that are mended.
struct PrintedStabilityRepairs {
  bool both_bodies = false;      ///< G2: a contact with another normal is a veto for both bodies
  bool vetoes_last = false;      ///< G3: a veto cannot be overruled later
  bool immovable = false;        ///< G4: there is no veto for an immovable body
  bool fresh_corners = false;    ///< G5: corners are unmarked at the start
  bool rising = false;           ///< G7: a rising body is not stable
  bool tolerances = false;       ///< G8: directions and corners are compared with tolerances
  double upward_momentum = 0.0;  ///< [kg m/s] G7: a body with more is rising, at least 0
};

/// SETGEOMETRICALLYSTABLE, one statement for each printed line.
///
/// Immovable bodies are stable. Then contact points are visited from the lowest to the highest: one on
/// a stable body, with a normal straight down, marks the corner above it, and with four marks the
/// upper body is stable; any other one makes it unstable, unless its normal points straight up.
///
/// The listing leaves some points open. The top object is the one with the higher centre; of equals,
/// the second. In line 13 the contact is asked for its body (G1; the listing asks the body). Corners
/// are those of the lowest face. Comparisons are exact (G8).
/// \param contacts  contacts when they were gathered
/// \param bodies    one for each body index; in and out
/// \throws std::invalid_argument if there is not one entry for each body, or for a contact of an unknown
///         body
/// \algorithm{SETGEOMETRICALLYSTABLE as printed: appendix A.2}
/// \verified{As printed, a stack of cubes is stable from the ground up}
void set_geometrically_stable_as_printed(const World& world, std::span<const Contact> contacts,
                                         const PrintedStabilityRepairs& repairs,
                                         std::span<PrintedStability> bodies);

}  // namespace tumble
