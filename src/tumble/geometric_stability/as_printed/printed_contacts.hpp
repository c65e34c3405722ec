/// \file
/// \brief Contact points in the terms of the appendix's listings (thesis 4.4, 5.4, A.2).
#pragma once

#include "tumble/contact/contact.hpp"
#include "tumble/dynamics/world.hpp"

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

}  // namespace tumble
