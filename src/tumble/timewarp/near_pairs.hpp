/// \file
/// \brief Pairs to be searched again after some bodies have collided.
#pragma once

#include "tumble/base/index.hpp"
#include "tumble/geometry/broad_phase.hpp"

#include <algorithm>
#include <span>

namespace tumble {

/// Visits once each pair of a listed body and any other body whose bounds overlap.
/// \param bodies    indices of the listed bodies, ascending
/// \param searched  gets an index; false: no pair starts from this body
template <class Searched, class Visit>
void for_each_near_pair(std::span<const int> bodies, const Searched& searched,
                        std::span<const Bounds> bounds, const Visit& visit) {
  for (const int body : bodies) {
    if (!searched(body)) continue;
    for (int other = 0; other < static_cast<int>(bounds.size()); ++other) {
      if (other == body || !overlap(bounds[idx(body)], bounds[idx(other)])) continue;
      // A pair of two listed bodies is found twice.
      const bool again = other < body && searched(other) &&
                         std::binary_search(bodies.begin(), bodies.end(), other);
      if (!again) visit(IndexPair{std::min(body, other), std::max(body, other)});
    }
  }
}

}  // namespace tumble
