/// \file
/// \brief All contact areas of a heap together, against pivoting and against Coulomb's conditions.
#include "tumble/contact_damped/island_solver.hpp"

#include "tumble/contact_damped/persistent_manifolds.hpp"
#include "tumble/math/complementarity.hpp"

#include "impulse_damped/scene_runs.hpp"
#include "support/allocation_counter.hpp"
#include "support/catch.hpp"

#include <cmath>

using namespace tumble;
using namespace tumble::test;

namespace {

constexpr double kStepGravity = kGravity * kFrame;  // [m/s] what a step of gravity gives

// A scene's bodies with a step of gravity and some motion of their own, and their areas.
struct Heap {
  World world;
  PersistentManifolds areas;
  std::vector<MovingBody> free;
  std::vector<MovingBody> bodies;
  std::vector<int> members;
  std::vector<int> contacts;

  Heap(std::string_view scene, const Settings& set, double speed, std::uint64_t seed)
      : world(world_of(scene, set)) {
    load_moving_bodies(world, free);
    for (std::size_t k = 0; k < free.size(); ++k) {
      if (!world.bodies()[k].movable()) continue;
      Random chance = Random(seed).fork(k);
      const Vec3 motion = chance.in_cube(speed);
      const Vec3 spin = chance.in_cube(speed);
      free[k].velocity_w = kFrame * world.gravity_w + motion;
      free[k].angular_velocity_w = spin;
      members.push_back(static_cast<int>(k));
    }
    std::vector<IndexPair> candidates;
    for (int k = 0; k < world.count(); ++k)
      for (int j = k + 1; j < world.count(); ++j) candidates.push_back({k, j});
    areas.find(world, free, candidates, kFrame, 1.0);
    for (std::size_t k = 0; k < areas.blocks().size(); ++k) contacts.push_back(static_cast<int>(k));
    bodies = free;
  }

  IslandResult solve(IslandSolver& solver, int rounds, double enough = 1e-9) {
    const IslandLimits limits{enough * kStepGravity, kStepGravity, rounds, 1e9};
    return solver.solve(members, contacts, limits, free, areas.blocks(), bodies);
  }
};

// Motion of a point of an area: along, across, normal.
Vec3 motion_at(const ContactPatch& block, const ContactPatchPoint& p,
               const std::vector<MovingBody>& bodies) {
  const Six u = motion_of(block, bodies[static_cast<std::size_t>(block.first)],
                          bodies[static_cast<std::size_t>(block.second)]);
  return {u[0] - p.across * u[5], u[1] + p.along * u[5], u[2] + p.across * u[3] - p.along * u[4]};
}

// [m/s] The normal velocities that pivoting finds for a heap without friction, point by point.
std::vector<double> velocities_by_pivoting(const Heap& heap) {
  struct Point {
    const ContactPatch* block;
    const ContactPatchPoint* point;
  };
  std::vector<Point> points;
  for (const ContactPatch& block : heap.areas.blocks())
    for (std::size_t i = 0; i < static_cast<std::size_t>(block.count); ++i)
      points.push_back({&block, &block.points[i]});
  const auto n = static_cast<Eigen::Index>(points.size());
  MatX A(n, n);
  VecX b(n);
  std::vector<MovingBody> still = heap.free;
  for (MovingBody& body : still) {
    body.velocity_w.setZero();
    body.angular_velocity_w.setZero();
  }
  for (Eigen::Index j = 0; j < n; ++j) {
    const auto& [block, p] = points[static_cast<std::size_t>(j)];
    std::vector<MovingBody> pushed = still;
    apply({0.0, 0.0, 1.0, p->across, -p->along, 0.0}, *block,
          pushed[static_cast<std::size_t>(block->first)],
          pushed[static_cast<std::size_t>(block->second)]);
    for (Eigen::Index i = 0; i < n; ++i) {
      const Point& other = points[static_cast<std::size_t>(i)];
      A(i, j) = motion_at(*other.block, *other.point, pushed)[2];
    }
    b[j] = motion_at(*block, *p, heap.free)[2] - p->target;
  }
  A = (0.5 * (A + A.transpose())).eval();
  ComplementaritySolver solver;
  ComplementarityResult result;
  solver.solve(A, b, result);
  REQUIRE(result.status == ComplementarityStatus::solved);
  REQUIRE(result.residual < 1e-9);
  return result.a;
}

struct Wrong {
  double pull = 0.0;    // [N s] largest
  double inside = 0.0;  // [m/s] fastest approach beyond the target
  double both = 0.0;    // [m/s] fastest parting of a point that pushes
  double slides = 0.0;  // [m/s] fastest motion across of an area whose friction is not at its bound
  double beyond = 0.0;  // [-] friction beyond mu N
  double against = 0.0;  // [N s m/s] friction that drives
};

Wrong wrong_of(const Heap& heap) {
  Wrong wrong;
  for (const ContactPatch& block : heap.areas.blocks()) {
    const Six all = impulse_of(block);
    const double rub = std::hypot(all[0], all[1]);
    const double bound = block.friction * all[2];
    wrong.beyond = std::max(wrong.beyond, rub - bound);
    double fastest = 0.0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(block.count); ++i) {
      const ContactPatchPoint& p = block.points[i];
      const Vec3 u = motion_at(block, p, heap.bodies);
      wrong.pull = std::max(wrong.pull, -p.impulse);
      wrong.inside = std::max(wrong.inside, p.target - u[2]);
      if (p.impulse > 1e-6) wrong.both = std::max(wrong.both, u[2] - p.target);
      fastest = std::max(fastest, std::hypot(u[0], u[1]));
    }
    const Six u = motion_of(block, heap.bodies[static_cast<std::size_t>(block.first)],
                            heap.bodies[static_cast<std::size_t>(block.second)]);
    if (rub < 0.9 * bound && std::abs(all[5]) < 1e-12)
      wrong.slides = std::max(wrong.slides, std::hypot(u[0], u[1]));
    wrong.against = std::max(wrong.against, all[0] * u[0] + all[1] * u[1] + all[5] * u[5]);
  }
  return wrong;
}

}  // namespace

