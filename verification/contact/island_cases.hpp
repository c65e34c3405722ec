/// \file
/// \brief Bodies and contacts without geometry, for tests of islands.
#pragma once

#include "tumble/contact/contact.hpp"

#include <span>
#include <string_view>
#include <vector>

namespace tumble::test {

// One body for each letter.
inline std::vector<BodyProperties> bodies_from(std::string_view letters) {
  std::vector<BodyProperties> bodies;
  for (const char letter : letters)
    bodies.push_back(letter == 'f' ? fixed_box_properties(Vec3::Ones())
                                   : box_properties(Vec3::Ones(), 1.0));
  return bodies;
}

// A contact of two bodies, wherever it is.
inline Contact touching(int first, int second) {
  Contact contact;
  contact.first = first;
  contact.second = second;
  return contact;
}

// Numbers that can be compared.
inline std::vector<int> list(std::span<const int> numbers) {
  return {numbers.begin(), numbers.end()};
}

}  // namespace tumble::test
