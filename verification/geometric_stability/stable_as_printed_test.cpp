/// \file
/// \brief The listing SETGEOMETRICALLYSTABLE as printed, with and without its misprints.
#include "tumble/geometric_stability/as_printed/set_geometrically_stable_as_printed.hpp"

#include "support/test.hpp"
#include "support/touching.hpp"

namespace {

constexpr PrintedStabilityRepairs all{.both_bodies = true,
                                      .vetoes_last = true,
                                      .immovable = true,
                                      .fresh_corners = true,
                                      .rising = true,
                                      .tolerances = true};

std::vector<bool> stable(const World& world, const ContactList& contacts,
                         const PrintedStabilityRepairs& repairs) {
  std::vector<PrintedStability> bodies(world.states().size());
  set_geometrically_stable_as_printed(world, contacts, repairs, bodies);
  std::vector<bool> flags;
  for (const PrintedStability& body : bodies) flags.push_back(body.stable);
  return flags;
}

void add_cube(World& world, const Vec3& place_w) {
  world.add(box_properties(Vec3::Ones(), 1.0), place_w);
}

}  // namespace

TEST_CASE("As printed, a stack of cubes is stable from the ground up",
          "[exact][geometric_stability]") {
  World world = ground_world();
  for (int k = 0; k < 4; ++k) add_cube(world, Vec3(0.0, 0.5 + k, 0.0));
  const std::vector<bool> every(5, true);
  CHECK(stable(world, contacts_within(world, 1e-9), {}) == every);
  CHECK(stable(world, contacts_within(world, 1e-9), all) == every);
}

TEST_CASE("As printed, a cube on a corner of another one is not stable, nor is its load",
          "[exact][geometric_stability]") {
  World world;  // figure 5.3
  world.add_ground();
  add_cube(world, Vec3(0.0, 0.5, 0.0));
  add_cube(world, Vec3(0.25, 1.5, 0.25));
  add_cube(world, Vec3(0.25, 2.5, 0.25));
  const std::vector<bool> expected = {true, true, false, false};
  CHECK(stable(world, contacts_within(world, 1e-9), {}) == expected);
  CHECK(stable(world, contacts_within(world, 1e-9), all) == expected);
}

TEST_CASE("As printed, a plank across two cubes is stable if rounding is allowed for",
          "[exact][geometric_stability]") {
  World world;  // figure 5.5
  world.add_ground();
  add_cube(world, Vec3(-1.0, 0.5, 0.0));
  add_cube(world, Vec3(1.0, 0.5, 0.0));
  world.add(box_properties(Vec3(2.5, 0.25, 0.5), 1.0), Vec3(0.0, 1.125, 0.0));
  // Its corners lie in larger faces: contact points are below them up to rounding (G8).
  CHECK(stable(world, contacts_within(world, 1e-9), {.tolerances = true}) ==
        std::vector<bool>(4, true));
  CHECK(stable(world, contacts_within(world, 1e-9), {}) ==
        std::vector<bool>{true, true, true, false});
}

TEST_CASE("Mended, the order of contacts does not change which bodies are stable",
          "[exact][geometric_stability]") {
  // Two cubes and a fixed block support a plank, and the block touches one of the cubes.
  const auto by_ids = [](const Contact& a, const Contact& b) {
    return std::pair(a.first, a.second) < std::pair(b.first, b.second);
  };
  for (const bool block_first : {true, false}) {
    World world = ground_world();
    const BodyProperties block = fixed_box_properties(Vec3::Ones());
    const auto add_block = [&] { world.add(block, Vec3(-2.0, 0.5, 0.0)); };
    if (block_first) add_block();
    add_cube(world, Vec3(-1.0, 0.5, 0.0));
    if (!block_first) add_block();
    add_cube(world, Vec3(1.0, 0.5, 0.0));
    world.add(box_properties(Vec3(4.0, 0.25, 1.0), 1.0), Vec3(-0.5, 1.125, 0.0));
    ContactList contacts = contacts_within(world, 1e-9);
    const std::vector<bool> expected = {true, block_first, !block_first, true, false};
    const std::vector<bool> printed = stable(world, contacts, {});

    int orders = 0;
    int mended_changes = 0;
    int printed_changes = 0;
    do {
      if (stable(world, contacts, all) != expected) ++mended_changes;
      if (stable(world, contacts, {}) != printed) ++printed_changes;
      ++orders;
    } while (std::next_permutation(contacts.begin(), contacts.end(), by_ids));
    CAPTURE(block_first, printed_changes);
    CHECK(orders == 720);  // six contacts
    CHECK(mended_changes == 0);
    if (block_first) CHECK(printed_changes > 0);
  }
}

TEST_CASE("A list of bodies of the wrong length is refused", "[unit][geometric_stability]") {
  World world;
  add_cube(world, Vec3::Zero());
  std::vector<PrintedStability> none;
  CHECK_THROWS_WITH(set_geometrically_stable_as_printed(world, {}, all, none),
                    Contains("bodies: 0 entries for 1 bodies"));
  Contact beyond{.second = 1, .count = 1};
  std::vector<PrintedStability> one(1);
  CHECK_THROWS_WITH(set_geometrically_stable_as_printed(world, {&beyond, 1}, all, one),
                    Contains("contact of body 1: there are 1"));
}