TEST_CASE("Without friction a heap ends with the velocities that pivoting finds",
          "[reference][contact_damped][impulse_damped]") {
  // The velocities are unique, the impulses of areas with four points are not.
  IslandSolver solver;
  double worst = 0.0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const bool pyramid = seed % 2 == 0;
    const Settings set = pyramid ? Settings{{"rows", "3"}, {"friction", "0"}}
                                 : Settings{{"count", "4"}, {"friction", "0"}};
    Heap heap(pyramid ? "pyramid" : "stack", set, 0.05, seed);
    const std::vector<double> exact = velocities_by_pivoting(heap);
    const IslandResult result = heap.solve(solver, 2000);
    INFO("seed " << seed << ", rounds " << result.rounds << ", wrong " << result.wrong);
    CHECK(result.solved);
    std::size_t point = 0;
    for (const ContactPatch& block : heap.areas.blocks())
      for (std::size_t i = 0; i < static_cast<std::size_t>(block.count); ++i) {
        const ContactPatchPoint& p = block.points[i];
        const double a = motion_at(block, p, heap.bodies)[2] - p.target;
        worst = std::max(worst, std::abs(a - exact[point++]));
      }
  }
  INFO("largest difference " << worst << " m/s");
  CHECK(worst < 1e-8 * kStepGravity);  // [m/s] measured 2.1e-10, with 1e-9 g h asked for
}

TEST_CASE("A heap that is solved keeps Coulomb's conditions",
          "[exact][contact_damped][impulse_damped]") {
  IslandSolver solver;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    for (const double speed : {1e-3, 0.05}) {
      Heap heap(seed % 2 == 0 ? "pyramid" : "stack",
                seed % 2 == 0 ? Settings{{"rows", "3"}} : Settings{{"count", "4"}}, speed, seed);
      const IslandResult result = heap.solve(solver, 2000);
      INFO("seed " << seed << ", speed " << speed << ", rounds " << result.rounds << ", wrong "
                   << result.wrong);
      CHECK(result.tried);
      CHECK(result.solved);
      const Wrong wrong = wrong_of(heap);
      CHECK(wrong.pull <= 0.0);
      CHECK(wrong.beyond < 1e-12);                 // [N s] rounding
      CHECK(wrong.inside < 1e-6 * kStepGravity);   // [m/s]
      CHECK(wrong.both < 1e-6 * kStepGravity);     // [m/s]
      CHECK(wrong.slides < 1e-6 * kStepGravity);   // [m/s]
      CHECK(wrong.against < 1e-6 * kStepGravity);  // [J]
    }
  }
}

TEST_CASE("A heap that would cost more than allowed is left as it is",
          "[unit][contact_damped][impulse_damped]") {
  Heap heap("stack", {{"count", "3"}}, 0.1, 1);
  IslandSolver solver;
  const IslandLimits limits{1e-9, kStepGravity, 20, 1.0};
  const IslandResult result = solver.solve(heap.members, heap.contacts, limits, heap.free,
                                           heap.areas.blocks(), heap.bodies);
  CHECK(!result.tried);
  CHECK(result.rounds == 0);
  for (std::size_t k = 0; k < heap.bodies.size(); ++k)
    CHECK(heap.bodies[k].velocity_w == heap.free[k].velocity_w);
  for (const ContactPatch& block : heap.areas.blocks()) CHECK(impulse_of(block)[2] == 0.0);
}

TEST_CASE("A heap that was solved before is factored once and asks for no memory",
          "[unit][contact_damped][impulse_damped]") {
  Heap heap("stack", {{"count", "5"}}, 0.0, 1);
  IslandSolver solver;
  CHECK(heap.solve(solver, 60, 1e-5).factorings > 0);
  heap.solve(solver, 60, 1e-5);  // from impulses that are right: no other stiffness is tried
  heap.bodies = heap.free;
  const IslandResult again = heap.solve(solver, 60, 1e-5);
  CHECK(again.solved);
  CHECK(again.factorings == 0);
  const AllocationCount count;
  heap.solve(solver, 60, 1e-5);
  CHECK(count.value() == 0);
}
