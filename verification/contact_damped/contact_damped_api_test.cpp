/// \file
/// \brief contact_damped in use: bodies that come, go and are pushed, steps and gravity that
///        change, sleep, and the ends of the range of friction.

#include "contact_damped/helpers.hpp"
#include "support/pose.hpp"
#include "support/test.hpp"

namespace {

// A stack of cubes of 1 kg at x = 0 and one at x = 5.
World two_stacks(int count) {
  World world = ground_world(0.5);
  const BodyProperties body = box_properties(Vec3::Ones(), 1.0);
  for (const double x : {0.0, 5.0})
    for (int k = 0; k < count; ++k) world.add(body, Vec3(x, 0.5 + k, 0.0));
  return world;
}

int sleepers(const World& world) {
  int count = 0;
  for (const SleepState& rest : world.sleep_states()) count += rest.asleep ? 1 : 0;
  return count;
}

}  // namespace

// --- bodies that come and go --------------------------------------------------------------------

TEST_CASE("A box that is removed from below lets those above fall, and no other body moves",
          "[unit][contact_damped]") {
  BOTH_POSES;
  for (const char* sleeping : {"off", "on"}) {
    World world = two_stacks(4);
    const std::unique_ptr<Technique> technique = contact_damped({{"sleeping", sleeping}});
    run(world, *technique, 3.0);
    INFO("sleeping " << sleeping);
    CHECK(sleepers(world) == (std::string(sleeping) == "on" ? 8 : 0));
    // The lowest of the first stack: all indices behind it become less by one.
    world.remove(world.ids()[1]);
    const World before = world;
    for (int k = 0; k < 6; ++k) technique->step(world, kFrame);
    // v = g t for those that fall freely: 6 steps.
    for (std::size_t k = 1; k <= 3; ++k)
      CHECK(velocity(world.bodies()[k], world.states()[k]).y() ==
            near(-6.0 * kGravity * kFrame, 1e-6));
    for (std::size_t k = 4; k <= 7; ++k)
      CHECK((world.states()[k].position_w - before.states()[k].position_w).norm() < 1e-6);
    run(world, *technique, 4.0);
    // [m] They stand again, a metre lower.
    for (std::size_t k = 1; k <= 3; ++k)
      CHECK(world.states()[k].position_w.y() == near(static_cast<double>(k) - 0.5, 1e-3));
  }
}

TEST_CASE("Contacts of bodies that sleep name no body that is gone", "[unit][contact_damped]") {
  World world = ground_world(0.5);
  const BodyProperties body = box_properties(Vec3::Ones(), 1.0);
  for (const double x : {0.0, 50.0}) world.add(body, Vec3(x, 0.5, 0.0));
  const std::unique_ptr<Technique> technique = contact_damped({{"sleeping", "on"}});
  run(world, *technique, 3.0);
  REQUIRE(sleepers(world) == 2);
  const BodyId gone = world.ids()[2];
  world.remove(gone);
  technique->step(world, kFrame);
  CHECK(technique->contacts().size() == 4);
  for (const ContactRecord& contact : technique->contacts()) CHECK(contact.second != gone);
}

TEST_CASE(
    "A box that spins where it stands slips at all of its contacts, and sticks once it has stopped",
    "[unit][contact_damped]") {
  World world = two_stacks(1);
  world.set_velocity(world.ids()[1], Vec3::Zero(), Vec3(0.0, 2.0, 0.0));
  const std::unique_ptr<Technique> technique = contact_damped();
  const auto count = [&](ContactState state) {
    return std::count_if(technique->contacts().begin(), technique->contacts().end(),
                         [&](const ContactRecord& contact) { return contact.state == state; });
  };
  technique->step(world, kFrame);
  CHECK(count(ContactState::slip) == 4);
  CHECK(count(ContactState::stick) == 4);  // of the other box
  run(world, *technique, 2.0);
  CHECK(count(ContactState::stick) == 8);
}

TEST_CASE("An impact is reported when and where the bodies meet", "[unit][contact_damped]") {
  // Two cubes 5 m apart come together at 50 m/s each, the left one a little lower: at x = 0 after 0.04 s, in a part of
  // the third step. The ground is hit by a cube that slides along at 3 m/s, after 0.01 s.
  World world = weightless_world();
  world.add_ground(0.5, 0.5);
  const BodyProperties body = box_properties(Vec3::Ones(), 1.0, 0.0, 0.5);
  world.add(body, Vec3(-2.5, 4.9, 0.0), Quat::Identity(), Vec3(50.0, 0.0, 0.0));
  world.add(body, Vec3(2.5, 5.1, 0.0), Quat::Identity(), Vec3(-50.0, 0.0, 0.0));
  world.add(body, Vec3(0.0, 0.55, 9.0), Quat::Identity(), Vec3(3.0, -5.0, 0.0));
  const std::unique_ptr<Technique> technique = contact_damped({});
  Listener listener;
  technique->observe(&listener);
  run(world, *technique, 0.06);
  REQUIRE(listener.events.size() == 2);
  CHECK(listener.events[0].time == near(0.01, 1e-9));
  CHECK((listener.events[0].point_w - Vec3(0.03, 0.0, 9.0)).norm() < 1e-9);
  CHECK(listener.events[1].time == near(0.04, 1e-9));
  CHECK((listener.events[1].point_w - Vec3(0.0, 5.0, 0.0)).norm() < 1e-9);
}

