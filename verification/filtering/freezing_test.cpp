/// \file
/// \brief Sleep for islands that only chatter.
#include "tumble/filtering/freezing.hpp"

#include "tumble/contact/tolerances.hpp"
#include "tumble/contact_damped/contact_damped.hpp"
#include "tumble/filtering/adaptive_step.hpp"
#include "tumble/impulse_damped/damped.hpp"

#include "support/scenes.hpp"
#include "support/test.hpp"

namespace {

World clump(int per_edge) { return world_of("fig6_7", {{"per_edge", std::to_string(per_edge)}}); }

std::unique_ptr<Technique> damped(bool sleeping) {
  return std::make_unique<Damped>(DampedOptions{.sleeping = sleeping});
}

void run(Technique& technique, World& world, double seconds) {
  for (int k = 0; k < static_cast<int>(std::lround(seconds / kFrame)); ++k)
    technique.step(world, kFrame);
}

int asleep(const World& world) {
  return static_cast<int>(std::count_if(world.sleep_states().begin(), world.sleep_states().end(),
                                        [](const SleepState& rest) { return rest.asleep; }));
}

}  // namespace

TEST_CASE(
    "An island that only chatters falls asleep if chatter is detected from history, and not "
    "otherwise",
    "[unit][filtering]") {
  World by_speed = clump(5);
  World by_history = by_speed;
  run(*damped(true), by_speed, 4.0);
  FreezeOnChatter freezing(damped(true));
  run(freezing, by_history, 4.0);
  CHECK(asleep(by_speed) <= 10);     // of 125; measured 1
  CHECK(asleep(by_history) >= 100);  // measured 120
}

TEST_CASE("A clump freezes at divided steps too, where it touches in one sub-step of many",
          "[unit][filtering]") {
  World world = clump(3);
  AdaptiveStep adaptive(std::make_unique<FreezeOnChatter>(damped(true)),
                        {.halvings = 3, .fewest = 3});
  run(adaptive, world, 5.0);
  CHECK(asleep(world) >=
        20);  // of 27; measured 26, and 0 if frames used contacts of their own sub-step only
}

TEST_CASE("A body that counts as slow falls asleep as fast as it is, and its energy is booked",
          "[exact][filtering]") {
  World world = ground_world();
  world.add(box_properties(Vec3::Ones(), 2.0), Vec3(0.0, 0.5, 0.0), Quat::Identity(),
            Vec3(0.0, 3.0, 4.0));
  SleepingRule rule;
  const std::vector<IndexPair> pairs = {{0, 1}};
  Islands islands;
  islands.build_from_pairs(world.bodies(), pairs);
  std::vector<char> slow(2, 0);
  double energy = 0.0;
  const auto step = [&] {
    rule.wake_disturbed(world);
    energy += rule.update_with_pairs(world, pairs, islands, kFrame, slow).energy;
  };
  for (int k = 0; k < 60; ++k) step();
  CHECK(asleep(world) == 0);
  for (int k = 0; k < 31; ++k) {  // half a second and a step
    slow[1] = 1;
    step();
  }
  CHECK(asleep(world) == 1);
  CHECK(energy == -25.0);  // [J] half of 2 kg times 25 m²/s²
}

TEST_CASE("Freezing moves no body and books what it stops", "[unit][filtering]") {
  World world = clump(3);
  FreezeOnChatter freezing(damped(true));
  int fell = 0;
  for (int k = 0; k < 360; ++k) {
    const std::vector<SleepState> before(world.sleep_states().begin(), world.sleep_states().end());
    freezing.step(world, kFrame);
    for (std::size_t b = 0; b < before.size(); ++b) {
      if (!world.sleep_states()[b].asleep) continue;
      fell += before[b].asleep ? 0 : 1;
      CHECK(world.states()[b].linear_momentum_w.isZero(0.0));
      CHECK(world.states()[b].angular_momentum_w.isZero(0.0));
    }
  }
  CHECK(fell > 0);
  CHECK_THROWS_AS(freezing.step(world, 0.0), std::invalid_argument);

  // From here on sleeping bodies do not move.
  const World then = world;
  for (int k = 0; k < 60; ++k) freezing.step(world, kFrame);
  int still = 0;
  for (std::size_t b = 0; b < then.states().size(); ++b) {
    if (!then.sleep_states()[b].asleep || !world.sleep_states()[b].asleep) continue;
    ++still;
    CHECK(world.states()[b] == then.states()[b]);
  }
  CHECK(still >= 20);
}

