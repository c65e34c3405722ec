/// \file
/// \brief Tests of groups of touching bodies.
#include "tumble/contact/islands.hpp"

#include "support/test.hpp"

namespace {

// One body for each letter.
std::vector<BodyProperties> bodies_from(std::string_view letters) {
  std::vector<BodyProperties> bodies;
  for (const char letter : letters)
    bodies.push_back(letter == 'f' ? fixed_box_properties(Vec3::Ones())
                                   : box_properties(Vec3::Ones(), 1.0));
  return bodies;
}

// A contact of two bodies, wherever it is.
Contact touching(int first, int second) { return Contact{.first = first, .second = second}; }

// Numbers that can be compared.
std::vector<int> list(std::span<const int> numbers) { return {numbers.begin(), numbers.end()}; }

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

}  // namespace

TEST_CASE("Two heaps on one ground are two islands", "[unit][islands]") {
  Islands islands;
  islands.build(bodies_from("fmmmm"),
                std::vector<Contact>{touching(0, 1), touching(2, 4), touching(0, 2), touching(1, 3),
                                     touching(0, 4)});
  REQUIRE(islands.count() == 2);
  CHECK(list(islands.bodies(0)) == std::vector<int>{1, 3});
  CHECK(list(islands.bodies(1)) == std::vector<int>{2, 4});
  CHECK(list(islands.contacts(0)) == std::vector<int>{0, 3});
  CHECK(list(islands.contacts(1)) == std::vector<int>{1, 2, 4});
  CHECK(islands.island_of(0) == Islands::kNone);
  CHECK(islands.island_of(4) == 1);
}

TEST_CASE("Islands agree with brute force on random contacts, in any order",
          "[exact][determinism][islands]") {
  int wrong = 0;
  Islands islands;
  Islands again;
  for (std::uint64_t seed = 1; seed <= 500; ++seed) {
    Random random(seed);
    auto [bodies, contacts] = RandomContacts(random);
    const std::size_t count = bodies.size();
    islands.build(bodies, contacts);

    // Brute force: spread the smallest index along contacts until nothing changes.
    std::vector<int> smallest(count);
    for (std::size_t b = 0; b < count; ++b) smallest[b] = static_cast<int>(b);
    for (bool changed = true; changed;) {
      changed = false;
      for (const Contact& contact : contacts) {
        const auto a = static_cast<std::size_t>(contact.first);
        const auto b = static_cast<std::size_t>(contact.second);
        if (!bodies[a].movable() || !bodies[b].movable() || smallest[a] == smallest[b]) continue;
        smallest[a] = smallest[b] = std::min(smallest[a], smallest[b]);
        changed = true;
      }
    }
    int last = -1;
    std::size_t bodies_seen = 0;
    for (int k = 0; k < islands.count(); ++k) {
      const std::vector<int> members = list(islands.bodies(k));
      if (members.front() <= last) ++wrong;  // islands ascend by their smallest body
      last = members.front();
      if (!std::ranges::is_sorted(members)) ++wrong;
      for (const int body : members)
        if (smallest[idx(body)] != members.front() || islands.island_of(body) != k ||
            !bodies[idx(body)].movable())
          ++wrong;
      bodies_seen += members.size();
      const std::vector<int> touched = list(islands.contacts(k));
      if (!std::ranges::is_sorted(touched)) ++wrong;
      for (const int c : touched) {
        const Contact& contact = contacts[idx(c)];
        if (islands.island_of(contact.first) != k && islands.island_of(contact.second) != k)
          ++wrong;
      }
    }
    for (const BodyProperties& body : bodies) bodies_seen += body.movable() ? 0U : 1U;
    if (bodies_seen != count) ++wrong;

    for (std::size_t i = contacts.size(); i > 1; --i)
      std::swap(contacts[i - 1], contacts[random.below(static_cast<std::uint32_t>(i))]);
    again.build(bodies, contacts);
    for (int b = 0; b < static_cast<int>(count); ++b)
      if (again.island_of(b) != islands.island_of(b)) ++wrong;
  }
  CHECK(wrong == 0);
}

TEST_CASE("A contact of a body that there is not is refused", "[unit][islands]") {
  Islands islands;
  const auto bodies = bodies_from("mm");
  CHECK_THROWS_WITH(islands.build(bodies, std::vector<Contact>{touching(0, 2)}),
                    Contains("0 and 2") && Contains("below 2"));
  CHECK_THROWS_AS(islands.build(bodies, std::vector<Contact>{touching(-1, 1)}),
                  std::invalid_argument);
}

TEST_CASE("A wall counts as an immovable body does, on random contacts and on pairs",
          "[exact][islands]") {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    Random random(seed);
    const RandomContacts fixed(random);
    std::vector<BodyProperties> bodies;  // the same, but movable
    std::vector<char> walls;
    for (const BodyProperties& body : fixed.bodies) {
      bodies.push_back(box_properties(Vec3::Ones(), 1.0));
      walls.push_back(body.movable() ? 0 : 1);
    }
    std::vector<IndexPair> pairs;
    for (const Contact& contact : fixed.contacts) pairs.push_back({contact.first, contact.second});
    Islands expected;
    expected.build(fixed.bodies, fixed.contacts);
    Islands by_contacts;
    by_contacts.build(bodies, fixed.contacts, walls);
    Islands by_pairs;
    by_pairs.build_from_pairs(bodies, pairs, walls);
    INFO("seed " << seed);
    for (const Islands* found : {&by_contacts, &by_pairs}) {
      REQUIRE(found->count() == expected.count());
      for (int i = 0; i < expected.count(); ++i) {
        CHECK(list(found->bodies(i)) == list(expected.bodies(i)));
        CHECK(list(found->contacts(i)) == list(expected.contacts(i)));
      }
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
