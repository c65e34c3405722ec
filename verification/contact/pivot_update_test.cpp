/// \file
/// \brief Tests of bodies that turn about the points on which they stand.
#include "tumble/contact/pivot_update.hpp"

#include "tumble/dynamics/advance_pose.hpp"

#include "support/allocation_counter.hpp"
#include "support/test.hpp"

namespace {

// Bodies with their momenta, and the pairs that push each other.
struct TestScene {
  World world;
  std::vector<PushedPair> pairs;

  int add_fixed(const Vec3& position_w, const Vec3& size = Vec3::Ones()) {
    const BodyProperties body = fixed_box_properties(size);
    world.add(body, position_w);
    return world.count() - 1;
  }
  int add(const Vec3& position_w, const Vec3& velocity_w, const Vec3& spin_w,
          const Quat& orientation_wb = Quat::Identity(), const Vec3& size = Vec3::Ones(),
          double mass = 1.0) {
    const BodyProperties body = box_properties(size, mass);
    world.add(body, position_w, orientation_wb, velocity_w, spin_w);
    return world.count() - 1;
  }
  // One that turns about a point with a spin.
  int add_turning(const Vec3& position_w, const Vec3& pivot_w, const Vec3& spin_w,
                  const Quat& orientation_wb = Quat::Identity(), double mass = 1.0) {
    return add(position_w, spin_w.cross(position_w - pivot_w), spin_w, orientation_wb, Vec3::Ones(),
               mass);
  }
  void push(int first, int second, const Vec3& point_w, const Vec3& normal_w = Vec3::UnitY()) {
    pairs.push_back({first, second, point_w, normal_w});
  }
  [[nodiscard]] PivotUpdate carried(RigidAt rigid_at = RigidAt::start) const {
    std::vector<MovingBody> moving = test::moving_bodies(world);
    PivotUpdate found;
    found.find(world.bodies(), moving, pairs, rigid_at);
    return found;
  }
  // All states after a move; bodies that are not carried go straight.
  [[nodiscard]] std::vector<BodyState> moved(double h, RigidAt rigid_at = RigidAt::start) const {
    const PivotUpdate update = carried(rigid_at);
    std::vector<BodyState> states(world.states().begin(), world.states().end());
    for (int b = 0; b < world.count(); ++b) {
      BodyState& state = states[idx(b)];
      if (!world.bodies()[idx(b)].movable()) continue;
      if (!update.carries(b)) {
        advance_pose(world.bodies()[idx(b)], state, h, RotationRule::frozen);
        continue;
      }
      state.position_w += h * velocity(world.bodies()[idx(b)], state);
      update.carry(b, h, state);
    }
    return states;
  }
};

// A point of a body's material, given where it was at the start.
Vec3 carried_point(const BodyState& start, const BodyState& end, const Vec3& point_w) {
  return end.position_w +
         (end.orientation_wb * start.orientation_wb.conjugate()) * (point_w - start.position_w);
}

// [m] The largest difference between what two bodies make of a point.
double gap(const TestScene& scene, const std::vector<BodyState>& ended, int first, int second,
           const Vec3& point_w) {
  const std::span<const BodyState> start = scene.world.states();
  return (carried_point(start[idx(first)], ended[idx(first)], point_w) -
          carried_point(start[idx(second)], ended[idx(second)], point_w))
      .norm();
}

// Four unit cubes on the edge of a fixed box, turned about it by an angle, with a common spin.
TestScene column(const Vec3& spin_w, double angle) {
  TestScene scene;
  const Vec3 pivot_w(0.0, 2.0, 0.0);
  scene.add_fixed(Vec3(-2.0, 0.0, 0.0), Vec3(4.0, 4.0, 4.0));
  const Quat q = rotation_from_vector(Vec3(0.0, 0.0, angle));
  for (int k = 0; k < 4; ++k)
    scene.add_turning(pivot_w + q * Vec3(-0.5, 0.5 + k, 0.0), pivot_w, spin_w, q);
  scene.push(0, 1, pivot_w);
  for (int k = 1; k < 4; ++k) scene.push(k, k + 1, pivot_w + q * Vec3(-0.3, k, 0.1));
  return scene;
}

// [m] and [rad] By how much the poses of two bodies against each other have changed.
double change_of_shape(const TestScene& scene, const std::vector<BodyState>& ended) {
  const std::span<const BodyState> start = scene.world.states();
  double most = 0.0;
  for (std::size_t i = 1; i < ended.size(); ++i) {
    for (std::size_t j = 1; j < i; ++j) {
      const auto place = [&](const auto& states) -> Vec3 {
        return states[i].orientation_wb.conjugate() * (states[j].position_w - states[i].position_w);
      };
      const auto turn = [&](const auto& states) {
        return states[i].orientation_wb.conjugate() * states[j].orientation_wb;
      };
      most = std::max(
          {most, (place(ended) - place(start)).norm(), angle_between(turn(ended), turn(start))});
    }
  }
  return most;
}

}  // namespace

