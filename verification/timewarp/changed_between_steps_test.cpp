/// \file
/// \brief Full timewarp with worlds that are changed between steps.

#include "support/test.hpp"
#include "timewarp/cases.hpp"

namespace {

World weightless() {
  World world = weightless_world();
  return world;
}

BodyProperties elastic_cube(double edge) {
  return box_properties(Vec3::Constant(edge), 1.0, 0.0, 1.0);
}

BodyProperties wall() {
  BodyProperties body = box_properties(Vec3(0.1, 4.0, 4.0), 1.0, 0.0, 1.0);
  body.inverse_mass = 0.0;
  body.inverse_inertia_b.setZero();
  return body;
}

}  // namespace

TEST_CASE("A wall that was moved between steps is hit where it is, and nowhere else",
          "[unit][timewarp]") {
  for (const char* name : kTimewarps) {
    CAPTURE(name);
    for (const bool into_the_way : {true, false}) {
      World world = weightless();
      const BodyProperties cube = elastic_cube(0.5);
      const BodyId flier = world.add(cube, Vec3::Zero(), Quat::Identity(), Vec3(20.0, 0.0, 0.0));
      const Vec3 near_w(1.8, 0.0, 0.0);
      const Vec3 far_w(50.0, 0.0, 0.0);
      const BodyId fixed = world.add(wall(), into_the_way ? far_w : near_w);
      const auto technique = make_timewarp(name);
      technique->step(world, kFrame);
      world.set_state(fixed, make_state(wall(), into_the_way ? near_w : far_w));
      for (int k = 0; k < 10; ++k) technique->step(world, kFrame);
      CHECK(world.body(flier).velocity_w().x() == near(into_the_way ? -20.0 : 20.0, 1e-9));
    }
  }
}

TEST_CASE("A full timewarp goes on from a step that was refused", "[unit][timewarp]") {
  World world = weightless();
  const BodyProperties cube = elastic_cube(1.0);
  const BodyId left = world.add(cube, Vec3::Zero(), Quat::Identity(), Vec3(10.0, 0.0, 0.0));
  world.add(cube, Vec3(1.2, 0.0, 0.0));
  const BodyId bystander = world.add(cube, make_state(cube, Vec3(30.0, 0.0, 0.0)), "bystander");
  TimewarpFull full;
  full.step(world, kFrame);
  const World saved = world;
  const auto index = static_cast<std::size_t>(world.index_of(bystander));
  world.states()[index].linear_momentum_w.y() = kNan;
  CHECK_THROWS_WITH(full.step(world, kFrame), Contains("bystander"));
  world = saved;
  for (int k = 0; k < 3; ++k) full.step(world, kFrame);
  CHECK(world.body(left).velocity_w().x() == near(0.0, 1e-9));
}

TEST_CASE("A full timewarp that is used on two worlds in turn keeps them apart",
          "[unit][timewarp]") {
  World worlds[2] = {weightless(), weightless()};
  for (const int k : {0, 1}) {
    const BodyProperties cube = box_properties(Vec3::Ones(), 1.0, 0.0, k == 0 ? 1.0 : 0.0);
    worlds[k].add(cube, Vec3::Zero(), Quat::Identity(), Vec3(10.0, 0.0, 0.0));
    worlds[k].add(cube, Vec3(1.6, 0.0, 0.0));
  }
  TimewarpFull full;
  full.step(worlds[0], kFrame);
  full.step(worlds[1], kFrame);
  for (int k = 0; k < 8; ++k) full.step(worlds[0], kFrame);
  CHECK(worlds[0].body(worlds[0].ids()[0]).velocity_w().x() == near(0.0, 1e-9));
  CHECK(worlds[0].body(worlds[0].ids()[1]).velocity_w().x() == near(10.0, 1e-9));
}

TEST_CASE("Steps of very different lengths are flown by a full timewarp like any other",
          "[unit][timewarp]") {
  for (const double first : {1e-7, 1.0}) {
    World world = weightless();
    world.add(box_properties(Vec3(1.0, 0.7, 0.4), 1.0), Vec3::Zero(), Quat::Identity(),
              Vec3::Zero(), Vec3(1.0, 2.0, 3.0));
    TimewarpFull full;
    TimewarpSwept swept;
    World other = world;
    full.step(world, first);
    swept.step(other, first);
    const double before = energy_of(world).kinetic;
    for (int k = 0; k < 100; ++k) {
      full.step(world, 1.0 / 600.0);
      swept.step(other, 1.0 / 600.0);
    }
    CAPTURE(first, before);
    // The rule `splitting` at 1/600 s: 1e-6 of the energy.
    CHECK(energy_of(world).kinetic == near(before, 2e-3 * before));
    CHECK(std::abs(energy_of(world).kinetic - energy_of(other).kinetic) < 2e-3 * before);
  }
}

TEST_CASE("A box that hops within the slop of repair keeps its energy in full timewarp",
          "[unit][timewarp]") {
  double energies[2] = {0.0, 0.0};
  int k = 0;
  for (const char* name : {"timewarp_swept", "timewarp_full"}) {
    World world = ground_world(0.0, 1.0);
    const BodyProperties cube = elastic_cube(1.0);
    world.add(cube, Vec3(0.0, 0.4995, 0.0), Quat::Identity(), Vec3(0.0, 0.05, 0.0));
    const auto technique = make_timewarp(name);
    for (int step = 0; step < 60; ++step) technique->step(world, kFrame);
    energies[k++] = energy_of(world).total();
  }
  CHECK(energies[1] == near(energies[0], 0.01));  // [J] of 4.9
}

TEST_CASE("Flights that are too short to go on, and rules that turn no cube exactly",
          "[unit][timewarp]") {
  for (const double stride : {1e-20, 1e-3, -1.0, 1e7, kNan}) {
    CAPTURE(stride);
    TimewarpFullOptions options;
    options.stride = stride;
    CHECK_THROWS_WITH(TimewarpFull(options), Contains("stride"));
  }
  // A cube that turns by 4 rad in eight frames.
  World world = weightless();
  const BodyProperties cube = elastic_cube(1.0);
  world.add(cube, Vec3::Zero(), Quat::Identity(), Vec3::Zero(), Vec3(0.0, 30.0, 0.0));
  TimewarpFullOptions options;
  options.rotation = RotationRule::rk4;
  TimewarpFull full(options);
  for (int k = 0; k < 8; ++k) full.step(world, kFrame);
  const Quat& turned = world.states()[0].orientation_wb;
  CHECK(std::abs(turned.w()) == near(std::abs(std::cos(2.0)), 2e-4));
}