TEST_CASE("A frozen island wakes when one of its bodies is pushed, and freezes again",
          "[unit][filtering]") {
  World world = clump(5);
  FreezeOnChatter freezing(damped(true));
  run(freezing, world, 4.0);
  // The highest sleeping body: there is none on top of it.
  std::size_t top = 0;
  for (std::size_t k = 1; k < world.states().size(); ++k)
    if (world.sleep_states()[k].asleep &&
        (top == 0 || world.states()[k].position_w.y() > world.states()[top].position_w.y()))
      top = k;
  REQUIRE(top > 0);
  const double before = world.states()[top].position_w.y();
  const int slept = asleep(world);
  world.set_velocity(world.ids()[top], Vec3(0.0, 4.0, 0.0), Vec3::Zero());
  freezing.step(world, kFrame);
  CHECK(asleep(world) < slept - 1);  // others with it
  run(freezing, world, 0.25);
  CHECK(world.states()[top].position_w.y() > before + 0.5);  // [m] free flight has 0.7
  CHECK_FALSE(world.sleep_states()[top].asleep);
  run(freezing, world, 4.0);
  CHECK(asleep(world) >= slept - 10);
}

TEST_CASE("A box that slides slowly is not frozen", "[unit][filtering]") {
  ContactDampedOptions options{.sleeping = true};
  for (const double speed : {0.04, 0.1, 0.3}) {
    World world = ground_world(0.0);
    world.add(box_properties(Vec3::Ones(), 1.0, 0.0), Vec3(0.0, 0.5, 0.0), Quat::Identity(),
              Vec3(speed, 0.0, 0.0));
    FreezeOnChatter freezing(std::make_unique<ContactDamped>(options));
    run(freezing, world, 4.0);
    CHECK(asleep(world) == 0);
    CHECK(world.states()[1].position_w.x() == near(4.0 * speed, 1e-6));  // [m]
  }
}

TEST_CASE("Without sleeping a wrapped technique steps to the same bits", "[exact][filtering]") {
  World plain = clump(2);
  World wrapped = plain;
  const std::unique_ptr<Technique> technique = damped(false);
  FreezeOnChatter freezing(damped(false));
  for (int k = 0; k < 180; ++k) {
    technique->step(plain, kFrame);
    freezing.step(wrapped, kFrame);
  }
  CHECK(plain.hash().value() == wrapped.hash().value());
  CHECK(freezing.name() == "damped");
  CHECK(freezing.contacts().size() == technique->contacts().size());
}

TEST_CASE("A clone of a freezing technique goes on to the same bits", "[exact][filtering]") {
  World world = clump(3);
  FreezeOnChatter freezing(damped(true));
  run(freezing, world, 2.0);  // some are calm for less than half a second
  World copy = world;
  const std::unique_ptr<Technique> clone = freezing.clone();
  run(freezing, world, 2.0);
  run(*clone, copy, 2.0);
  CHECK(world.hash().value() == copy.hash().value());
}

TEST_CASE("A world that is put back in time is stepped, and its bodies are classified anew",
          "[unit][filtering]") {
  World world = clump(2);
  FreezeOnChatter freezing(damped(true));
  run(freezing, world, 4.0);
  const World settled = world;
  const auto calm = [&] {
    return std::ranges::count_if(world.ids(),
                                 [&](BodyId id) { return freezing.calm_bodies().calm(id); });
  };
  run(freezing, world, 1.0);
  REQUIRE(calm() > 0);
  world = settled;
  freezing.step(world, kFrame);
  CHECK(calm() == 0);
  run(freezing, world, 1.0);
  CHECK(calm() > 0);
}

TEST_CASE("A body is calm until it leaves the place where it was classified",
          "[exact][filtering]") {
  CalmBodies calm;
  World world;
  const BodyId id = world.add(box_properties(Vec3::Ones(), 1.0), BodyState{});
  const std::vector<char> touches = {1};
  const auto go = [&](int frames, double step) {
    for (int k = 0; k < frames; ++k) {
      calm.add(world, touches);
      world.finish_step(kFrame);
      world.states()[0].position_w.x() += step;
    }
    calm.add(world, touches);
  };
  go(29, 0.0);
  CHECK_FALSE(calm.calm(id));  // 30 frames are too few
  world.finish_step(kFrame);
  go(1, 0.0);
  CHECK(calm.calm(id));
  world.finish_step(kFrame);
  world.states()[0].position_w.x() = 0.99 * tolerance::resting_movement;
  calm.add(world, touches);
  CHECK(calm.calm(id));
  world.finish_step(kFrame);
  world.states()[0].position_w.x() = 1.01 * tolerance::resting_movement;
  calm.add(world, touches);
  CHECK_FALSE(calm.calm(id));
  CHECK_FALSE(calm.calm(BodyId{5}));
}

TEST_CASE("The option freeze requires sleeping", "[unit][filtering]") {
  for (const char* name : {"impulse", "damped", "contact_damped"}) {
    CHECK_FALSE(technique_recipe(name).options().flag("freeze"));
    CHECK_THROWS_AS(make_technique(name, {"freeze=on"}), std::invalid_argument);
    const auto made = make_technique(name, {"freeze=on", "sleeping=on"});
    CHECK(dynamic_cast<const FreezeOnChatter*>(made.get()) != nullptr);
    CHECK(made->name() == name);
  }
  CHECK_THROWS_AS(make_technique("damped", {"reading=as_printed", "freeze=on"}),
                  std::invalid_argument);
}
