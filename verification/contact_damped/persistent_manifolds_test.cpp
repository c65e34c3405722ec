/// \file
/// \brief Contact patches kept while bodies rest, and impulses passed on when they are built again.
#include "tumble/contact_patches/persistent_manifolds.hpp"

#include "tumble/contact_damped/tolerances.hpp"
#include "tumble/contact_patches/tolerances.hpp"

#include "contact_damped/helpers.hpp"
#include "support/test.hpp"

namespace {

ManifoldsFound find(PersistentManifolds& manifolds, const World& world,
                    double impulse_ratio = 1.0) {
  std::vector<MovingBody> bodies = moving_bodies(world);
  return manifolds.find(world, bodies, all_pairs(world), kFrame, impulse_ratio);
}

// Impulses of a box of 1 kg that leans to one side and is braked.
void push(ContactPatch& patch) {
  for (int i = 0; i < patch.count; ++i) {
    ContactPatchPoint& p = patch.points[idx(i)];
    p.impulse = 0.04 + 0.01 * p.along;
  }
  patch.along_impulse = 0.01;
  patch.across_impulse = -0.02;
  patch.twist_impulse = 0.003;
}

// Force and moment about the second body's centre, world frame.
std::pair<Vec3, Vec3> wrench_of(const ContactPatch& patch) {
  const Six all = impulse_of(patch);
  const Vec3 force = patch.frame_w * Vec3(all[0], all[1], all[2]);
  const Vec3 moment = patch.frame_w * Vec3(all[3], all[4], all[5]);
  return {force, moment + patch.second_arm_w.cross(force)};
}

}  // namespace

TEST_CASE("Patches of resting bodies are built once", "[unit][contact_damped]") {
  const World world = stack_of(4);
  PersistentManifolds manifolds;
  const ManifoldsFound first = find(manifolds, world);
  CHECK(manifolds.patches().size() == 4);
  CHECK(first.points == 16);
  CHECK(first.pair_tests == 10);
  for (ContactPatch& patch : manifolds.patches()) push(patch);
  const std::vector<ContactPatch> before = manifolds.patches();
  const ManifoldsFound again = find(manifolds, world);
  CHECK(again.pair_tests == 6);  // pairs that do not touch
  REQUIRE(manifolds.patches().size() == 4);
  for (std::size_t k = 0; k < 4; ++k) {
    CHECK(manifolds.patches()[k].stamp == before[k].stamp);
    CHECK(impulse_of(manifolds.patches()[k]) == impulse_of(before[k]));
  }
}

TEST_CASE("Gaps of a kept patch follow the small motion of its bodies", "[exact][contact_damped]") {
  World world = stack_of(2);
  PersistentManifolds manifolds;
  find(manifolds, world);
  const std::uint64_t stamp = manifolds.patches()[1].stamp;
  BodyState state = world.states()[2];
  state.position_w += Vec3(3e-7, 2e-7, 0.0);
  state.orientation_wb = rotation_from_vector(Vec3(4e-7, 0.0, 6e-7));
  world.set_state(world.ids()[2], state);
  find(manifolds, world);
  REQUIRE(manifolds.patches()[1].stamp == stamp);
  const ContactPatch& patch = manifolds.patches()[1];
  const MovingBody lower = [&] { return MovingBody{.position_w = world.states()[1].position_w}; }();
  for (int i = 0; i < patch.count; ++i) {
    const ContactPatchPoint& p = patch.points[idx(i)];
    const Vec3 at = position_of(patch, lower, p);
    // [m] omega x r along the vertical: omega_z x - omega_x z.
    CHECK(p.gap == near(2e-7 + 6e-7 * at.x() - 4e-7 * at.z(), 1e-13));
  }
}

TEST_CASE("A patch that is built again takes over force and moment of the previous one",
          "[exact][contact_damped]") {
  World world = stack_of(2);
  PersistentManifolds manifolds;
  find(manifolds, world);
  for (ContactPatch& patch : manifolds.patches()) push(patch);
  const auto before = wrench_of(manifolds.patches()[1]);
  const std::uint64_t stamp = manifolds.patches()[1].stamp;
  // Turned about the vertical the patch has other points, eight for a square on a square.
  BodyState state = world.states()[2];
  state.orientation_wb = rotation_from_vector(Vec3(0.0, 0.3, 0.0));
  world.set_state(world.ids()[2], state);
  find(manifolds, world);
  REQUIRE(manifolds.patches().size() == 2);
  const ContactPatch& patch = manifolds.patches()[1];
  CHECK(patch.stamp != stamp);
  CHECK(patch.count == 8);
  const auto after = wrench_of(patch);
  CHECK((after.first - before.first).norm() < 1e-15);    // [N s] rounding of 0.16
  CHECK((after.second - before.second).norm() < 1e-15);  // [N m s]
  for (int i = 0; i < patch.count; ++i) CHECK(patch.points[idx(i)].impulse > 0.0);
}

