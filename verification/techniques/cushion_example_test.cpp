/// \file
/// \brief Further promises of the example's technique, and its weaknesses.
#include "add_a_technique/cushion.hpp"
#include "impulse_damped/scene_runs.hpp"
#include "support/changed_world.hpp"
#include "support/test.hpp"

namespace {

using example::Cushion;
using example::CushionOptions;

// Cubes that overlap in free space, with chance in their masses and velocities.
World crowd(std::uint64_t seed) {
  World world = weightless_world();
  for (std::uint64_t k = 0; k < 12; ++k) {
    Random chance = Random(seed).fork(k);
    const Vec3 place = chance.in_cube(1.4);
    const Quat turn = chance.orientation();
    const Vec3 push = chance.in_cube(2.0);
    world.add(box_properties(Vec3::Ones(), chance.uniform(0.3, 3.0)), place, turn, push);
  }
  return world;
}

// [m/s] How fast a box goes down a slope on which friction should hold it.
double creep(int substeps) {
  World world = world_of("slope", {{"angle", "10"}});
  Cushion technique({.substeps = substeps});
  run(world, technique, 3.0);
  return fastest_of(world);
}

}  // namespace

TEST_CASE("A cube on springs sinks by (4 - damper) g h² / spring", "[exact][technique]") {
  for (const CushionOptions& options :
       {CushionOptions{}, CushionOptions{0.5, 1.0, 8}, CushionOptions{0.25, 0.5, 2}}) {
    World world = world_of("stack", {{"count", "1"}});
    Cushion technique(options);
    run(world, technique, 5.0);
    const double h = kFrame / options.substeps;
    const double sunk = 0.5 - world.states()[1].position_w.y();
    // A corner of a cube that is free feels a quarter of its mass.
    CHECK(sunk == near((4.0 - options.damper) * kGravity * h * h / options.spring, 1e-9));
  }
}

TEST_CASE("A box that is a hundred times heavier than the one below sinks in by a quarter",
          "[unit][technique]") {
  World world = world_of("stack", {{"count", "2"}, {"top_mass", "100"}});
  Cushion technique;
  const Course course = run(world, technique, 10.0);
  CHECK(course.overlap > 0.2);  // [m] measured 0.26; contact_damped has 2e-11
  CHECK(course.overlap < 0.3);
}

TEST_CASE("A box on springs creeps down a slope, half as fast with twice the substeps",
          "[unit][technique]") {
  const double speed = creep(8);
  CHECK(speed > 1e-3);  // [m/s] measured 5.3e-3; friction should hold it
  CHECK(creep(16) == Approx(0.5 * speed).epsilon(0.01));
}

TEST_CASE("Without gravity springs give back nothing that is not booked", "[exact][technique]") {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    World world = crowd(seed);
    const double energy = energy_of(world).kinetic;
    Cushion technique;
    const Course course = run(world, technique, 1.0);
    CHECK(course.unbooked < 1e-9 * (energy + std::abs(course.booked)));  // [J] rounding
    CHECK(course.booked != 0.0);
  }
}

TEST_CASE("The four corners of a cube on springs carry a quarter of its weight each",
          "[exact][technique]") {
  World world = world_of("stack", {{"count", "1"}});
  Cushion technique;
  run(world, technique, 5.0);
  const auto contacts = technique.contacts();
  REQUIRE(contacts.size() == 4);
  for (const ContactRecord& contact : contacts) {
    CHECK_FALSE(contact.is_impulse);
    CHECK(contact.push_w.y() == near(0.25 * kGravity, 1e-9));  // [N] a quarter of 1 kg
  }
}

TEST_CASE("Springs that would gain energy are refused, and restitution is said to be ignored",
          "[unit][technique]") {
  CHECK_THROWS_WITH(Cushion({.spring = 2.0, .damper = 1.5}),
                    "tumble: spring + 2 damper = 5: expected below 4");
  CHECK_THROWS_WITH(Cushion({.substeps = 0}), "tumble: substeps = 0: expected 1 or more");
  CHECK_THROWS_AS(Cushion({.spring = 0.0}), std::invalid_argument);
  CHECK_THROWS_AS(Cushion({.damper = -0.1}), std::invalid_argument);
  CHECK(Cushion().ignores(world_of("bouncing_box")) == std::vector<std::string>{"restitution"});
  CHECK(Cushion().ignores(world_of("table")).empty());
}