TEST_CASE("A column that turns about an edge keeps its shape at any step",
          "[exact][exterior_rotation]") {
  for (const double h : {1.0 / 60, 0.1}) {
    for (const double omega : {0.1, 2.0, -10.0}) {
      const TestScene scene = column(Vec3(0.0, 0.0, omega), -0.3);
      const std::vector<BodyState> ended = scene.moved(h);
      CHECK(change_of_shape(scene, ended) < 1e-13);  // [m, rad] measured: 3e-15
      CHECK(gap(scene, ended, 0, 1, Vec3(0.0, 2.0, 0.0)) < 1e-14);
      // The angle is the right one, and each alone would have opened the column by as much as is known.
      CHECK(angle_between(ended[4].orientation_wb, scene.world.states()[4].orientation_wb) ==
            near(std::abs(omega) * h, 1e-14));
      std::vector<BodyState> alone = ended;
      for (std::size_t k = 1; k < alone.size(); ++k)
        alone[k].position_w -= scene.carried().offset_w(static_cast<int>(k), h);
      const double opened = 0.5 * omega * omega * h * h;
      if (std::abs(omega * h) < 0.1)
        CHECK(change_of_shape(scene, alone) == near(3.0 * opened).epsilon(0.05));
    }
  }
}

TEST_CASE("A group that turns about a ball joint keeps its shape in three dimensions",
          "[exact][exterior_rotation]") {
  Random random(7);
  for (int run = 0; run < 100; ++run) {
    TestScene scene;
    const Vec3 pivot_w = random.in_cube(5.0);
    const Vec3 spin_w = random.in_cube(10.0);
    scene.add_fixed(pivot_w);
    for (int k = 0; k < 4; ++k) {
      const Vec3 offset = random.in_cube(3.0);
      const Quat q = rotation_from_vector(random.in_cube(3.0));
      scene.add_turning(pivot_w + offset, pivot_w, spin_w, q, 1.0 + k);
    }
    scene.push(1, 0, pivot_w);
    for (int k = 1; k < 4; ++k) scene.push(k, k + 1, random.in_cube(5.0));
    for (const double h : {1.0 / 60, 0.1}) {
      const std::vector<BodyState> ended = scene.moved(h);
      CHECK(change_of_shape(scene, ended) < 1e-13);  // [m, rad]
      CHECK(gap(scene, ended, 0, 1, pivot_w) < 1e-13);
      const std::vector<BodyState> backward = scene.moved(h, RigidAt::end);
      for (std::size_t k = 1; k < 5; ++k) {  // the same turn; the way is that of other velocities
        CHECK(angle_between(backward[k].orientation_wb, ended[k].orientation_wb) < 1e-14);
      }
    }
  }
}

