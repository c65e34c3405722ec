/// \file
/// \brief The errata of the listings of timewarp (thesis A.1).
#pragma once

#include "tumble/base/errata_set.hpp"

namespace tumble {

/// The errata of A.1: T1 to T10 (SIMPLESYNCTIMEWARP) and F1 to F9 (SAFERSYNCTIMEWARP).
const ErrataList& errata_of_timewarp();

/// Errata of A.1 that are repaired.
using TimewarpErrata = ErrataSetOf<errata_of_timewarp>;

}  // namespace tumble
