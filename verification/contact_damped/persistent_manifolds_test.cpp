/// \file
/// \brief Contact areas are kept while bodies rest, and hand on their impulses when they are not.
#include "tumble/contact_damped/persistent_manifolds.hpp"

#include "tumble/contact_damped/tolerances.hpp"
#include "tumble/math/rotation.hpp"

#include "support/allocation_counter.hpp"
#include "support/catch.hpp"

#include <cmath>

using namespace tumble;

namespace {

constexpr double kStep = 1.0 / 60.0;

// A stack of cubes of 1 kg on the ground.
World stack(int count) {
  World world;
  world.add_ground(0.5);
  const BodyProperties body = box_properties(Vec3::Ones(), 1.0);
  for (int k = 0; k < count; ++k) world.add(body, make_state(body, Vec3(0.0, 0.5 + k, 0.0)));
  return world;
}

ManifoldsFound find(PersistentManifolds& areas, const World& world, double impulses = 1.0) {
  std::vector<IndexPair> candidates;
  for (int k = 0; k < world.count(); ++k)
    for (int j = k + 1; j < world.count(); ++j) candidates.push_back({k, j});
  std::vector<MovingBody> bodies;
  load_moving_bodies(world, bodies);
  return areas.find(world, bodies, candidates, kStep, impulses);
}

// Impulses of a box of 1 kg that leans to one side and is braked.
void push(ContactPatch& block) {
  for (int i = 0; i < block.count; ++i) {
    ContactPatchPoint& p = block.points[static_cast<std::size_t>(i)];
    p.impulse = 0.04 + 0.01 * p.along;
  }
  block.along_impulse = 0.01;
  block.across_impulse = -0.02;
  block.twist_impulse = 0.003;
}

// Force and moment about the second body's centre, world frame.
std::pair<Vec3, Vec3> wrench_of(const ContactPatch& block) {
  const Six all = impulse_of(block);
  const Vec3 force = block.frame_w * Vec3(all[0], all[1], all[2]);
  const Vec3 moment = block.frame_w * Vec3(all[3], all[4], all[5]);
  return {force, moment + block.second_arm_w.cross(force)};
}

}  // namespace

TEST_CASE("Areas of bodies that rest are found once", "[unit][contact_damped][impulse_damped]") {
  const World world = stack(4);
  PersistentManifolds areas;
  const ManifoldsFound first = find(areas, world);
  CHECK(areas.blocks().size() == 4);
  CHECK(first.points == 16);
  CHECK(first.pair_tests == 10);
  for (ContactPatch& block : areas.blocks()) push(block);
  const std::vector<ContactPatch> before = areas.blocks();
  const ManifoldsFound again = find(areas, world);
  CHECK(again.pair_tests == 6);  // pairs that do not touch
  REQUIRE(areas.blocks().size() == 4);
  for (std::size_t k = 0; k < 4; ++k) {
    CHECK(areas.blocks()[k].stamp == before[k].stamp);
    CHECK(impulse_of(areas.blocks()[k]) == impulse_of(before[k]));
  }
}

TEST_CASE("Gaps of an area that is kept follow the small motion of its bodies",
          "[exact][contact_damped][impulse_damped]") {
  World world = stack(2);
  PersistentManifolds areas;
  find(areas, world);
  const std::uint64_t stamp = areas.blocks()[1].stamp;
  BodyState state = world.states()[2];
  state.position_w += Vec3(3e-7, 2e-7, 0.0);
  state.orientation_wb = rotation_from_vector(Vec3(4e-7, 0.0, 6e-7));
  world.set_state(world.ids()[2], state);
  find(areas, world);
  REQUIRE(areas.blocks()[1].stamp == stamp);
  const ContactPatch& block = areas.blocks()[1];
  const MovingBody lower = [&] {
    MovingBody body;
    body.position_w = world.states()[1].position_w;
    return body;
  }();
  for (int i = 0; i < block.count; ++i) {
    const ContactPatchPoint& p = block.points[static_cast<std::size_t>(i)];
    const Vec3 at = position_of(block, lower, p);
    // [m] omega x r along the vertical: omega_z x - omega_x z.
    CHECK(p.gap == near(2e-7 + 6e-7 * at.x() - 4e-7 * at.z()).margin(1e-13));
  }
}