TEST_CASE("Joints with spins of their own stay closed, where a twist about the origin opens them",
          "[exact][exterior_rotation]") {
  Random random(11);
  for (int run = 0; run < 100; ++run) {
    TestScene scene;
    const Vec3 pivot_w = random.in_cube(1.0);
    const Vec3 joint_w = pivot_w + random.in_cube(1.0);
    const Vec3 first_spin_w = random.in_cube(4.0);
    const Vec3 second_spin_w = random.in_cube(4.0);
    scene.add_fixed(pivot_w);
    const int a = scene.add_turning(pivot_w + random.in_cube(1.0), pivot_w, first_spin_w);
    const Vec3 arm_w = random.in_cube(1.0);
    const Vec3 joint_velocity_w = first_spin_w.cross(joint_w - pivot_w);
    const int b =
        scene.add(joint_w + arm_w, joint_velocity_w + second_spin_w.cross(arm_w), second_spin_w);
    scene.push(0, a, pivot_w);
    scene.push(a, b, joint_w);
    for (const double h : {1.0 / 60, 0.1}) {
      const std::vector<BodyState> ended = scene.moved(h);
      CHECK(gap(scene, ended, 0, a, pivot_w) < 1e-14);
      CHECK(gap(scene, ended, a, b, joint_w) < 1e-14);
    }
    // The same by h times V v, the exponential of the twist of b's own velocities: planar, so that
    // the velocity lies across the spin.
    const double h = 1e-3;
    const auto twist = [&](const Vec3& velocity_w, const Vec3& spin_w) {
      const Vec3 turn_w = h * spin_w;
      const double angle = turn_w.norm();
      const double c = (1.0 - std::cos(angle)) / (angle * angle);
      const double s = (angle - std::sin(angle)) / (angle * angle * angle);
      const Vec3 once = turn_w.cross(velocity_w);
      return Vec3(h * (velocity_w + c * once + s * turn_w.cross(once)));
    };
    const Vec3 by_first = twist(joint_velocity_w, first_spin_w);
    const Vec3 by_second = twist(joint_velocity_w, second_spin_w);
    const double residual =
        0.5 * h * h * (second_spin_w - first_spin_w).cross(joint_velocity_w).norm();
    CHECK((by_second - by_first).norm() == near(residual).epsilon(0.02));
  }
}

TEST_CASE("Bodies that are stuck together in flight keep their shape and all momenta",
          "[exact][exterior_rotation]") {
  Random random(3);
  for (int run = 0; run < 50; ++run) {
    TestScene scene;
    scene.add_fixed(Vec3(0.0, -100.0, 0.0));
    const Vec3 spin_w = random.in_cube(5.0);
    const Vec3 drift_w = random.in_cube(5.0);
    const Vec3 middle_w = random.in_cube(5.0);
    for (int k = 0; k < 4; ++k) {
      const Vec3 arm_w = random.in_cube(2.0);
      scene.add(middle_w + arm_w, drift_w + spin_w.cross(arm_w), spin_w,
                rotation_from_vector(random.in_cube(2.0)), Vec3(1.0, 0.5, 2.0),
                random.uniform(0.5, 3.0));
    }
    for (int k = 1; k < 4; ++k) scene.push(k, k + 1, middle_w + random.in_cube(2.0));
    const double h = run % 2 == 0 ? 1.0 / 60 : 0.1;
    const std::vector<BodyState> ended = scene.moved(h);
    CHECK(change_of_shape(scene, ended) < 1e-13);
    const Vec3 momentum = linear_momentum(scene.world);
    const Vec3 turning = angular_momentum(scene.world);
    double mass = 0.0;
    Vec3 before = Vec3::Zero();
    Vec3 after = Vec3::Zero();
    for (std::size_t k = 1; k < ended.size(); ++k) {
      mass += scene.world.bodies()[k].mass;
      before += scene.world.bodies()[k].mass * scene.world.states()[k].position_w;
      after += scene.world.bodies()[k].mass * ended[k].position_w;
    }
    CHECK((after - before - h * momentum).norm() < 1e-13 * mass * 10.0);
    std::copy(ended.begin(), ended.end(), scene.world.states().begin());
    CHECK((linear_momentum(scene.world) - momentum).norm() == 0.0);
    CHECK((angular_momentum(scene.world) - turning).norm() < 1e-12 * (1.0 + turning.norm()));
  }
}

