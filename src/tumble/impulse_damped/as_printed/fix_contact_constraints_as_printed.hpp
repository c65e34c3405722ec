/// \file
/// \brief The listing FIXCONTACTCONSTRAINTS as it is printed (thesis 4.4, A.2).
#pragma once

#include "tumble/contact/contact.hpp"
#include "tumble/dynamics/world.hpp"
#include "tumble/impulse_damped/as_printed/printed_objects.hpp"

#include <cstdint>
#include <span>

namespace tumble {

/// What FIXCONTACTCONSTRAINTS did.
struct PrintedFixReport {
  bool ended = true;            ///< whether each loop of line 6 came to its end
  std::int64_t pushes = 0;      ///< times that line 7 was done
  std::int64_t pair_tests = 0;  ///< times that line 6 was asked
  double energy = 0.0;          ///< [J] potential energy added
};

/// FIXCONTACTCONSTRAINTS, one statement for each printed line.
///
/// Contact points are visited from the lowest to the highest; the upper body of each is pushed
/// along the contact's normal, bit by bit, until it is out of the lower one.
///
/// The listing leaves some points open; they are taken as follows. The upper body is the one with the higher centre (the ground
/// has it at height 0); of equals, the second. The list and its normals are those handed in, however
/// old they are (D4). Nothing is said about bodies that cannot be moved (X2), and nothing
/// about an end (X1).
/// \param world     the bodies; changes positions only
/// \param contacts  the contacts, as they were gathered
/// \param eps1      [m] how far a push goes, above 0
/// \param cap       pushes for one contact point after which it is given up, at least 1
/// \param repaired  the errata that are mended: X1 (normal of now, upper body by its direction), X2
/// \throws std::invalid_argument for eps1 or cap out of range, or a contact of a body that there is
///         not
/// \algorithm{FIXCONTACTCONSTRAINTS as printed: appendix A.2}
/// \verified{A loop of pushes that does not end is left at the cap and reported}
PrintedFixReport fix_contact_constraints_as_printed(World& world, std::span<const Contact> contacts,
                                                    double eps1, std::int64_t cap,
                                                    const DampedErrata& repaired);

}  // namespace tumble
