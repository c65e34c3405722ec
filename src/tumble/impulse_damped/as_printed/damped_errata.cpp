/// \file
/// \brief The errata of the listings of damped integration (thesis A.2).
#include "tumble/impulse_damped/as_printed/damped_errata.hpp"

#include <array>

namespace tumble {

const ErrataList& errata_of_damped_integration() {
  static const ErrataList list(std::array<ErrataGroup, 7>{
      {{"D", 6}, {"C", 11}, {"RK", 4}, {"RC", 4}, {"DM", 17}, {"X", 7}, {"G", 8}}});
  return list;
}

}  // namespace tumble