TEST_CASE("A box that slides and tips keeps its edge on a smooth floor, and goes straight",
          "[exact][exterior_rotation]") {
  for (const double h : {1.0 / 60, 0.1}) {
    for (const double omega : {0.5, -3.0, 10.0}) {
      TestScene scene;
      const Vec3 edge_w(0.3, 0.0, 0.0);
      const Vec3 spin_w(0.0, 0.0, omega);
      const Vec3 center_w = edge_w + Vec3(-0.4, 0.6, 0.2);
      scene.add_fixed(Vec3(0.0, -1.0, 0.0), Vec3(10.0, 2.0, 10.0));
      const Vec3 rising_w(0.0, spin_w.cross(center_w - edge_w).y(), 0.0);
      const int box = scene.add(center_w, Vec3(2.0, 0.0, -1.0) + rising_w, spin_w);
      scene.push(0, box, edge_w);
      const std::vector<BodyState> ended = scene.moved(h);
      const Vec3 edge_after = carried_point(scene.world.states()[1], ended[1], edge_w);
      CHECK(std::abs(edge_after.y()) < 1e-15);  // [m] rounding of some lengths of 1 m
      CHECK(ended[1].position_w.x() == center_w.x() + h * 2.0);
      CHECK(ended[1].position_w.z() == center_w.z() - h * 1.0);
    }
  }
}

TEST_CASE("A body between a smooth floor and a smooth wall keeps to both",
          "[exact][exterior_rotation]") {
  TestScene scene;
  const Vec3 spin_w(0.0, 0.0, -1.5);
  const Vec3 foot_w(1.0, 0.0, 0.0);
  const Vec3 head_w(0.0, 2.0, 0.0);
  const Vec3 center_w = 0.5 * (foot_w + head_w);
  // The velocity at which the foot goes along the floor and the head along the wall.
  const Vec3 velocity_w(-spin_w.cross(head_w - center_w).x(), -spin_w.cross(foot_w - center_w).y(),
                        0.0);
  scene.add_fixed(Vec3(0.0, -1.0, 0.0), Vec3(10.0, 2.0, 10.0));
  scene.add_fixed(Vec3(-1.0, 0.0, 0.0), Vec3(2.0, 10.0, 10.0));
  scene.add(center_w, velocity_w, spin_w, Quat::Identity(), Vec3(0.2, 2.2, 1.0));
  scene.push(0, 2, foot_w, Vec3::UnitY());
  scene.push(1, 2, head_w, Vec3::UnitX());
  const std::vector<BodyState> ended = scene.moved(0.1);
  const BodyState& start = scene.world.states()[2];
  CHECK(std::abs(carried_point(start, ended[2], foot_w).y()) < 1e-15);
  CHECK(std::abs(carried_point(start, ended[2], head_w).x()) < 1e-15);
}

