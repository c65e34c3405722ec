/// \file
/// \brief Runge-Kutta methods: coefficients, orders on a free top, error estimate.
#include "tumble/exterior_rotation/runge_kutta.hpp"

#include "tumble/exterior_rotation/tolerances.hpp"

#include "exterior_rotation/cases.hpp"
#include "support/test.hpp"

namespace {

constexpr std::size_t kMost = ButcherTable::kMostStages;
using Column = std::array<double, kMost>;

// A p, stage by stage.
Column times(const ButcherTable& table, const Column& p) {
  Column sum{};
  for (std::size_t i = 0; i < kMost; ++i)
    for (std::size_t j = 0; j < kMost; ++j) sum[i] += table.a[i][j] * p[j];
  return sum;
}

Column product(const Column& p, const Column& q) {
  Column all{};
  for (std::size_t i = 0; i < kMost; ++i) all[i] = p[i] * q[i];
  return all;
}

double dot(const Column& p, const Column& q) {
  double sum = 0.0;
  for (std::size_t i = 0; i < kMost; ++i) sum += p[i] * q[i];
  return sum;
}

// Residuals of Butcher's conditions for the weights b: one for each rooted tree, by order.
struct Miss {
  int order = 1;
  double by = 0.0;
};

std::vector<Miss> misses(const ButcherTable& t, const Column& b) {
  Column one{};
  for (std::size_t i = 0; i < static_cast<std::size_t>(t.stages); ++i) one[i] = 1.0;
  const Column c = times(t, one);
  const Column c2 = product(c, c);
  const Column c3 = product(c2, c);
  const Column ac = times(t, c);
  const Column ac2 = times(t, c2);
  const Column aac = times(t, ac);
  return {{1, dot(b, one) - 1.0},
          {2, dot(b, c) - 1.0 / 2},
          {3, dot(b, c2) - 1.0 / 3},
          {3, dot(b, ac) - 1.0 / 6},
          {4, dot(b, c3) - 1.0 / 4},
          {4, dot(b, product(c, ac)) - 1.0 / 8},
          {4, dot(b, ac2) - 1.0 / 12},
          {4, dot(b, aac) - 1.0 / 24},
          {5, dot(b, product(c2, c2)) - 1.0 / 5},
          {5, dot(b, product(c2, ac)) - 1.0 / 10},
          {5, dot(b, product(ac, ac)) - 1.0 / 20},
          {5, dot(b, product(c, ac2)) - 1.0 / 15},
          {5, dot(b, times(t, c3)) - 1.0 / 20},
          {5, dot(b, product(c, aac)) - 1.0 / 30},
          {5, dot(b, times(t, product(c, ac))) - 1.0 / 40},
          {5, dot(b, times(t, ac2)) - 1.0 / 60},
          {5, dot(b, times(t, aac)) - 1.0 / 120}};
}

// The highest order, up to 5, whose conditions are all fulfilled.
int order_of(const ButcherTable& table, const Column& b) {
  int order = 5;
  for (const Miss& miss : misses(table, b))
    if (std::abs(miss.by) > 1e-14) order = std::min(order, miss.order - 1);
  return order;
}

// One box that tumbles freely, with three different moments, and flies.
World top() {
  World world;
  world.add(box_properties(Vec3(3.0, 2.0, 1.0), 12.0), Vec3::Zero(), Quat::Identity(),
            Vec3(1.0, 2.0, 0.0), Vec3(1.0, 2.0, 3.0));
  return world;
}

World after(const ButcherTable& table, int steps, double duration = 1.0) {
  World world = top();
  RungeKutta method;
  JointForces forces;
  for (int k = 0; k < steps; ++k) method.step(table, duration / steps, {}, forces, world);
  return world;
}

double turned_by(const World& a, const World& b) {
  return angle_between(a.states()[0].orientation_wb, b.states()[0].orientation_wb);
}

}  // namespace

TEST_CASE("The coefficients of the three methods fulfil the conditions of orders 2, 4 and 5",
          "[exact][exterior_rotation]") {
  for (const ButcherTable* table :
       {&midpoint_table(), &classical_table(), &dormand_prince_table()}) {
    INFO(table->stages << " stages");
    CHECK(order_of(*table, table->b) == table->order);
    // Explicit: a stage uses those before it; entries beyond the stages are 0.
    for (std::size_t i = 0; i < kMost; ++i) {
      for (std::size_t j = i; j < kMost; ++j) CHECK(table->a[i][j] == 0.0);
      if (i >= static_cast<std::size_t>(table->stages)) {
        CHECK(table->b[i] == 0.0);
        CHECK(table->error[i] == 0.0);
      }
    }
  }
  CHECK(midpoint_table().order == 2);
  CHECK(classical_table().order == 4);
  CHECK(dormand_prince_table().order == 5);
}

TEST_CASE(
    "The stages of Dormand and Prince are at 1/5, 3/10, 4/5, 8/9 and 1, and the last is the answer",
    "[exact][exterior_rotation]") {
  const ButcherTable& table = dormand_prince_table();
  Column one{};
  one.fill(1.0);
  const Column c = times(table, one);
  const Column expected = {0.0, 1.0 / 5, 3.0 / 10, 4.0 / 5, 8.0 / 9, 1.0, 1.0};
  for (std::size_t i = 0; i < kMost; ++i) CHECK(c[i] == near(expected[i], 1e-14));
  CHECK(table.a[6] == table.b);
  // The other weights, of which the estimate is the difference, have exactly order 4.
  Column other{};
  for (std::size_t i = 0; i < kMost; ++i) other[i] = table.b[i] - table.error[i];
  CHECK(order_of(table, other) == 4);
}

