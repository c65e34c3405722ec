/// \file
/// \brief Bodies and contacts without geometry, for tests of islands.
#pragma once

#include "tumble/base/random.hpp"
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
inline Contact touching(int first, int second) { return Contact{.first = first, .second = second}; }

// Numbers that can be compared.
inline std::vector<int> list(std::span<const int> numbers) {
  return {numbers.begin(), numbers.end()};
}

// Bodies, a quarter of them immovable, and contacts between some of them.
struct RandomContacts {
  explicit RandomContacts(Random& random) {
    const std::uint32_t count = 2 + random.below(25);
    for (std::uint32_t b = 0; b < count; ++b)
      bodies.push_back(random.below(4) == 0 ? fixed_box_properties(Vec3::Ones())
                                            : box_properties(Vec3::Ones(), 1.0));
    for (std::uint32_t k = random.below(2 * count); k > 0; --k) {
      const auto first = static_cast<int>(random.below(count));
      const auto second = static_cast<int>(random.below(count));
      if (first != second) contacts.push_back(touching(first, second));
    }
  }
  std::vector<BodyProperties> bodies;
  std::vector<Contact> contacts;
};

}  // namespace tumble::test