TEST_CASE("A loop of joints opens by a length of second order in the step",
          "[exact][exterior_rotation]") {
  // A parallelogram: two cranks on fixed pivots that turn alike, and a beam on both that does not turn;
  // one of the cranks is longer, so that the beam's ends go different ways to second order.
  const auto opened = [](double h) {
    TestScene scene;
    scene.add_fixed(Vec3::Zero());
    const double omega = 2.0;
    const Vec3 left_w(0.0, 1.0, 0.0);
    const Vec3 right_w(3.0, 2.0, 0.0);
    const Vec3 slow_w(0.0, 0.0, 0.5 * omega);
    const int a = scene.add_turning(Vec3(0.0, 0.5, 0.0), Vec3::Zero(), Vec3(0.0, 0.0, omega));
    const int b = scene.add_turning(Vec3(3.0, 1.0, 0.0), Vec3(3.0, 0.0, 0.0), slow_w);
    const int beam = scene.add(Vec3(1.5, 1.5, 0.0), Vec3(-omega, 0.0, 0.0), Vec3::Zero());
    scene.push(0, a, Vec3::Zero());
    scene.push(0, b, Vec3(3.0, 0.0, 0.0));
    scene.push(a, beam, left_w);
    scene.push(b, beam, right_w);
    const std::vector<BodyState> ended = scene.moved(h);
    CHECK(gap(scene, ended, a, beam, left_w) < 1e-14);
    return gap(scene, ended, b, beam, right_w);
  };
  const double coarse = opened(0.02);
  const double fine = opened(0.01);
  CHECK(coarse / fine == near(4.0, 0.02));
  CHECK(fine == near(0.5 * 1e-4 * std::abs(4.0 * 1.0 - 1.0 * 2.0)).epsilon(0.01));
}

TEST_CASE("Velocities that agree at the end of a move leave no gap either",
          "[exact][exterior_rotation]") {
  // Two bodies on a fixed pivot whose velocities are those of one turn at the poses that they get to.
  const double h = 1.0 / 60;
  const Vec3 spin_w(1.0, -2.0, 6.0);
  const Quat turn = rotation_from_vector(h * spin_w);
  TestScene scene;
  scene.add_fixed(Vec3::Zero());
  const Vec3 first_w(0.5, 1.0, 0.0);
  const Vec3 second_w(0.5, 2.0, 0.5);
  scene.add_turning(first_w, Vec3::Zero(), spin_w);
  scene.add_turning(second_w, Vec3::Zero(), spin_w);
  scene.push(0, 1, Vec3::Zero());
  scene.push(1, 2, Vec3(0.4, 1.5, 0.2));
  PivotUpdate carried = scene.carried(RigidAt::end);
  std::vector<MovingBody> moving = test::moving_bodies(scene.world);
  moving[1].velocity_w = spin_w.cross(turn * first_w);
  moving[2].velocity_w = spin_w.cross(turn * second_w);
  carried.set_velocities(moving);
  for (int b = 1; b < 3; ++b) {
    BodyState state = scene.world.states()[idx(b)];
    const Vec3 expected_w = turn * state.position_w;
    state.position_w += h * moving[idx(b)].velocity_w;
    carried.carry(b, h, state);
    CHECK((state.position_w - expected_w).norm() < 1e-15);
    CHECK(angle_between(state.orientation_wb, turn) < 1e-15);
  }
}

TEST_CASE("With accelerations carried bodies follow their circle exactly",
          "[reference][exterior_rotation]") {
  // A pendulum about a corner whose angular velocity grows evenly: the angle is known, and the centre
  // stays on its circle at any time.
  const auto error = [](double h, double time) {
    const Vec3 axis_w(0.0, 0.0, 1.0);
    const double omega = 1.5;
    const double alpha = 4.0;
    const Vec3 arm_w(0.5, 0.5, 0.0);
    TestScene scene;
    scene.add_fixed(Vec3::Zero());
    scene.add_turning(arm_w, Vec3::Zero(), omega * axis_w);
    scene.push(0, 1, Vec3::Zero());
    PivotUpdate carried = scene.carried();
    const double half = 0.5 * h;
    const Vec3 spin_w = (omega + half * alpha) * axis_w;
    const Vec3 arm_there_w =
        rotation_from_vector((half * omega + 0.5 * half * half * alpha) * axis_w) * arm_w;
    std::vector<Acceleration> rates(2);
    rates[1].angular_w = alpha * axis_w;
    rates[1].linear_w = alpha * axis_w.cross(arm_there_w) + spin_w.cross(spin_w.cross(arm_there_w));
    carried.accelerate(rates);
    BodyState state = scene.world.states()[1];
    state.position_w +=
        time * velocity(scene.world.bodies()[1], state) + 0.5 * time * time * rates[1].linear_w;
    carried.carry(1, time, state);
    const Vec3 exact_w =
        rotation_from_vector((time * omega + 0.5 * time * time * alpha) * axis_w) * arm_w;
    return (state.position_w - exact_w).norm();
  };
  for (const double share : {0.1, 0.5, 1.0}) CHECK(error(0.1, share * 0.1) < 1e-15);
}

