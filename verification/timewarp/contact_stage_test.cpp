/// \file
/// \brief Resting pairs: entry into the contact stage, rest, and release.
#include "tumble/timewarp/contact_stage.hpp"

#include "tumble/contact/tolerances.hpp"
#include "tumble/record/overlap.hpp"

#include "support/runs.hpp"
#include "support/test.hpp"
#include "timewarp/cases.hpp"

TEST_CASE("A pair enters the contact stage when its hop is no longer than the resolution",
          "[exact][timewarp]") {
  const double g = 9.81;
  ContactStage stage({.resolution = 1e-3, .pair_events = 4});
  const IndexPair pair{1, 2};
  stage.begin();
  CHECK_FALSE(stage.holds(pair));
  CHECK_FALSE(stage.count(pair, 0.5e-3 * g * 1.001, g));  // a hop of 1.001 ms
  CHECK_FALSE(stage.holds(pair));
  CHECK(stage.count(pair, 0.5e-3 * g * 0.999, g));
  CHECK(stage.holds(pair));
  CHECK(stage.entered() == 1);
  CHECK_FALSE(stage.holds({0, 1}));

  // Without gravity there are no hops: only pairs that do not separate at all.
  const IndexPair other{0, 1};
  CHECK_FALSE(stage.count(other, 1e-9, 0.0));
  CHECK(stage.count(other, 0.0, 0.0));
  REQUIRE(stage.pairs().size() == 2);
  CHECK(stage.pairs()[0] == other);
  CHECK(stage.pairs()[1] == pair);

  // Released by a push, but not indefinitely.
  stage.release(2);
  CHECK_FALSE(stage.holds(pair));
  CHECK(stage.holds(other));
  CHECK_FALSE(stage.count(pair, 1.0, g));
  CHECK(stage.count(pair, 1.0, g));  // the fourth
  stage.release(2);
  CHECK(stage.holds(pair));

  stage.begin();
  CHECK_FALSE(stage.holds(pair));
  CHECK(stage.entered() == 0);
  CHECK(stage.pairs().empty());
}

TEST_CASE("Two bodies that separate without an impulse have a separation velocity",
          "[unit][timewarp]") {
  // Such a pair does not collide again at once, and must not be deferred.
  World world;
  const BodyProperties cube = box_properties(Vec3::Ones(), 1.0, 0.0, 0.5);
  for (const double x : {0.0, 1.0})
    world.add(cube, Vec3(x, 0.0, 0.0), Quat::Identity(), Vec3(x, 0.0, 0.0));
  InstantImpacts impacts;
  StepReport report;
  const std::array<IndexPair, 1> pairs = {IndexPair{0, 1}};
  impacts.resolve(world, pairs, {.margin = 1e-6}, report);
  CHECK(report.impulses == 0);
  CHECK(impacts.separation_speed(world, pairs[0], 1.0 / 60.0) == 1.0);

  // Pushed at 1 m/s with e = 0.5.
  world.states()[0].linear_momentum_w.x() = 2.0;
  impacts.resolve(world, pairs, {.margin = 1e-6}, report);
  CHECK(impacts.separation_speed(world, pairs[0], 1.0 / 60.0) == near(0.5, 1e-15));

  // Rounding is no separation.
  world.states()[0].linear_momentum_w.x() = 1.0;
  world.states()[1].linear_momentum_w.x() = 1.0 + 1e-15;
  impacts.resolve(world, pairs, {.margin = 1e-6}, report);
  CHECK(impacts.separation_speed(world, pairs[0], 1.0 / 60.0) == 0.0);
}

TEST_CASE("Cubes that touch after an impact from both sides do not meet again and again",
          "[unit][timewarp]") {
  // The two in the middle are hit simultaneously and separate by rounding only, 6e-16 m/s.
  for (const char* name : kTimewarps) {
    CAPTURE(name);
    World world = world_of("line", {{"boxes", "0:1,1.5:0,2.5:0,4:-1"}});
    CHECK(make_timewarp(name)->step(world, 1.0).events <= 5);
  }
}

TEST_CASE("A box and a stack of five at rest stay where they are", "[unit][timewarp]") {
  for (const char* name : kTimewarps) {
    for (const int count : {1, 5}) {
      for (const double e : {0.0, 0.5}) {
        CAPTURE(name, count, e);
        World world = stack_of(count, 0.5, e);
        const World start = world;
        const double energy = energy_of(world).total();
        const auto technique = make_timewarp(name);
        std::int64_t events = 0;
        double highest = energy;
        OverlapMeter overlaps;
        double deepest = 0.0;
        double most = 0.0;  // [m/s]
        for (int k = 0; k < 300; ++k) {
          const StepReport report = technique->step(world, kFrame);
          highest = std::max(highest, energy_of(world).total());
          deepest = std::max(deepest, overlaps.look(world));
          if (k < 60) continue;  // until it has settled
          if (count == 1) CHECK(report.fallbacks == 1);
          events += report.events;
          most = std::max(most, fastest_of(world));
        }
        const double slop = tolerance::repair_slop * (1.0 + tolerance::repair_closeness);
        CAPTURE(deepest, most, highest - energy, events);
        if (count == 1) CHECK(events == 0);
        CHECK(deepest <= slop);
        // Each cube overlaps the one below by the permitted slop.
        for (int body = 1; body <= count; ++body) {
          const Vec3 way_w =
              world.states()[idx(body)].position_w - start.states()[idx(body)].position_w;
          CHECK(way_w.y() <= 1e-9);
          CHECK(way_w.y() >= -slop * body - 1e-9);
          CHECK(Vec3(way_w.x(), 0.0, way_w.z()).norm() < 1e-6);
        }
        CHECK(highest - energy <= 1e-9 * energy);
        CHECK(most < 1e-9);
      }
    }
  }
}

TEST_CASE("A hit on a resting stack is passed on within the frame", "[unit][timewarp]") {
  for (const char* name : kTimewarps) {
    CAPTURE(name);
    World world = stack_of(3, 0.5, 0.8);
    const auto technique = make_timewarp(name);
    for (int k = 0; k < 5; ++k) technique->step(world, kFrame);
    // It falls onto the top at 30 m/s from 0.1 m: after 3.3 ms of a frame.
    const double top = world.states()[3].position_w.y() + 0.5;
    world.add(box_properties(Vec3::Ones(), 1.0, 0.5, 0.8), Vec3(0.0, top + 0.6, 0.0),
              Quat::Identity(), Vec3(0.0, -30.0, 0.0));
    Listener heard;
    technique->observe(&heard);
    const double start = world.time();
    technique->step(world, kFrame);
    double first = 1.0;
    std::array<double, 4> impulse = {};  // [N s] downwards, on the ground and the three cubes
    for (const Event& event : heard.events) {
      const int lower = std::min(world.index_of(event.first), world.index_of(event.second));
      impulse[idx(lower)] += std::abs(event.impulse_w.y());
      if (lower == 3) first = std::min(first, event.time - start);
    }
    CHECK(first == near(0.1 / 30.0, 2e-5));
    for (const double each : impulse) CHECK(each > 10.0);
    for (int body = 1; body <= 4; ++body) CHECK(world.states()[idx(body)].position_w.y() > 0.3);
  }
}