TEST_CASE("A ruler that lands on an end is hit where it is", "[unit][contact_damped]") {
  // It turns fast then, and corners that come down in the same step lie far from the one that has been hit.
  Scene scene{.ground = SceneGround{}};
  scene.boxes.push_back({.name = "ruler",
                         .size = Vec3(0.1, 0.02, 1.0),
                         .position_w = Vec3(0.0, 0.8406736367390966, 0.0),
                         .orientation_wb = Quat(0.05118374782106909, 0.6755596868924394,
                                                -0.5033515249761652, 0.5363176071218877)});
  Listener listener;
  Simulation simulation(scene);
  simulation.observe(listener);
  const BodyView ruler = simulation.body("ruler");
  for (int k = 0; k < 40; ++k) {
    const Vec3 before_w = ruler.position_w();
    listener.events.clear();
    simulation.step();
    for (const Event& event : listener.events) {
      const double near_by =
          std::min((event.point_w - before_w).norm(), (event.point_w - ruler.position_w()).norm());
      CHECK(near_by < 0.5 * scene.boxes[0].size.norm() + 2e-3);
    }
  }
}

TEST_CASE("A box that is put onto a stack between two steps stands on it",
          "[unit][contact_damped]") {
  BOTH_POSES;
  for (const char* sleeping : {"off", "on"}) {
    World world = two_stacks(3);
    const std::unique_ptr<Technique> technique = contact_damped({{"sleeping", sleeping}});
    run(world, *technique, 3.0);
    const BodyProperties body = box_properties(Vec3::Ones(), 1.0);
    world.add(body, make_state(body, Vec3(0.0, 3.5, 0.0)), "new");
    const World before = world;
    const Course course = run(world, *technique, 3.0);
    INFO("sleeping " << sleeping << ", moved " << course.moved);
    CHECK(course.moved < 1e-4);  // [m]
    CHECK(course.failed == 0);
  }
}

TEST_CASE("A push between two steps is not forgotten", "[unit][contact_damped]") {
  BOTH_POSES;
  for (const char* sleeping : {"off", "on"}) {
    World world = two_stacks(1);
    const std::unique_ptr<Technique> technique = contact_damped({{"sleeping", sleeping}});
    run(world, *technique, 3.0);
    world.set_velocity(world.ids()[2], Vec3(2.0, 0.0, 0.0), Vec3::Zero());
    const double x = world.states()[2].position_w.x();
    run(world, *technique, 2.0);
    INFO("sleeping " << sleeping);
    // v²/(2 mu g) = 0.4077 m, less half a step at 2 m/s.
    CHECK(std::abs(world.states()[2].position_w.x() - x - 0.407747) < 0.5 * kFrame * 2.0 + 1e-4);
    CHECK(world.states()[1].position_w.norm() == near(0.5, 1e-6));
  }
}

// --- steps and gravity that change ---------------------------------------------------------------

TEST_CASE("A stack and a pyramid stand while the length of the step changes all the time",
          "[unit][contact_damped]") {
  BOTH_POSES;
  for (const char* scene : {"stack", "pyramid"}) {
    World world = world_of(scene, {{std::string(scene) == "stack" ? "count" : "rows", "5"}});
    const World start = world;
    const std::unique_ptr<Technique> technique = contact_damped();
    Random chance(5);
    for (int k = 0; k < 400; ++k) {
      const double dt = k % 7 == 0 ? 1e-4 : chance.uniform(0.2, 2.0) * kFrame;
      CHECK(technique->step(world, dt).status == StepStatus::done);
    }
    INFO(scene);
    CHECK(distance_of(world, start) < 1e-3);  // [m]
    CHECK(fastest_of(world) < 1e-4);          // [m/s]
  }
}

TEST_CASE("Without gravity boxes in contact stay, and a pushed one keeps its velocity",
          "[exact][contact_damped]") {
  BOTH_POSES;
  World world = weightless_world();
  const BodyProperties body = box_properties(Vec3::Ones(), 1.0);
  for (int k = 0; k < 3; ++k) world.add(body, Vec3(0.0, k, 0.0));
  const World start = world;
  const std::unique_ptr<Technique> technique = contact_damped();
  run(world, *technique, 1.0);
  CHECK(distance_of(world, start) == 0.0);
  // The upper one slides on the middle one: nothing presses them together, so there is no friction.
  world.set_velocity(world.ids()[2], Vec3(1.0, 0.0, 0.0), Vec3::Zero());
  run(world, *technique, 0.5);
  CHECK(velocity(world.bodies()[2], world.states()[2]).x() == near(1.0, 1e-12));
  CHECK(fastest_of(world) == near(1.0, 1e-12));
}

