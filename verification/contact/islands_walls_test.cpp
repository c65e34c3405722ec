/// \file
/// \brief Tests of groups of touching bodies some of which count as walls.
#include "tumble/base/random.hpp"
#include "tumble/contact/islands.hpp"

#include "contact/island_cases.hpp"
#include "support/allocation_counter.hpp"
#include "support/catch.hpp"

#include <utility>
#include <vector>

namespace {

using namespace tumble;
using namespace tumble::test;
using Catch::Matchers::Contains;

std::vector<char> walls_from(const char* letters) {
  std::vector<char> walls;
  for (; *letters != '\0'; ++letters) walls.push_back(*letters == 'w' ? 1 : 0);
  return walls;
}

}  // namespace

TEST_CASE("A wall counts as an immovable body does, on random contacts and on pairs",
          "[exact][islands]") {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    Random random(seed);
    const std::uint32_t count = 2 + random.below(20);
    std::vector<BodyProperties> bodies;
    std::vector<BodyProperties> fixed;  // the same, walls being immovable
    std::vector<char> walls;
    for (std::uint32_t b = 0; b < count; ++b) {
      walls.push_back(random.below(4) == 0 ? 1 : 0);
      bodies.push_back(box_properties(Vec3::Ones(), 1.0));
      fixed.push_back(walls.back() != 0 ? fixed_box_properties(Vec3::Ones()) : bodies.back());
    }
    std::vector<IndexPair> pairs;
    std::vector<Contact> contacts;
    for (std::uint32_t k = random.below(2 * count); k > 0; --k) {
      const int first = static_cast<int>(random.below(count));
      const int second = static_cast<int>(random.below(count));
      if (first == second) continue;
      pairs.push_back({first, second});
      contacts.push_back(touching(first, second));
    }
    Islands expected;
    expected.build(fixed, contacts);
    Islands by_contacts;
    by_contacts.build(bodies, contacts, walls);
    Islands by_pairs;
    by_pairs.build_from_pairs(bodies, pairs, walls);
    INFO("seed " << seed);
    REQUIRE(by_contacts.count() == expected.count());
    REQUIRE(by_pairs.count() == expected.count());
    for (int i = 0; i < expected.count(); ++i) {
      CHECK(list(by_contacts.bodies(i)) == list(expected.bodies(i)));
      CHECK(list(by_contacts.contacts(i)) == list(expected.contacts(i)));
      CHECK(list(by_pairs.bodies(i)) == list(expected.bodies(i)));
      CHECK(list(by_pairs.contacts(i)) == list(expected.contacts(i)));
    }
  }
}

TEST_CASE("Walls of another number than bodies are refused", "[unit][islands]") {
  Islands islands;
  const std::vector<char> two(2, 0);
  CHECK_THROWS_WITH(islands.build(bodies_from("mmm"), {}, two), Contains("2 entries for 3 bodies"));
  CHECK_THROWS_WITH(islands.build_from_pairs(bodies_from("m"), {}, two),
                    Contains("2 entries for 1 bodies"));
}

TEST_CASE("Warm islands with walls ask for no memory", "[unit][islands]") {
  const std::vector<BodyProperties> bodies = bodies_from("fmwm");
  const std::vector<char> walls = walls_from("fmwm");
  const std::vector<Contact> contacts{touching(0, 1), touching(1, 2), touching(2, 3)};
  Islands islands;
  islands.build(bodies, contacts, walls);
  const AllocationCount requests;
  islands.build(bodies, contacts, walls);
  CHECK(requests.value() == 0);
}
