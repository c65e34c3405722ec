/// \file
/// \brief Contacts and overlap of bodies.
#include "tumble/record/overlap.hpp"

#include "support/test.hpp"

namespace {

void add(World& world, const Vec3& position_w, bool fixed = false,
         const Quat& orientation_wb = Quat::Identity()) {
  const BodyProperties body =
      fixed ? fixed_box_properties(Vec3::Ones()) : box_properties(Vec3::Ones(), 1.0);
  world.add(body, position_w, orientation_wb);
}

}  // namespace

TEST_CASE("How deep a body is in others is the deepest of its pairs", "[exact][record]") {
  World world = ground_world();
  add(world, Vec3(0.0, 0.375, 0.0));        // 1: 1/8 m in the ground
  add(world, Vec3(0.0, 1.3125, 0.0));       // 2: 1/16 m in 1
  add(world, Vec3(0.96875, 1.34375, 0.0));  // 3: 1/32 m in 2
  add(world, Vec3(5.0, 0.5, 0.0));          // 4: on the ground
  add(world, Vec3(9.0, 5.0, 0.0));          // 5: touches no body
  add(world, Vec3(12.0, 0.5, 0.0), true);   // 6 and 7: immovable, in each other
  add(world, Vec3(12.5, 0.5, 0.0), true);
  OverlapMeter meter;
  CHECK(meter.depths().empty());
  CHECK(meter.look(world.bodies(), world.states()) == 0.125);
  const std::vector<double> depths(meter.depths().begin(), meter.depths().end());
  CHECK(depths == std::vector<double>{0.125, 0.125, 0.0625, 0.03125, 0.0, 0.0, 0.0, 0.0});
  const std::vector<char> touching(meter.in_contact().begin(), meter.in_contact().end());
  CHECK(touching == std::vector<char>{1, 1, 1, 1, 1, 0, 0, 0});
}

TEST_CASE(
    "The deepest overlap is that of the body that is deepest, and nothing is kept of earlier looks",
    "[unit][record]") {
  World world;
  add(world, Vec3::Zero());
  add(world, Vec3(0.75, 0.0, 0.0));
  OverlapMeter meter;
  CHECK(meter.look(world.bodies(), world.states()) == 0.25);
  world.set_state(world.ids()[1], make_state(world.bodies()[1], Vec3(1.5, 0.0, 0.0)));
  add(world, Vec3(0.0, 1.0, 0.0), false, rotation_from_vector(Vec3(0.0, 0.0, std::atan(1.0))));
  const double deepest = meter.look(world.bodies(), world.states());
  // A corner of a cube that is turned by an eighth reaches sqrt(1/2) down.
  CHECK(deepest == near(std::sqrt(0.5) - 0.5).epsilon(1e-14));
  REQUIRE(meter.depths().size() == 3);
  CHECK(*std::max_element(meter.depths().begin(), meter.depths().end()) == deepest);
  CHECK(meter.depths()[0] == deepest);
  CHECK(meter.depths()[1] == 0.0);
  world.remove(world.ids()[2]);
  CHECK(meter.look(world.bodies(), world.states()) == 0.0);
  CHECK(meter.depths().size() == 2);

  // No bodies at all.
  CHECK(meter.look({}, {}) == 0.0);
  CHECK(meter.depths().empty());
}