TEST_CASE("When gravity turns, boxes fall the other way and come to rest there",
          "[unit][contact_damped]") {
  BOTH_POSES;
  World world;
  const BodyProperties wall = fixed_box_properties(Vec3(1.0, 10.0, 10.0), 0.5);
  const BodyProperties floor = fixed_box_properties(Vec3(10.0, 1.0, 10.0), 0.5);
  world.add(floor, Vec3(0.0, -0.5, 0.0));
  world.add(wall, Vec3(5.5, 5.0, 0.0));
  const BodyProperties body = box_properties(Vec3::Ones(), 1.0);
  for (int k = 0; k < 3; ++k) world.add(body, Vec3(2.0, 0.5 + k, 0.0));
  for (const char* sleeping : {"off", "on"}) {
    World turned = world;
    const std::unique_ptr<Technique> technique = contact_damped({{"sleeping", sleeping}});
    run(turned, *technique, 3.0);
    turned.gravity_w = Vec3(kGravity, 0.0, 0.0);
    run(turned, *technique, 6.0);
    INFO("sleeping " << sleeping);
    CHECK(fastest_of(turned) < 1e-4);
    for (std::size_t k = 2; k < 5; ++k) CHECK(turned.states()[k].position_w.x() == near(4.5, 1e-3));
  }
}

// --- the ends of the range ---------------------------------------------------------------------

TEST_CASE("A frictionless box keeps its speed, one with friction ten stops within a step",
          "[exact][contact_damped]") {
  BOTH_POSES;
  World smooth = world_of("slide", {{"friction", "0"}});
  run(smooth, *contact_damped(), 2.0);
  CHECK(smooth.body("box").velocity_w().x() == near(3.0, 1e-12));
  // 0.2 m/s is less than mu g h = 1.6 m/s, and too slow to tip the box.
  World rough = world_of("slide", {{"friction", "10"}, {"speed", "0.2"}});
  const World start = rough;
  run(rough, *contact_damped(), 1.0);
  CHECK(fastest_of(rough) < 1e-4);
  CHECK(distance_of(rough, start) < 0.2 * kFrame);
  CHECK(turned_most_of(rough, start) < 1e-4);
}

TEST_CASE("A box that is wedged between two walls too close for it comes to rest",
          "[unit][contact_damped]") {
  BOTH_POSES;
  // Walls that overlap it by 0.1 mm each: there is no room, and nothing may diverge.
  World world;
  const BodyProperties wall = fixed_box_properties(Vec3(1.0, 4.0, 4.0), 0.5);
  world.add(wall, Vec3(-0.9999, 0.0, 0.0));
  world.add(wall, Vec3(0.9999, 0.0, 0.0));
  world.add(box_properties(Vec3::Ones(), 1.0), Vec3(0.0, 0.0, 0.0));
  const Course course = run(world, *contact_damped(), 2.0);
  INFO("fastest " << course.fastest << " m/s, moved " << course.moved << " m");
  CHECK(course.not_finite == 0);
  CHECK(course.fastest < 2.0 * kGravity + 1e-9);  // [m/s] not faster than free fall
  CHECK(std::abs(world.states()[2].position_w.x()) < 1e-3);
  CHECK(std::abs(world.states()[2].position_w.z()) < 1e-3);
}

// --- sleep ---------------------------------------------------------------------------------------

TEST_CASE(
    "A stack falls asleep, wakes when it is touched, and a step of sleeping bodies costs nothing",
    "[unit][contact_damped]") {
  BOTH_POSES;
  World world = two_stacks(5);
  const std::unique_ptr<Technique> technique = contact_damped({{"sleeping", "on"}});
  run(world, *technique, 2.0);
  REQUIRE(sleepers(world) == 10);
  const StepReport report = technique->step(world, kFrame);
  CHECK(report.pair_tests == 0);
  CHECK(report.iterations == 0);
  // A box that falls onto the first stack wakes that one only.
  world.add(box_properties(Vec3::Ones(), 1.0), Vec3(0.0, 5.6, 0.0), Quat::Identity(),
            Vec3(0.0, -1.0, 0.0));
  int least = 10;
  for (int k = 0; k < 20; ++k) {
    technique->step(world, kFrame);
    least = std::min(least, sleepers(world));
  }
  CHECK(least == 5);
  run(world, *technique, 3.0);
  CHECK(sleepers(world) == 11);
}

TEST_CASE("Bad options of contact_damped are refused", "[unit][contact_damped]") {
  for (const char* option : {"sweeps", "correction_sweeps", "parts"})
    CHECK_THROWS_AS(contact_damped({{option, "0"}}), std::invalid_argument);
  CHECK_THROWS_AS(contact_damped({{"admm_iterations", "-1"}}), std::invalid_argument);
}