TEST_CASE("No body is carried without a push, and one that does not turn goes as it would",
          "[unit][exterior_rotation]") {
  TestScene scene;
  scene.add_fixed(Vec3::Zero());
  const int a = scene.add(Vec3(0.1, 1.3, 0.2), Vec3(1.0, 0.3, 0.1), Vec3(1.0, 2.0, 3.0));
  const int b = scene.add(Vec3(0.1, 2.3, 0.2), Vec3::Zero(), Vec3::Zero());
  CHECK_FALSE(scene.carried().carries(a));
  CHECK_FALSE(scene.carried().carries(b));
  CHECK_FALSE(PivotUpdate().carries(0));
  // A body that slides on a movable one alone is not carried.
  scene.push(a, b, Vec3(0.1, 1.8, 0.2));
  CHECK_FALSE(scene.carried().carries(a));
  // One at rest on the box is, and stays to the last bit.
  scene.push(0, b, Vec3(0.1, 1.8, 0.2));
  REQUIRE(scene.carried().carries(b));
  const BodyState& start = scene.world.states()[idx(b)];
  const BodyState end = scene.moved(0.1)[idx(b)];
  CHECK(end == start);
  // A pair that slides faster than a hundredth of how fast turning moves the ends does not stick.
  for (const double slip : {0.9, 1.1}) {
    TestScene other;
    other.add_fixed(Vec3::Zero());
    const Vec3 spin_w(0.0, 0.0, 2.0);
    const double ends = 0.5 * std::sqrt(3.0) * 2.0;
    const Vec3 arm_w(0.5, 0.5, 0.0);
    const int box =
        other.add(arm_w, spin_w.cross(arm_w) + Vec3(0.01 * slip * ends, 0.0, 0.0), spin_w);
    other.push(0, box, Vec3::Zero());
    // Both are led along the floor; what sticks is led along its circle.
    const double aside = std::abs(other.carried().offset_w(box, 0.1).dot(Vec3(1.0, 0.0, 0.0)));
    CHECK((aside > 1e-3) == (slip < 1.0));
  }
}

TEST_CASE("Where a body is carried to is a continuous function of the time",
          "[unit][exterior_rotation]") {
  const TestScene scene = column(Vec3(0.0, 0.0, -6.0), -0.2);
  const PivotUpdate carried = scene.carried();
  CHECK(carried.offset_w(4, 0.0).norm() == 0.0);
  Vec3 last_w = Vec3::Zero();
  for (int k = 1; k <= 1000; ++k) {
    const double time = 1e-4 * k;
    const Vec3 now_w = carried.offset_w(4, time);
    // [m] Its speed is below 2 sin(omega t/2) omega R, with omega t = 0.6 and R = 3.54 m at most.
    CHECK((now_w - last_w).norm() < 1e-4 * 0.592 * 6.0 * 3.55);
    CHECK(carried.offset_w(4, time) == now_w);
    last_w = now_w;
  }
}

