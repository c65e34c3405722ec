/// \file
/// \brief Load-proof bodies: motion, and contacts from outside.
#include "tumble/geometric_stability/load_proof.hpp"

#include "support/test.hpp"
#include "support/touching.hpp"

namespace tumble {
namespace {

// Cubes of an edge of 1 m whose lower faces are at the given places, on the ground.
struct Cubes {
  World world;
  ContactList contacts;

  explicit Cubes(const std::vector<Vec3>& feet) {
    world.add_ground();
    for (const Vec3& foot : feet)
      world.add(box_properties(Vec3::Ones(), 1.0), foot + Vec3(0.0, 0.5, 0.0));
    find_contacts();
  }

  void find_contacts() { contacts = test::contacts_within(world, 1e-9); }

  // The number of movable load-proof bodies.
  int load_proof() const {
    std::vector<char> stable;
    LoadProof().run(world, contacts, stable);
    return std::accumulate(stable.begin(), stable.end(), 0) - 1;
  }
};

}  // namespace

TEST_CASE("A cube that tips or sinks is not load-proof, one that slides is",
          "[unit][geometric_stability]") {
  Cubes cubes({Vec3::Zero()});
  const BodyId id = cubes.world.ids()[1];
  CHECK(cubes.load_proof() == 1);
  cubes.world.set_velocity(id, Vec3(1.0, 0.0, 0.0), Vec3(0.0, 1.0, 0.0));
  CHECK(cubes.load_proof() == 1);
  cubes.world.set_velocity(id, Vec3::Zero(), Vec3(0.0, 0.0, 1.0));
  CHECK(cubes.load_proof() == 0);
  cubes.world.set_velocity(id, Vec3(0.0, -1.0, 0.0), Vec3::Zero());
  CHECK(cubes.load_proof() == 0);
}

TEST_CASE("Cubes side by side are load-proof until one of them is not",
          "[unit][geometric_stability]") {
  Cubes two({Vec3::Zero(), Vec3(1.0, 0.0, 0.0)});
  CHECK(two.load_proof() == 2);
  two.world.set_velocity(two.world.ids()[2], Vec3::Zero(), Vec3(0.0, 0.0, 1.0));
  CHECK(two.load_proof() == 0);
  // A cube on top that overhangs by three quarters falls, and presses from above only.
  CHECK(Cubes({Vec3::Zero(), Vec3(1.0, 0.0, 0.0), Vec3(1.75, 1.0, 0.0)}).load_proof() == 2);
}

TEST_CASE("A ceiling that presses is no harm, gravity from the side is",
          "[unit][geometric_stability]") {
  Cubes cubes({Vec3::Zero()});
  cubes.world.add(fixed_box_properties(Vec3(3.0, 1.0, 3.0)), Vec3(0.0, 1.5, 0.0));
  cubes.find_contacts();
  CHECK(cubes.contacts.size() == 2);
  CHECK(cubes.load_proof() == 2);  // the ceiling counted
  cubes.world.gravity_w = Vec3(-9.81, 0.0, 0.0);
  CHECK(cubes.load_proof() == 1);
}

}  // namespace tumble
