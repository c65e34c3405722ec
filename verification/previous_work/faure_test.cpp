/// \file
/// \brief Faure's iteration, as a solver and as a technique.
#include "tumble/previous_work/faure.hpp"

#include "tumble/lcp_solvers/baraff.hpp"
#include "tumble/previous_work/faure_solver.hpp"

#include "impulse_damped/scene_runs.hpp"
#include "support/test.hpp"

namespace {

// Contacts that depend on each other: A = J Jᵀ with fewer columns than rows, b in its range so that there is an answer.
LcpProblem coupled(std::uint64_t seed, int rows, int columns) {
  Random chance(seed);
  MatX J(rows, columns);
  VecX u(columns);
  for (int k = 0; k < columns; ++k) {
    for (int i = 0; i < rows; ++i) J(i, k) = chance.uniform(-1.0, 1.0);
    u[k] = chance.uniform(-1.0, 1.0);
  }
  LcpProblem problem{MatX::Zero(rows, rows), VecX::Zero(rows), {}};
  for (int i = 0; i < rows; ++i) {
    problem.b[i] = J.row(i).dot(u);
    for (int k = 0; k < rows; ++k) problem.A(i, k) = J.row(i).dot(J.row(k));
  }
  return problem;
}

double forces_energy(const LcpProblem& problem, const LcpResult& result) {
  double sum = 0.0;
  for (int i = 0; i < problem.size(); ++i) {
    const auto k = idx(i);
    sum += 0.5 * result.f[k] * (result.a[k] + problem.b[i]);
  }
  return sum;
}

// A stack of ten with a budget, for a second.
struct Stacked {
  double moved = 0.0;  // [m]
  double speed = 0.0;  // [m/s] of the fastest box at the end
};

Stacked stack_with(int budget, bool warm) {
  World world = world_of("stack", {{"count", "10"}});
  Faure technique({.budget = budget, .warm = warm});
  const double moved = run(world, technique, 1.0).moved;
  return {moved, fastest_of(world)};
}

// Cubes without friction that fly into each other in free space.
World crowd(std::uint64_t seed) {
  World world = weightless_world();
  for (std::uint64_t k = 0; k < 12; ++k) {
    Random chance = Random(seed).fork(k);
    BodyProperties body = box_properties(Vec3::Ones(), chance.uniform(0.3, 3.0));
    body.friction = 0.0;
    const Vec3 place_w = chance.in_cube(2.5);
    const Quat turn = chance.orientation();
    const Vec3 push_w = -place_w + chance.in_cube(1.0);
    world.add(body, place_w, turn, push_w);
  }
  return world;
}

}  // namespace

TEST_CASE(
    "Each step of Faure's iteration lowers the energy, and it ends at the answer of a direct "
    "solver",
    "[exact][faure]") {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const LcpProblem problem = coupled(seed, 12, 8);
    CAPTURE(seed);
    LcpResult direct;
    BaraffSolver().solve(problem, direct);
    REQUIRE(direct.status == LcpStatus::solved);
    LcpResult result;
    FaureSolver(5000).solve(problem, result);
    CHECK(result.status == LcpStatus::solved);
    CHECK(result.residual < 1e-8);
    for (std::size_t i = 0; i < 12; ++i)  // accelerations are unique, forces are not
      CHECK(std::abs(result.a[i] - direct.a[i]) < 1e-7);
    double before = 0.0;  // of no forces
    for (int budget = 1; budget <= 30; ++budget) {
      FaureSolver(budget, 0.0).solve(problem, result);
      const double now = forces_energy(problem, result);
      CHECK(now <= before + 1e-12);
      before = now;
    }
  }
}

TEST_CASE("Faure's iteration says where its budget ended", "[unit][faure]") {
  const LcpProblem problem = coupled(1, 12, 8);
  LcpResult result;
  FaureSolver(2).solve(problem, result);
  CHECK(result.status == LcpStatus::cap_reached);
  CHECK(result.pivots == 2);
  CHECK(result.multiplications >= 2 * 12 * 12);
  for (const double f : result.f) CHECK(f >= 0.0);
  CHECK_THROWS_WITH(FaureSolver(-1), "tumble: budget = -1: expected 0 or more");
  CHECK_THROWS_AS(FaureSolver(1, -1.0), std::invalid_argument);
  CHECK_THROWS_WITH(Faure({.budget = -1}), "tumble: budget = -1: expected 0 or more");
  CHECK_THROWS_AS(Faure({.wanted = -1.0}), std::invalid_argument);
}

TEST_CASE("A stack under Faure's method rests, and sinks in if its budget is small",
          "[exact][faure]") {
  CHECK(stack_with(60, true).moved < 1e-9);   // [m] measured: 3e-13
  CHECK(stack_with(60, false).moved < 1e-6);  // [m] measured: 3e-8
  const Stacked hasty = stack_with(5, false);
  CHECK(hasty.moved > 1e-3);  // [m] measured: 0.01, down to the slop of repair
  CHECK(hasty.speed > 1e-3);  // [m/s]
  // Warm starts end what trembles.
  CHECK(stack_with(5, true).speed < 0.1 * hasty.speed);
}

TEST_CASE("Without any step of the iteration nothing holds a box", "[unit][faure]") {
  World world = world_of("stack", {{"count", "1"}});
  Faure technique({.budget = 0});
  technique.step(world, kFrame);
  CHECK(world.states()[1].linear_momentum_w.y() == near(-kGravity * kFrame, 1e-12));
  CHECK(technique.descent().iterations == 0);
  CHECK_FALSE(technique.descent().settled);
}

TEST_CASE("Under Faure's method a cube bounces with its restitution", "[exact][faure]") {
  for (const double e : {0.3, 0.9}) {
    World world = weightless_world();
    BodyProperties cube = box_properties(Vec3::Ones(), 2.0);
    cube.restitution = e;
    const BodyProperties wall = fixed_box_properties(Vec3(1.0, 4.0, 4.0));
    world.add(wall, Vec3::Zero());
    world.add(cube, Vec3(1.1, 0.0, 0.0), Quat::Identity(), Vec3(-3.0, 0.0, 0.0));
    Faure technique;
    run(world, technique, 0.5);
    CHECK(world.states()[1].linear_momentum_w.x() == near(2.0 * 3.0 * e, 1e-5));
  }
}

TEST_CASE("An iteration that is ended early adds no energy without friction and restitution",
          "[exact][faure]") {
  for (const int budget : {1, 2, 3, 10}) {
    for (const bool warm : {false, true}) {
      World world = crowd(7);
      Faure technique({.budget = budget, .warm = warm});
      double energy = tumble::energy_of(world).kinetic;
      const double start = energy;
      for (int k = 0; k < 120; ++k) {
        technique.step(world, kFrame);
        const double now = tumble::energy_of(world).kinetic;
        CAPTURE(budget, warm, k);
        REQUIRE(now <= energy + 1e-12 * start);
        energy = now;
      }
      CHECK(energy < 0.95 * start);  // they have met
    }
  }
}
