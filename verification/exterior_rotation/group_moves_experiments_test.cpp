/// \file
/// \brief Ways to move the bodies of a group, written out, and the best frame for one.
#include "tumble/exterior_rotation/glued.hpp"

#include "driver/played_scene.hpp"
#include "driver/statistics.hpp"
#include "exterior_rotation/best_frame.hpp"
#include "exterior_rotation/glued_runs.hpp"
#include "support/test.hpp"

using namespace tumble::chapters;

namespace {

std::vector<Joint> joints_of(const World& world) {
  Glued glued;
  glued.find(world);
  return {glued.joints().begin(), glued.joints().end()};
}

// How far two lists of poses differ.
double apart(std::span<const BodyState> a, std::span<const BodyState> b) {
  double largest = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k)
    largest = std::max({largest, (a[k].position_w - b[k].position_w).norm(),
                        angle_between(a[k].orientation_wb, b[k].orientation_wb)});
  return largest;
}

// Three cubes corner on corner on a fixed one, all turned and turning at random, and their joints: the
// last one first, as no order is asked for.
struct Tower {
  World world;
  std::vector<Joint> joints;

  explicit Tower(Random& chance) {
    const BodyProperties fixed = fixed_box_properties(Vec3::Ones());
    const BodyProperties cube = box_properties(Vec3::Ones(), 1.0);
    const Vec3 up_b(0.5, 0.5, 0.5);
    Vec3 point_w = up_b;
    Vec3 point_velocity_w = Vec3::Zero();
    world.add(fixed, Vec3::Zero());
    for (int k = 1; k <= 3; ++k) {
      const Quat q_wb = rotation_from_vector(chance.in_cube(1.0));
      const Vec3 spin_w = chance.in_cube(5.0);
      const Vec3 x_w = point_w + q_wb * up_b;
      const Vec3 v_w = point_velocity_w + spin_w.cross(x_w - point_w);
      world.add(cube, x_w, q_wb, v_w, spin_w);
      Joint joint;
      joint.first = k % 2 == 0 ? k : k - 1;  // the one below is first or second
      joint.second = k % 2 == 0 ? k - 1 : k;
      joint.count = 1;
      joint.corners_first_b[0] = k % 2 == 0 ? Vec3(-up_b) : up_b;
      joint.corners_second_b[0] = k % 2 == 0 ? up_b : Vec3(-up_b);
      joint.hold = JointHold::corner;
      joints.insert(joints.begin(), joint);
      point_w = x_w + q_wb * up_b;
      point_velocity_w = v_w + spin_w.cross(point_w - x_w);
    }
  }
};

}  // namespace

TEST_CASE("A forward step of glued puts bodies where the ways of moving say that are written out",
          "[exact][exterior_rotation]") {
  for (const char* scene : {"fig6_1", "fig6_2", "fig6_3"}) {
    World world = build_world(make_scene(scene, {}));
    for (std::size_t k = 0; k < world.states().size();
         ++k)  // that of figures 6.1 and 6.2 is at rest
      if (world.bodies()[k].movable() && world.states()[k].angular_momentum_w.isZero()) {
        const Vec3 spin_w(0.0, 0.0, -2.0);
        world.set_velocity(world.ids()[k],
                           spin_w.cross(world.states()[k].position_w - Vec3(0.0, 2.0, 0.0)),
                           spin_w);
      }
    for (const PoseUpdate pose : {PoseUpdate::separate, PoseUpdate::exponential}) {
      GluedOptions options{.scheme = GluedScheme::forward_euler, .pose = pose};
      World stepped = world;
      Glued(options).step(stepped, kStep);
      const auto expected = pose == PoseUpdate::separate
                                ? moved_in_frame(world, GroupFrame{}, kStep)
                                : moved_by_own_twist(world, kStep);
      INFO(scene << ", " << name_of(pose));
      CHECK(apart(stepped.states(), expected) < 1e-14);
    }
  }
}

TEST_CASE("A frame that turns as all bodies of a group do moves them as one about its centre",
          "[exact][exterior_rotation]") {
  const Vec3 spin_w(1.0, -3.0, 2.0);
  const World world = column_in_flight(spin_w.cross(Vec3(0.4, -1.0, 2.0)), spin_w);
  const Vec3 rest_w(-0.4, 1.0, -2.0);  // [m] moves at v + ω × it = 0
  const auto states = moved_in_frame(world, {rest_w, spin_w}, 0.1);
  CHECK(apart(states, moved_by_own_twist(world, 0.1)) < 1e-14);
  CHECK(mismatch(joints_of(world), states) < 1e-14);  // [m]
  CHECK(mismatch(joints_of(world), moved_in_frame(world, GroupFrame{}, 0.1)) > 0.01);
}

TEST_CASE("A tree of pivots closes every joint of a tower that turns at rates of its own in space",
          "[exact][exterior_rotation]") {
  Random chance(11);
  for (int n = 0; n < 20; ++n) {
    const Tower tower(chance);
    CHECK(mismatch(tower.joints, tower.world.states()) < 1e-14);
    for (const double dt : {kStep, 0.2}) {
      const auto states = moved_in_tree(tower.world, tower.joints, dt);
      CHECK(mismatch(tower.joints, states) < 1e-14);  // [m]
      CHECK(mismatch(tower.joints, moved_by_own_twist(tower.world, dt)) > 1e-6);
      // No orientation is touched, and the way is that of the velocities to first order.
      for (std::size_t k = 1; k < states.size(); ++k) {
        const BodyState& before = tower.world.states()[k];
        const BodyProperties& body = tower.world.bodies()[k];
        const Quat turned_wb = turned(before.orientation_wb, angular_velocity(body, before), dt);
        CHECK(angle_between(states[k].orientation_wb, turned_wb) < 1e-14);
        // Three levers of √3/2 and spins of up to 5√3: half h² ω² times their length.
        CHECK((states[k].position_w - before.position_w - dt * velocity(body, before)).norm() <
              0.5 * dt * dt * 75.0 * 4.4);
      }
    }
  }
}

TEST_CASE("The fitted order of a power law is its exponent", "[exact][exterior_rotation]") {
  const std::array x = {0.1, 0.3, 0.7, 2.0};
  std::array<double, 4> y{};
  for (std::size_t k = 0; k < x.size(); ++k) y[k] = 3.0 * x[k] * x[k] * std::sqrt(x[k]);
  CHECK(fitted_order(x, y) == near(2.5, 1e-13));
}