TEST_CASE("An area that is found anew inherits force and moment of the old one",
          "[exact][contact_damped][impulse_damped]") {
  World world = stack(2);
  PersistentManifolds areas;
  find(areas, world);
  for (ContactPatch& block : areas.blocks()) push(block);
  const auto before = wrench_of(areas.blocks()[1]);
  const std::uint64_t stamp = areas.blocks()[1].stamp;
  // Turned about the vertical the area has other points, eight for a square on a square.
  BodyState state = world.states()[2];
  state.orientation_wb = rotation_from_vector(Vec3(0.0, 0.3, 0.0));
  world.set_state(world.ids()[2], state);
  find(areas, world);
  REQUIRE(areas.blocks().size() == 2);
  const ContactPatch& block = areas.blocks()[1];
  CHECK(block.stamp != stamp);
  CHECK(block.count == 8);
  const auto after = wrench_of(block);
  CHECK((after.first - before.first).norm() < 1e-15);    // [N s] rounding of 0.16
  CHECK((after.second - before.second).norm() < 1e-15);  // [N m s]
  for (int i = 0; i < block.count; ++i)
    CHECK(block.points[static_cast<std::size_t>(i)].impulse > 0.0);
}

TEST_CASE("Impulses follow the length of the step, and bodies by their names",
          "[exact][contact_damped][impulse_damped]") {
  World world = stack(3);
  PersistentManifolds areas;
  find(areas, world);
  for (ContactPatch& block : areas.blocks()) push(block);
  const Six top = impulse_of(areas.blocks()[2]);
  find(areas, world, 0.5);
  const Six half = impulse_of(areas.blocks()[2]);
  for (std::size_t k = 0; k < 6; ++k) CHECK(half[k] == 0.5 * top[k]);
  // The lowest box goes: indices of the others become less by one.
  world.remove(world.ids()[1]);
  find(areas, world);
  REQUIRE(areas.blocks().size() == 1);
  CHECK(areas.blocks()[0].first == 1);
  CHECK(areas.blocks()[0].second == 2);
  CHECK(impulse_of(areas.blocks()[0]) == half);
}

TEST_CASE("A body that has moved by more than a millionth of its edge is looked at anew",
          "[unit][contact_damped][impulse_damped]") {
  for (const double share : {0.9, 1.1}) {
    World world = stack(1);
    PersistentManifolds areas;
    find(areas, world);
    BodyState state = world.states()[1];
    state.position_w.x() += share * tolerance::kept_motion;
    world.set_state(world.ids()[1], state);
    CHECK(find(areas, world).pair_tests == (share < 1.0 ? 0 : 1));
    state.orientation_wb = rotation_from_vector(Vec3(0.0, share * tolerance::kept_motion, 0.0));
    world.set_state(world.ids()[1], state);
    CHECK(find(areas, world).pair_tests == (share < 1.0 ? 0 : 1));
  }
}

TEST_CASE("What may be reached within the step touches, with the speed that this needs",
          "[unit][contact_damped][impulse_damped]") {
  for (const double speed : {5.9, 6.1}) {
    World world;
    world.add_ground();
    const BodyProperties body = box_properties(Vec3::Ones(), 1.0);
    world.add(body,
              make_state(body, Vec3(0.0, 0.601, 0.0), Quat::Identity(), Vec3(0.0, -speed, 0.0)));
    PersistentManifolds areas;
    find(areas, world);
    // 0.101 m less a margin of 0.001 m in a sixtieth of a second are 6 m/s.
    CHECK(areas.blocks().size() == (speed > 6.0 ? 1 : 0));
    if (speed > 6.0)
      CHECK(areas.blocks()[0].points[0].target ==
            near(-(0.101 - tolerance::contact_damped_slop) / kStep).margin(1e-10));
  }
}

TEST_CASE("Areas that are kept ask for no memory", "[unit][contact_damped][impulse_damped]") {
  const World world = stack(5);
  PersistentManifolds areas;
  std::vector<IndexPair> candidates;
  for (int k = 0; k < 5; ++k) candidates.push_back({k, k + 1});
  std::vector<MovingBody> bodies;
  load_moving_bodies(world, bodies);
  for (int k = 0; k < 3; ++k) areas.find(world, bodies, candidates, kStep, 1.0);
  const AllocationCount count;
  areas.find(world, bodies, candidates, kStep, 1.0);
  CHECK(count.value() == 0);
}
