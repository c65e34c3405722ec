/// \file
/// \brief The errata of the listings of timewarp (thesis A.1).
#pragma once

#include "tumble/base/errata_set.hpp"

#include <array>

namespace tumble {

/// The errata of A.1: T1 to T10 (SIMPLESYNCTIMEWARP) and F1 to F9 (SAFERSYNCTIMEWARP).
inline const ErrataList& errata_of_timewarp() {
  static const ErrataList list(std::array<ErrataGroup, 2>{{{"T", 10}, {"F", 9}}});
  return list;
}

/// Errata of A.1 that are repaired.
using TimewarpErrata = ErrataSetOf<errata_of_timewarp>;

}  // namespace tumble