TEST_CASE("Carrying asks for no memory once it is warm, and rejects what does not fit",
          "[unit][exterior_rotation]") {
  const TestScene scene = column(Vec3(0.0, 0.0, -6.0), -0.2);
  std::vector<MovingBody> moving = test::moving_bodies(scene.world);
  PivotUpdate carried;
  carried.find(scene.world.bodies(), moving, scene.pairs);
  Vec3 sum_w = carried.offset_w(4, 0.1);
  const AllocationCount counter;
  carried.find(scene.world.bodies(), moving, scene.pairs);
  sum_w += carried.offset_w(4, 0.1);
  CHECK(counter.value() == 0);
  CHECK(sum_w.allFinite());

  CHECK_THROWS_WITH(carried.find(scene.world.bodies(), std::span(moving).first(2), scene.pairs),
                    Contains("moving"));
  const std::vector<PushedPair> strange = {{0, 9, Vec3::Zero(), Vec3::UnitY()}};
  CHECK_THROWS_WITH(carried.find(scene.world.bodies(), moving, strange), Contains("pairs"));
}

TEST_CASE("A body that stands has its arm from the point on which it stands, and others have none",
          "[unit][exterior_rotation]") {
  // A column on an edge: each turns about the point that it has in common with the one below.
  const TestScene standing = column(Vec3(0.0, 0.0, 0.5), 0.3);
  const PivotUpdate carried = standing.carried();
  CHECK_FALSE(carried.arm_w(0).has_value());  // the fixed box
  for (int b = 1; b <= 4; ++b) {
    const auto arm_w = carried.arm_w(b);
    REQUIRE(arm_w.has_value());
    const Vec3 pivot_w = standing.world.states()[idx(b)].position_w - *arm_w;
    CHECK((pivot_w - standing.pairs[idx(b - 1)].point_w).norm() < 1e-15);
  }
  CHECK_FALSE(carried.arm_w(5).has_value());  // no body has this index
  CHECK_FALSE(carried.arm_w(-1).has_value());

  // Two that are stuck together in flight, and one that flies by itself: the first of the two carries
  // the other and stands on nothing.
  TestScene flying;
  flying.add_turning(Vec3(0.0, 5.0, 0.0), Vec3(0.5, 5.0, 0.0), Vec3(0.0, 0.0, 2.0));
  flying.add_turning(Vec3(1.0, 5.0, 0.0), Vec3(0.5, 5.0, 0.0), Vec3(0.0, 0.0, 2.0));
  flying.add(Vec3(0.0, 9.0, 0.0), Vec3::UnitX(), Vec3::UnitZ());
  flying.push(0, 1, Vec3(0.5, 5.25, 0.0), Vec3::UnitX());
  const PivotUpdate group = flying.carried();
  CHECK(group.carries(0));
  CHECK_FALSE(group.arm_w(0).has_value());
  REQUIRE(group.arm_w(1).has_value());
  CHECK(*group.arm_w(1) == Vec3(0.5, -0.25, 0.0));
  CHECK_FALSE(group.carries(2));
  CHECK_FALSE(group.arm_w(2).has_value());

  PivotUpdate cleared = carried;
  cleared.clear();
  CHECK_FALSE(cleared.arm_w(1).has_value());
}

TEST_CASE("A contact pushes where its impulses are", "[unit][exterior_rotation]") {
  Contact contact{.first = 3, .second = 5, .normal_w = Vec3::UnitX(), .count = 3};
  contact.points[0].position_w = Vec3(0.0, 0.0, 0.0);
  contact.points[1].position_w = Vec3(0.0, 4.0, 0.0);
  contact.points[2].position_w = Vec3(0.0, 9.0, 0.0);
  CHECK_FALSE(pushed_pair(contact).has_value());
  contact.points[0].normal_impulse = 1.0;
  contact.points[1].normal_impulse = 3.0;
  const std::optional<PushedPair> pair = pushed_pair(contact);
  REQUIRE(pair.has_value());
  CHECK(pair->first == 3);
  CHECK(pair->second == 5);
  CHECK(pair->point_w == Vec3(0.0, 3.0, 0.0));
  CHECK(pair->normal_w == Vec3::UnitX());
}
