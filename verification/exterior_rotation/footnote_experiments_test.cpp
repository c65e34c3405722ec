/// \file
/// \brief The footnote for joints without glue: contacts found by geometry, and changes of them.

#include "tumble/exterior_rotation/tolerances.hpp"

#include "exterior_rotation/geometric_contacts.hpp"
#include "support/test.hpp"

using namespace tumble::chapters;

namespace {

// A cube of a metre on a fixed one, this far above it.
World cube_above(double gap, double angle = 0.0) {
  World world;
  const BodyProperties base = fixed_box_properties(Vec3::Ones());
  world.add(base, Vec3::Zero());
  const Quat turned(std::cos(0.5 * angle), 0.0, 0.0, std::sin(0.5 * angle));
  world.add(box_properties(Vec3::Ones(), 1.0), Vec3(0.0, 1.0 + gap, 0.0), turned);
  return world;
}

Joint joint_between() { return find_joints(cube_above(0.0), tolerance::glue_margin).at(0); }

// Looks of one joint, step by step.
std::vector<std::vector<ContactSet>> looks_of(const std::vector<ContactSet>& sets) {
  std::vector<std::vector<ContactSet>> looks;
  for (const ContactSet& set : sets) looks.push_back({set});
  return looks;
}

const ContactScheme& scheme_called(const std::string& name) {
  for (const ContactScheme& scheme : contact_schemes())
    if (scheme.name == name) return scheme;
  throw std::invalid_argument(name);
}

}  // namespace

TEST_CASE("A corner touches up to the tolerance, and deeper than it overlaps",
          "[exact][exterior_rotation]") {
  const Joint joint = joint_between();
  const auto seen = [&](double gap, double angle = 0.0) {
    const World world = cube_above(gap, angle);
    return contact_set_of(joint, world.states(), 1e-6);
  };
  CHECK(seen(0.0) == ContactSet{15, false});
  CHECK(seen(0.9e-6) == ContactSet{15, false});
  CHECK(seen(1.1e-6) == ContactSet{0, false});
  CHECK(seen(-0.9e-6) == ContactSet{15, false});
  CHECK(seen(-1.1e-6) == ContactSet{15, true});
  // Turned by 1e-5 one side is 5 µm up, the other one down.
  CHECK(seen(0.0, 1e-5).overlapped);
  const ContactSet tilted = seen(0.0, 1e-5);
  int left = 0;
  for (int k = 0; k < joint.count; ++k)
    if (joint.corners_first_b[idx(k)].x() < 0.0) left |= 1 << k;
  CHECK(tilted.touching == left);
}

TEST_CASE("What touches of a joint is what it holds", "[unit][exterior_rotation]") {
  Joint joint = joint_between();
  REQUIRE(joint.count == 4);
  const auto held = [&](int touching) {
    hold_what_touches({touching, false}, joint);
    return joint.hold;
  };
  CHECK(held(15) == JointHold::area);
  CHECK(held(0) == JointHold::nothing);
  for (int k = 0; k < 4; ++k) {
    CHECK(held(1 << k) == JointHold::corner);
    CHECK(joint.side == k);
    CHECK(held((1 << k) | (1 << (k + 1) % 4)) == JointHold::edge);
    CHECK(joint.side == k);
    CHECK(held(15 ^ (1 << k)) == JointHold::area);
  }
  CHECK(held(5) == JointHold::area);  // across the area
  joint.count = 2;
  CHECK(held(3) == JointHold::edge);
  CHECK(joint.side == 0);
  CHECK(held(2) == JointHold::corner);
  CHECK(joint.side == 1);
}

TEST_CASE("Changes of contact are found step by step, touching and overlap each by itself",
          "[unit][exterior_rotation]") {
  const std::vector<ContactChange> changes =
      changes_of(looks_of({{15, false}, {15, false}, {3, true}, {12, true}, {0, false}}));
  REQUIRE(changes.size() == 5);
  CHECK((changes[0].step == 2 && changes[0].kind == ChangeKind::lost && changes[0].touching == 3));
  CHECK((changes[1].step == 2 && changes[1].kind == ChangeKind::overlap));
  CHECK(
      (changes[2].step == 3 && changes[2].kind == ChangeKind::found && changes[2].touching == 12));
  CHECK((changes[3].step == 4 && changes[3].kind == ChangeKind::lost));
  CHECK((changes[4].step == 4 && changes[4].kind == ChangeKind::cleared));
  CHECK(changes_of({}).empty());
  CHECK(changes_of(looks_of({{15, false}})).empty());
}

