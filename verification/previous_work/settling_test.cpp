/// \file
/// \brief Settling without velocities, and its quadratic program.
#include "tumble/previous_work/settling.hpp"

#include "impulse_damped/scene_runs.hpp"
#include "support/test.hpp"

namespace {

// Force and torque of all contacts on a body.
struct Load {
  Vec3 force_w = Vec3::Zero(), torque_w = Vec3::Zero();
};

Load load_on(const World& world, const Technique& technique, std::size_t body) {
  Load load;
  for (const ContactRecord& contact : technique.contacts()) {
    const double sign = contact.second == world.ids()[body]  ? 1.0
                        : contact.first == world.ids()[body] ? -1.0
                                                             : 0.0;
    load.force_w += sign * contact.push_w;
    load.torque_w +=
        sign * (contact.point_w - world.states()[body].position_w).cross(contact.push_w);
  }
  return load;
}

}  // namespace

TEST_CASE("The nearest motion of a cube above the ground stops at the ground",
          "[exact][settling]") {
  World world = ground_world();
  world.add(box_properties(Vec3::Ones(), 2.0), Vec3(0.0, 0.6, 0.0));
  std::vector<MovingBody> bodies = moving_bodies(world);
  ContactList contacts;
  const IndexPair pair{0, 1};
  gather_contacts(world, bodies, {&pair, 1}, 1.0, {}, contacts);
  REQUIRE(contacts.size() == 1);
  const std::vector<double> gaps(4, 0.1);
  bodies[1].velocity_w = Vec3(0.3, -0.4, 0.0);
  NearestMotion program;
  const DescentReport found = program.solve(bodies, contacts, gaps, 1e-12, 1000);
  CHECK(found.settled);
  CHECK((bodies[1].velocity_w - Vec3(0.3, -0.1, 0.0)).norm() < 1e-12);
  CHECK(bodies[1].angular_velocity_w.norm() < 1e-12);
  double push = 0.0;
  for (int k = 0; k < 4; ++k) push += contacts[0].points[idx(k)].normal_impulse;
  CHECK(push == near(2.0 * 0.3, 1e-11));  // m times what is missing
  CHECK(program.multiplications() >= 16);
}

TEST_CASE("A free box falls by the reach in each step of settling, whatever its speed",
          "[exact][settling]") {
  World world;
  world.add(box_properties(Vec3(1.0, 0.5, 2.0), 3.0), Vec3::Zero(), Quat::Identity(),
            Vec3(4.0, 5.0, 0.0), Vec3(1.0, 2.0, 3.0));
  Settling technique({.reach = 0.2});
  for (int k = 0; k < 10; ++k) technique.step(world, kFrame);
  CHECK((world.states()[0].position_w - Vec3(0.0, -10.0 * 0.2 * 0.5, 0.0)).norm() < 1e-14);
  CHECK(angle_between(world.states()[0].orientation_wb, Quat::Identity()) == 0.0);
  CHECK(energy_of(world).kinetic == 0.0);
}

TEST_CASE("Settled boxes carry their weight with the forces of a minimum", "[exact][settling]") {
  for (const std::uint64_t seed : {1ULL, 2ULL}) {
    World world = world_of("clump", {{"per_edge", "2"}}, seed);
    Settling technique;
    double energy = energy_of(world).potential;
    const double start = energy;
    for (int k = 0; k < 200; ++k) {
      technique.step(world, kFrame);
      const double now = energy_of(world).potential;
      CHECK(now < energy + 0.01 * start);  // [J] overlap that is put right lifts a little
      energy = now;
    }
    for (std::size_t k = 1; k < world.bodies().size(); ++k) {
      const double weight = world.bodies()[k].mass * kGravity;
      const Load load = load_on(world, technique, k);
      CAPTURE(seed, k);
      CHECK((load.force_w - Vec3(0.0, weight, 0.0)).norm() < 1e-6 * weight);  // measured: 1e-9
      CHECK(load.torque_w.norm() < 1e-6 * weight);
    }
  }
}

TEST_CASE("A box on an edge topples into its well, and a stack stays", "[exact][settling]") {
  World drop = world_of("box_drop");
  Settling topples;
  run(drop, topples, 3.0);
  CHECK(drop.states()[1].position_w.y() == near(0.5, 1e-6));
  World stack = world_of("stack");
  const World start = stack;
  Settling stays;
  run(stack, stays, 1.0);
  CHECK(distance_of(stack, start) < 1e-6);  // [m]
}

TEST_CASE("Settling refuses what makes no sense and says what it leaves out", "[unit][settling]") {
  CHECK_THROWS_AS(Settling({.reach = 0.0}), std::invalid_argument);
  CHECK_THROWS_WITH(Settling({.budget = 0}), "tumble: budget = 0: expected 1 or more");
  CHECK(Settling().ignores(World()).size() == 3);
}