TEST_CASE("A free top is followed at orders 2, 4 and 5", "[reference][exterior_rotation]") {
  const World truth = after(dormand_prince_table(), 2000);
  const auto order = [&](const ButcherTable& table) {
    const double coarse = turned_by(after(table, 100), truth);
    const double fine = turned_by(after(table, 200), truth);
    INFO(coarse << " " << fine);
    return std::log2(coarse / fine);
  };
  CHECK(order(midpoint_table()) == near(2.0, 0.1));
  CHECK(order(classical_table()) == near(4.0, 0.1));
  CHECK(order(dormand_prince_table()) == near(5.0, 0.1));
}

TEST_CASE("A top's momenta and the parabola of its centre are exact whatever the method",
          "[exact][exterior_rotation]") {
  const World start = top();
  for (const ButcherTable* table :
       {&midpoint_table(), &classical_table(), &dormand_prince_table()}) {
    const World end = after(*table, 20);
    // [kg m²/s] without torque there is no change at all
    CHECK(end.states()[0].angular_momentum_w == start.states()[0].angular_momentum_w);
    // [m] rounding
    CHECK((end.states()[0].position_w - Vec3(1.0, 2.0 - 0.5 * 9.81, 0.0)).norm() <= 1e-13);
    CHECK(end.states()[0].orientation_wb.norm() == near(1.0, 1e-15));
  }
}

TEST_CASE(
    "The error estimate scales with the fifth power of the step and has the size of the error",
    "[reference][exterior_rotation]") {
  const auto estimate = [](double dt) {
    World world = top();
    RungeKutta method;
    JointForces forces;
    return method.step(dormand_prince_table(), dt, {}, forces, world);
  };
  CHECK(std::log2(estimate(0.04) / estimate(0.02)) == near(5.0, 0.1));
  CHECK(std::log2(estimate(0.02) / estimate(0.01)) == near(5.0, 0.1));
  // One step of order 5 is better than its estimate, which is for order 4.
  World one = top();
  RungeKutta method;
  JointForces forces;
  const double told = method.step(dormand_prince_table(), 0.04, {}, forces, one);
  const double is = turned_by(one, after(dormand_prince_table(), 100, 0.04));
  CHECK(is < told);
  CHECK(is > 1e-3 * told);
  // A table without other weights gives no estimate.
  World classical = top();
  CHECK(method.step(classical_table(), 0.04, {}, forces, classical) == 0.0);
}

TEST_CASE("A step in which a body would make a full turn is rejected",
          "[unit][exterior_rotation]") {
  World world = top();
  world.states()[0].angular_momentum_w *= 100.0;  // some 400 rad/s
  const World start = world;
  RungeKutta method;
  JointForces forces;
  for (const ButcherTable* table :
       {&midpoint_table(), &classical_table(), &dormand_prince_table()}) {
    CHECK(std::isinf(method.step(*table, 0.1, {}, forces, world)));
    CHECK(same_states(world, start));
  }
  CHECK(std::isfinite(method.step(classical_table(), 0.001, {}, forces, world)));
  CHECK_FALSE(same_states(world, start));
}

TEST_CASE("A stage finds forces once, and immovable bodies stay where they are",
          "[unit][exterior_rotation]") {
  World world = world_of("fig6_1");
  const World start = world;
  const std::vector<Joint> joints = find_joints(world, tolerance::glue_margin);
  RungeKutta method;
  for (const ButcherTable* table :
       {&midpoint_table(), &classical_table(), &dormand_prince_table()}) {
    JointForces forces;
    method.step(*table, kFrame, joints, forces, world);
    CHECK(forces.solves() == table->stages);
  }
  CHECK(world.states()[0] == start.states()[0]);
  CHECK(world.states()[1] == start.states()[1]);
  CHECK(world.time() == 0.0);
}

TEST_CASE("A hinge that turns in space while it opens stays a hinge",
          "[exact][exterior_rotation]") {
  // Two cubes joined by an edge, each with its own spin about it, and both with one across it.
  World world = weightless_world();
  const BodyProperties cube = box_properties(Vec3::Ones(), 1.0);
  world.add(cube, Vec3::Zero());
  world.add(cube, Vec3::UnitY());
  std::vector<Joint> joints = find_joints(world, tolerance::glue_margin);
  REQUIRE(joints.size() == 1);
  joints[0].hold = JointHold::edge;
  const Vec3 along_w = (corner_of(joints[0], 1, world.states()).first_w -
                        corner_of(joints[0], 0, world.states()).first_w)
                           .normalized();
  const Vec3 edge_w = held_point(joints[0], world.states()).first_w;
  for (std::size_t k = 0; k < 2; ++k) {
    const Vec3 spin_w = Vec3(0.7, 1.1, -0.5) + (k == 0 ? 1.0 : -1.0) * along_w;
    world.states()[k] = make_state(cube, world.states()[k].position_w, Quat::Identity(),
                                   spin_w.cross(world.states()[k].position_w - edge_w), spin_w);
  }
  RungeKutta method;
  JointForces forces;
  for (int k = 0; k < 200; ++k) method.step(classical_table(), 1e-3, joints, forces, world);
  CHECK(gap_of(joints, world.states()).apart < 1e-11);  // [m] order 4 at 1 ms
  CHECK(std::abs(opened(joints[0], world.states())) > 0.1);
}
