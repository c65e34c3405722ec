/// \file
/// \brief The errata of the listings of timewarp (thesis A.1).
#include "tumble/timewarp/as_printed/timewarp_errata.hpp"

#include <array>

namespace tumble {

const ErrataList& errata_of_timewarp() {
  static const ErrataList list(std::array<ErrataGroup, 2>{{{"T", 10}, {"F", 9}}});
  return list;
}

}  // namespace tumble
