/// \file
/// \brief The pushes of FIXCONTACTCONSTRAINTS.
#include "tumble/impulse_damped/fix_contact_constraints.hpp"
#include "tumble/impulse_damped/pair_gatherer.hpp"

#include "support/test.hpp"

namespace {

FixReport fix(World& world) {
  PairGatherer gatherer(NormalRule::separation, PointRule::area);
  ContactList contacts;
  gatherer.gather(world, world.states(), world.states(), nullptr, 0.0, contacts);
  FixContactConstraints constraints;
  return constraints.run(world, contacts, DampedNumbers{}, kFrame);
}

BodyId add_cube(World& world, const Vec3& position_w, double mass = 2.0) {
  return world.add(box_properties(Vec3::Ones(), mass), position_w);
}

}  // namespace

TEST_CASE("A box in the ground is lifted by whole pushes and left with a gap below one",
          "[exact][impulse_damped]") {
  World world = ground_world();
  add_cube(world, Vec3(0.0, 0.4975, 0.0));
  const double before = energy_of(world).total();
  const FixReport report = fix(world);
  CHECK(report.pushes == 3);  // of 1 mm, out of 2.5 mm
  CHECK(report.given_up == 0);
  CHECK(world.states()[1].position_w.y() == near(0.5005, 1e-15));
  // All of it is booked; rounding of 10 J.
  CHECK(report.energy == near(energy_of(world).total() - before, 1e-14));
  CHECK(fix(world).pushes == 0);
}

TEST_CASE("A stack pressed into itself is put right from the ground up in one pass",
          "[exact][impulse_damped]") {
  World world = ground_world();
  for (int k = 0; k < 5; ++k) add_cube(world, Vec3(0.0, 0.49 + 0.99 * k, 0.0));
  fix(world);
  for (std::size_t k = 1; k <= 5; ++k) {
    const double below = k == 1 ? -0.5 : world.states()[k - 1].position_w.y();
    const double gap = world.states()[k].position_w.y() - below - 1.0;
    CHECK(gap >= -1e-12);  // roundings count as apart
    CHECK(gap < 1e-3);     // one push
  }
}

TEST_CASE("Under a fixed shelf the box goes down, and the shelf stays", "[exact][impulse_damped]") {
  World world;
  const BodyProperties shelf = fixed_box_properties(Vec3(2.0, 0.1, 2.0));
  world.add(shelf, Vec3(0.0, 2.0, 0.0));
  add_cube(world, Vec3(0.0, 1.4515, 0.0));
  const FixReport report = fix(world);
  CHECK(report.pushes == 2);  // out of 1.5 mm
  CHECK(report.energy < 0.0);
  CHECK(world.states()[0].position_w == Vec3(0.0, 2.0, 0.0));
  CHECK(world.states()[1].position_w.y() == near(1.4495, 1e-15));
}

TEST_CASE("The pushes end though there is no room", "[exact][impulse_damped]") {
  World world = ground_world();
  const BodyProperties shelf = fixed_box_properties(Vec3(2.0, 0.1, 2.0));
  world.add(shelf, Vec3(0.0, 0.95, 0.0));  // 0.9 m above the ground
  add_cube(world, Vec3(0.0, 0.45, 0.0));
  const FixReport report = fix(world);
  CHECK(report.pushes <= 16 * FixContactConstraints::kMostPushes);
  CHECK(world.states()[2].position_w.allFinite());
}
