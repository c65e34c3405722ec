/// \file
/// \brief The errata of the listings of damped integration (thesis A.2).
#pragma once

#include "tumble/base/errata_set.hpp"

#include <array>

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

}  // namespace tumble