TEST_CASE("Impulses scale with the length of the step, and belong to bodies by their ids",
          "[exact][contact_damped]") {
  World world = stack_of(3);
  PersistentManifolds manifolds;
  find(manifolds, world);
  for (ContactPatch& patch : manifolds.patches()) push(patch);
  const Six top = impulse_of(manifolds.patches()[2]);
  find(manifolds, world, 0.5);
  const Six half = impulse_of(manifolds.patches()[2]);
  for (std::size_t k = 0; k < 6; ++k) CHECK(half[k] == 0.5 * top[k]);
  // The lowest box is removed: indices of the others become less by one.
  world.remove(world.ids()[1]);
  find(manifolds, world);
  REQUIRE(manifolds.patches().size() == 1);
  CHECK(manifolds.patches()[0].first == 1);
  CHECK(manifolds.patches()[0].second == 2);
  CHECK(impulse_of(manifolds.patches()[0]) == half);
}

TEST_CASE("A pair is tested again when a body has moved by more than a millionth of its edge",
          "[unit][contact_damped]") {
  for (const double share : {0.9, 1.1}) {
    World world = stack_of(1);
    PersistentManifolds manifolds;
    find(manifolds, world);
    BodyState state = world.states()[1];
    state.position_w.x() += share * tolerance::kept_motion;
    world.set_state(world.ids()[1], state);
    CHECK(find(manifolds, world).pair_tests == (share < 1.0 ? 0 : 1));
    state.orientation_wb = rotation_from_vector(Vec3(0.0, share * tolerance::kept_motion, 0.0));
    world.set_state(world.ids()[1], state);
    CHECK(find(manifolds, world).pair_tests == (share < 1.0 ? 0 : 1));
  }
}

TEST_CASE(
    "Bodies that can meet within the step get a patch, with the speed that this needs as the "
    "target",
    "[unit][contact_damped]") {
  for (const double speed : {5.9, 6.1}) {
    World world = ground_world();
    world.add(box_properties(Vec3::Ones(), 1.0), Vec3(0.0, 0.601, 0.0), Quat::Identity(),
              Vec3(0.0, -speed, 0.0));
    PersistentManifolds manifolds;
    find(manifolds, world);
    // 0.101 m less a margin of 0.001 m in a sixtieth of a second are 6 m/s.
    CHECK(manifolds.patches().size() == (speed > 6.0 ? 1 : 0));
    if (speed > 6.0)
      CHECK(manifolds.patches()[0].points[0].target ==
            near(-(0.101 - tolerance::contact_slop) / kFrame, 1e-10));
  }
}

TEST_CASE("A patch gets the points that impulses bring into reach", "[unit][contact_damped]") {
  // A cube that stands on an edge, turned by 2 degrees, is set turning onto its face.
  World world;
  world.add_ground(0.5);
  constexpr double kTurn = 0.035;
  const double height = 0.5 * (std::cos(kTurn) + std::sin(kTurn));
  world.add(box_properties(Vec3::Ones(), 1.0), Vec3(0.0, height, 0.0),
            rotation_from_vector(Vec3(0.0, 0.0, kTurn)));
  PersistentManifolds manifolds;
  find(manifolds, world);
  ContactPatch& patch = manifolds.patches().at(0);
  REQUIRE(patch.count == 2);
  for (ContactPatchPoint& p : patch.used()) p.impulse = 0.1;
  std::vector<MovingBody> bodies = moving_bodies(world);
  CHECK_FALSE(manifolds.add_points(world, bodies, kFrame, patch));
  bodies[1].angular_velocity_w.z() = -2.0 * kTurn / kFrame;
  CHECK(manifolds.add_points(world, bodies, kFrame, patch));
  CHECK(patch.count == 4);
  CHECK(impulse_of(patch)[six::normal] == near(0.2, 1e-15));
  double nearest = 0.0;  // [m/s] the lowest target: the other edge may come down to the ground
  for (const ContactPatchPoint& p : patch.used()) nearest = std::min(nearest, p.target);
  CHECK(nearest == near(-std::sin(kTurn) / kFrame, 0.01));
  CHECK_FALSE(manifolds.add_points(world, bodies, kFrame, patch));
}
