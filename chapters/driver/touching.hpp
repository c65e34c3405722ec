/// \file
/// \brief The contacts of a world without a broad phase, for experiments and tests.
#pragma once

#include "tumble/contact/gather.hpp"

#include <vector>

namespace tumble::chapters {

// All pairs of bodies.
inline std::vector<IndexPair> all_pairs(const World& world) {
  std::vector<IndexPair> pairs;
  for (int a = 0; a < world.count(); ++a)
    for (int b = a + 1; b < world.count(); ++b) pairs.push_back({a, b});
  return pairs;
}

// The contacts of all pairs of bodies.
// margin: [m] surfaces up to this far apart count as touching
inline ContactList contacts_within(const World& world, double margin) {
  std::vector<MovingBody> moving;
  load_moving_bodies(world, moving);
  ContactList contacts;
  gather_contacts(world, moving, all_pairs(world), margin, {}, contacts);
  return contacts;
}

}  // namespace tumble::chapters
