/// \file
/// \brief The basic technique: impacts at their times, caps, ties, snapshots.
#include "tumble/basic_colliding/basic.hpp"

#include "tumble/dynamics/trajectory.hpp"

#include "support/runs.hpp"
#include "support/scenes.hpp"
#include "support/test.hpp"

TEST_CASE("The basic technique keeps energy and momentum of two boxes that collide elastically",
          "[exact][basic_colliding]") {
  World world = world_of("two_boxes", {{"restitution", "1"}});
  const double energy = energy_of(world).total();
  const Vec3 momentum = linear_momentum(world);
  const Vec3 spin = angular_momentum(world);
  Basic basic;
  StepReport report;
  for (int k = 0; k < 60; ++k) {
    const StepReport step = basic.step(world, 1.0 / 60.0);
    report.events += step.events;
  }
  CHECK(report.events >= 1);
  CHECK(std::abs(energy_of(world).total() - energy) < 1e-13 * energy);
  CHECK((linear_momentum(world) - momentum).norm() < 1e-14);
  // The boxes collide up to one resolution (1 us) apart, so the two pushes are at one point and the
  // angular momentum is kept to rounding.
  CHECK((angular_momentum(world) - spin).norm() < 1e-13);
}

TEST_CASE("A missed third body restarts the search and collides first",
          "[exact][basic_colliding]") {
  // The fast left cube overlaps both others at the end of the step. Of the two candidates the
  // far one has the smaller index, so the search begins with it and has to begin again.
  World world = weightless_world();
  BodyProperties cube = box_properties(Vec3::Ones(), 1.0, 0.0, 1.0);
  const BodyId bullet = world.add(cube, Vec3::Zero(), Quat::Identity(), Vec3(90.0, 0.0, 0.0));
  world.add(cube, make_state(cube, Vec3(2.3, 0.4, 0.0)), "far");
  world.add(cube, make_state(cube, Vec3(1.2, -0.7, 0.0)), "near");
  Basic basic;
  Listener seen;
  basic.observe(&seen);
  const StepReport report = basic.step(world, 1.0 / 60.0);
  CHECK(report.restarts >= 1);
  REQUIRE(!seen.events.empty());
  CHECK(seen.events[0].first == bullet);
  CHECK(world.name(world.index_of(seen.events[0].second)) == "near");
  CHECK(seen.events[0].time == near(0.2 / 90.0, 1e-6));
}

TEST_CASE("Overlap of the size of a rounding does not hold up a cradle",
          "[unit][basic_colliding]") {
  // Balls that part by 1e-16 m/s after the impacts overlap by as much now and then.
  for (const ImpactOrder order : {ImpactOrder::simultaneous, ImpactOrder::sequential}) {
    for (const char* count : {"2", "3", "4", "5"}) {
      for (const char* gap : {"0", "0.37", "0.5"}) {
        CAPTURE(static_cast<int>(order), count, gap);
        World world = world_of("cradle", {{"count", count}, {"gap", gap}});
        Basic basic({.impacts = order});
        int capped = 0;
        std::int64_t events = 0;
        for (int k = 0; k < 300; ++k) {
          const StepReport report = basic.step(world, 1.0 / 60.0);
          capped += report.status == StepStatus::event_cap ? 1 : 0;
          events += report.events;
        }
        CHECK(capped == 0);
        CHECK(events < 30);
      }
    }
  }
}

TEST_CASE("No scene makes the basic technique hang or lose a body", "[unit][basic_colliding]") {
  for (const SceneRecipe& recipe : scene_library()) {
    if (recipe.name == "wall" || recipe.name == "pyramid3d") continue;  // hundreds of boxes
    INFO(recipe.name);
    Parameters p = recipe.parameters();
    if (p.has("per_edge")) p.set("per_edge", "2");
    if (p.has("rows")) p.set("rows", "3");
    World world = build_world(recipe.build(p, Random(3)));
    Basic basic({.event_cap = 20});
    for (int k = 0; k < 20; ++k) basic.step(world, 1.0 / 60.0);
    for (const BodyState& state : world.states()) CHECK(state.position_w.allFinite());
  }
}

TEST_CASE("Bad options of the basic technique are refused", "[unit][basic_colliding]") {
  CHECK_THROWS_WITH(Basic({.event_cap = 0}), Contains("event_cap = 0"));
  CHECK_THROWS_WITH(Basic({.resolution = 0.0}), Contains("resolution = 0"));
}
