/// \file
/// \brief Steps with one evaluation of forces, and invariants of the exponential of a twist.
#include "tumble/exterior_rotation/simple_steps.hpp"

#include "tumble/exterior_rotation/tolerances.hpp"

#include "exterior_rotation/cases.hpp"
#include "support/test.hpp"

namespace {

constexpr std::array kSchemes = {SimpleScheme::forward_euler, SimpleScheme::semi_implicit,
                                 SimpleScheme::impulse, SimpleScheme::leapfrog};

void steps(World& world, SimpleScheme scheme, PoseUpdate pose, int count, double dt = kFrame) {
  const std::vector<Joint> joints = find_joints(world, tolerance::glue_margin);
  SimpleSteps method;
  JointForces forces;
  for (int k = 0; k < count; ++k) method.step(scheme, pose, dt, joints, forces, world);
}

// The column hangs by a corner instead of an edge: all three axes take part.
World in_space(double angle) {
  World world = world_of("fig6_1", {{"angle", std::to_string(angle)}});
  for (std::size_t k = 2; k < world.states().size(); ++k) {
    const BodyProperties& body = world.bodies()[k];
    BodyState& state = world.states()[k];
    const Vec3 spin_w(0.7, 1.1, -0.4);
    const Vec3 corner_w(0.0, 2.0, 0.5);
    state = make_state(body, state.position_w, state.orientation_wb,
                       spin_w.cross(state.position_w - corner_w), spin_w);
  }
  return world;
}

}  // namespace

TEST_CASE("The first step of each scheme is the one that its name promises",
          "[exact][exterior_rotation]") {
  // A box in free fall: the velocity used for each update.
  const double h = 0.25;
  const double g = 8.0;
  const auto height_and_speed = [&](SimpleScheme scheme, PoseUpdate pose) {
    World world;
    world.gravity_w = Vec3(0.0, -g, 0.0);
    const BodyProperties cube = box_properties(Vec3::Ones(), 2.0);
    world.add(cube, Vec3::Zero(), Quat::Identity(), Vec3(0.0, 4.0, 0.0));
    steps(world, scheme, pose, 1, h);
    return std::pair(world.states()[0].position_w.y(), velocity(cube, world.states()[0]).y());
  };
  for (const PoseUpdate pose : {PoseUpdate::separate, PoseUpdate::exponential}) {
    CHECK(height_and_speed(SimpleScheme::forward_euler, pose) == std::pair(1.0, 2.0));
    CHECK(height_and_speed(SimpleScheme::semi_implicit, pose) == std::pair(0.5, 2.0));
    CHECK(height_and_speed(SimpleScheme::impulse, pose) == std::pair(0.5, 2.0));
    CHECK(height_and_speed(SimpleScheme::leapfrog, pose) == std::pair(0.75, 2.0));
  }
}

TEST_CASE("A group in free flight keeps the momenta that its scheme keeps",
          "[exact][exterior_rotation]") {
  for (const SimpleScheme scheme : kSchemes)
    for (const PoseUpdate pose : {PoseUpdate::separate, PoseUpdate::exponential}) {
      INFO("scheme " << static_cast<int>(scheme) << ", pose " << name_of(pose));
      World world = flying_group(Vec3(0.0, -9.81, 0.0));
      const Vec3 before = linear_momentum(world);
      double mass = 0.0;
      for (const BodyProperties& body : world.bodies()) mass += body.mass;
      steps(world, scheme, pose, 30);
      // [kg m/s] gravity alone changes it; rounding
      CHECK((linear_momentum(world) - before - Vec3(0.0, -9.81 * 0.5 * mass, 0.0)).norm() <= 1e-12);
    }
}

TEST_CASE("The exponential keeps the glued column together over a fall",
          "[exact][exterior_rotation]") {
  // In the plane, and in space about a corner; steps of 1/60 s and ten times longer ones.
  for (const SimpleScheme scheme : kSchemes)
    for (const double dt : {kFrame, 10.0 * kFrame}) {
      const int count = static_cast<int>(std::lround(1.5 / dt));
      INFO("scheme " << static_cast<int>(scheme) << ", dt " << dt);
      World plane = world_of("fig6_1", {{"angle", "0.3"}});
      const std::vector<Joint> joints = find_joints(plane, tolerance::glue_margin);
      const Vec3 start_w = plane.states()[5].position_w;
      steps(plane, scheme, PoseUpdate::exponential, count, dt);
      CHECK(gap_of(joints, plane.states()).apart <
            1e-12);  // [m] issue's bound; measured below 1e-14
      CHECK((plane.states()[5].position_w - start_w).norm() > 1.0);  // [m] it fell

      World space = in_space(0.3);
      std::vector<Joint> hung = find_joints(space, tolerance::glue_margin);
      REQUIRE(hung[0].hold == JointHold::edge);
      hung[0].hold = JointHold::corner;  // the one at z = +1/2
      if (corner_of(hung[0], 0, space.states()).first_w.z() < 0.0) hung[0].side = 1;
      SimpleSteps method;
      JointForces forces;
      for (int k = 0; k < count; ++k)
        method.step(scheme, PoseUpdate::exponential, dt, hung, forces, space);
      CHECK(gap_of(hung, space.states()).apart < 1e-12);

      World separate = world_of("fig6_1", {{"angle", "0.3"}});
      steps(separate, scheme, PoseUpdate::separate, count, dt);
      CHECK(gap_of(joints, separate.states()).apart > 1e-5);  // [m] without it they come apart
    }
}

TEST_CASE("Leapfrog steps of a group that turns as one are reversible",
          "[exact][exterior_rotation]") {
  for (const PoseUpdate pose : {PoseUpdate::separate, PoseUpdate::exponential}) {
    World world = world_of("fig6_1", {{"angle", "0.3"}});
    const World start = world;
    const std::vector<Joint> joints = find_joints(world, tolerance::glue_margin);
    SimpleSteps method;
    JointForces forces;
    const auto forty_steps = [&] {
      for (int k = 0; k < 40; ++k)
        method.step(SimpleScheme::leapfrog, pose, kFrame, joints, forces, world);
    };
    forty_steps();
    CHECK(apart(world, start) > 0.5);
    for (BodyState& state : world.states()) {
      state.linear_momentum_w *= -1.0;
      state.angular_momentum_w *= -1.0;
    }
    forty_steps();
    CHECK(apart(world, start) < 1e-13);  // [m, -] rounding of 80 steps, measured 2e-15
  }
}