TEST_CASE("A right change answers for one change, of the same joint, within two steps",
          "[unit][exterior_rotation]") {
  const ContactChange right{10, 1, ChangeKind::lost, 3};
  const auto at = [&](int step) {
    ContactChange change = right;
    change.step = step;
    return change;
  };
  CHECK(changes_not_in({at(8)}, {right}, 2).empty());
  CHECK(changes_not_in({at(12)}, {right}, 2).empty());
  CHECK(changes_not_in({at(7)}, {right}, 2).size() == 1);
  CHECK(changes_not_in({at(13)}, {right}, 2).size() == 1);
  CHECK(changes_not_in({at(9), at(11)}, {right}, 2).size() == 1);
  CHECK(changes_not_in({at(9), at(11)}, {right, at(12)}, 2).empty());
  CHECK(changes_not_in({{10, 2, ChangeKind::lost, 3}}, {right}, 2).size() == 1);
  CHECK(changes_not_in({{10, 1, ChangeKind::found, 3}}, {right}, 2).size() == 1);
  CHECK(changes_not_in({{10, 1, ChangeKind::lost, 12}}, {right}, 2).size() == 1);
}

TEST_CASE(
    "Contacts found by geometry hold a box, release one that is lifted, and stop one that lands",
    "[unit][exterior_rotation]") {
  constexpr double dt = 1.0 / 60.0;
  for (const char* name : {"semi-implicit", "impulse", "midpoint", "rk4"}) {
    World world = cube_above(0.0);
    GeometricContacts contacts(scheme_called(name), 1e-6);
    for (int n = 0; n < 10; ++n) contacts.advance(world, dt);
    CHECK((world.states()[1].position_w - Vec3(0.0, 1.0, 0.0)).norm() < 1e-12);
    CHECK(contacts.joints()[0].hold == JointHold::area);
    // Lifted for a while.
    world.gravity_w = Vec3(0.0, 9.81, 0.0);
    for (int n = 0; n < 6; ++n) contacts.advance(world, dt);
    CHECK(contacts.joints()[0].hold == JointHold::nothing);
    CHECK(world.states()[1].position_w.y() > 1.03);  // [m] g t² / 2 is 0.049
    // It falls back: at the end it is where a step has taken it, and at rest.
    world.gravity_w = Vec3(0.0, -9.81, 0.0);
    for (int n = 0; n < 60; ++n) contacts.advance(world, dt);
    CHECK(contacts.joints()[0].hold == JointHold::area);
    CHECK(world.states()[1].linear_momentum_w.norm() < 1e-12);
    CHECK(contacts.look(world)[0].touching == 15);
    CHECK(world.states()[1].position_w.y() < 1.0 + 1e-6);
    CHECK(world.states()[1].position_w.y() > 0.9);
  }
}

TEST_CASE("With glue what touches holds against a pull, and without it does not",
          "[unit][exterior_rotation]") {
  for (const char* name : {"semi-implicit", "impulse"}) {
    for (const bool glue : {true, false}) {
      World world = cube_above(0.0);
      world.gravity_w = Vec3(0.0, 9.81, 0.0);
      GeometricContacts contacts(scheme_called(name), 1e-6, glue);
      for (int n = 0; n < 30; ++n) contacts.advance(world, 1.0 / 60.0);
      CHECK((world.states()[1].position_w.y() < 1.0 + 1e-9) == glue);
    }
  }
}

TEST_CASE("Tolerances and steps of geometric contacts out of range are refused",
          "[unit][exterior_rotation]") {
  for (const double tolerance : {0.0, -1e-6, kNan})
    CHECK_THROWS_AS(GeometricContacts(contact_schemes()[0], tolerance), std::invalid_argument);
  World world = cube_above(0.0);
  GeometricContacts contacts(contact_schemes()[0], 1e-6);
  for (const double dt : {0.0, -1.0, kNan})
    CHECK_THROWS_AS(contacts.advance(world, dt), std::invalid_argument);
}
