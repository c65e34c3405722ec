/// \file
/// \brief The direct solver of an island, against pivoting and against Coulomb's conditions.
#include "tumble/contact_damped/island_solver.hpp"

#include "tumble/contact_damped/island_block.hpp"
#include "tumble/contact_patches/persistent_manifolds.hpp"
#include "tumble/math/complementarity.hpp"

#include "contact_damped/helpers.hpp"
#include "support/allocation_counter.hpp"
#include "support/test.hpp"

namespace {

constexpr double kStepGravity = kGravity * kFrame;  // [m/s] gained from gravity in a step

// A scene's bodies with a step of gravity and some motion of their own, and their patches.
struct TestIsland {
  World world;
  PersistentManifolds manifolds;
  std::vector<MovingBody> free;
  std::vector<MovingBody> bodies;
  std::vector<int> members;
  std::vector<int> contacts;

  TestIsland(std::string_view scene, const Settings& set, double speed, std::uint64_t seed)
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
    manifolds.find(world, free, all_pairs(world), kFrame, 1.0);
    for (std::size_t k = 0; k < manifolds.patches().size(); ++k)
      contacts.push_back(static_cast<int>(k));
    bodies = free;
  }

  Island view() {
    return {world, kFrame, members, contacts, contacts, manifolds.patches(), {}, {}, free, bodies};
  }

  IslandResult solve(IslandSolver& solver, int iterations, double residual = 1e-9) {
    return solver.solve(view(), {residual * kStepGravity, kStepGravity, iterations, 1e9});
  }
};

// Motion of a point of a patch: along, across, normal.
Vec3 motion_at(const ContactPatch& patch, const ContactPatchPoint& p,
               const std::vector<MovingBody>& bodies) {
  const Six u = motion_of(patch, bodies[static_cast<std::size_t>(patch.first)],
                          bodies[static_cast<std::size_t>(patch.second)]);
  return {u[0] - p.across * u[5], u[1] + p.along * u[5], u[2] + p.across * u[3] - p.along * u[4]};
}

// [m/s] The normal velocities that pivoting finds for an island without friction, point by point.
std::vector<double> velocities_by_pivoting(const TestIsland& island) {
  struct Point {
    const ContactPatch* patch;
    const ContactPatchPoint* point;
  };
  std::vector<Point> points;
  for (const ContactPatch& patch : island.manifolds.patches())
    for (std::size_t i = 0; i < static_cast<std::size_t>(patch.count); ++i)
      points.push_back({&patch, &patch.points[i]});
  const auto n = static_cast<Eigen::Index>(points.size());
  MatX A(n, n);
  VecX b(n);
  std::vector<MovingBody> still = island.free;
  for (MovingBody& body : still) {
    body.velocity_w.setZero();
    body.angular_velocity_w.setZero();
  }
  for (Eigen::Index j = 0; j < n; ++j) {
    const auto& [patch, p] = points[static_cast<std::size_t>(j)];
    std::vector<MovingBody> pushed = still;
    apply({0.0, 0.0, 1.0, p->across, -p->along, 0.0}, *patch,
          pushed[static_cast<std::size_t>(patch->first)],
          pushed[static_cast<std::size_t>(patch->second)]);
    for (Eigen::Index i = 0; i < n; ++i) {
      const Point& other = points[static_cast<std::size_t>(i)];
      A(i, j) = motion_at(*other.patch, *other.point, pushed)[2];
    }
    b[j] = motion_at(*patch, *p, island.free)[2] - p->target;
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
  double both = 0.0;    // [m/s] fastest separation of a point that pushes
  double slides = 0.0;  // [m/s] fastest motion across of a patch whose friction is not at its bound
  double beyond = 0.0;  // [-] friction beyond mu N
  double against = 0.0;  // [N s m/s] friction that drives
};

Wrong wrong_of(const TestIsland& island) {
  Wrong wrong;
  for (const ContactPatch& patch : island.manifolds.patches()) {
    const Six all = impulse_of(patch);
    const double friction = std::hypot(all[0], all[1]);
    const double bound = patch.friction * all[2];
    wrong.beyond = std::max(wrong.beyond, friction - bound);
    double fastest = 0.0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(patch.count); ++i) {
      const ContactPatchPoint& p = patch.points[i];
      const Vec3 u = motion_at(patch, p, island.bodies);
      wrong.pull = std::max(wrong.pull, -p.impulse);
      wrong.inside = std::max(wrong.inside, p.target - u[2]);
      if (p.impulse > 1e-6) wrong.both = std::max(wrong.both, u[2] - p.target);
      fastest = std::max(fastest, std::hypot(u[0], u[1]));
    }
    const Six u = motion_of(patch, island.bodies[static_cast<std::size_t>(patch.first)],
                            island.bodies[static_cast<std::size_t>(patch.second)]);
    if (friction < 0.9 * bound && std::abs(all[5]) < 1e-12)
      wrong.slides = std::max(wrong.slides, std::hypot(u[0], u[1]));
    wrong.against = std::max(wrong.against, all[0] * u[0] + all[1] * u[1] + all[5] * u[5]);
  }
  return wrong;
}

// A tower that turns about its lowest edge. Sweeps pass that on from cube to cube.
struct LeaningTower : TestIsland {
  std::vector<Quat> start_wb;

  explicit LeaningTower(int count)
      : TestIsland("stack", {{"count", std::to_string(count)}}, 0.0, 1) {
    for (const int k : members)
      bodies[idx(k)].velocity_w.x() = free[idx(k)].velocity_w.x() =
          0.01 * free[idx(k)].position_w.y();
    for (const BodyState& state : world.states()) start_wb.push_back(state.orientation_wb);
  }

  Island leaning() {
    Island island = view();
    island.start_wb = start_wb;
    island.start = free;
    return island;
  }
};

// Returns the largest change of a velocity in the sweep up.
double sweep_down_and_up(const Island& island, IslandBlock& left) {
  StepReport report;
  sweep(island, SweepOrder::down, 2, 0.0, report);
  return sweep(island, SweepOrder::up, 2, 0.0, report, left.changes(island));
}

}  // namespace

TEST_CASE("Without friction an island ends with the velocities that pivoting finds",
          "[reference][contact_damped]") {
  // The velocities are unique, the impulses of patches with four points are not.
  IslandSolver solver;
  double worst = 0.0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const bool pyramid = seed % 2 == 0;
    const Settings set = pyramid ? Settings{{"rows", "3"}, {"friction", "0"}}
                                 : Settings{{"count", "4"}, {"friction", "0"}};
    TestIsland island(pyramid ? "pyramid" : "stack", set, 0.05, seed);
    const std::vector<double> exact = velocities_by_pivoting(island);
    const IslandResult result = island.solve(solver, 2000);
    INFO("seed " << seed << ", iterations " << result.iterations << ", wrong " << result.residual);
    CHECK(result.converged);
    std::size_t point = 0;
    for (const ContactPatch& patch : island.manifolds.patches())
      for (std::size_t i = 0; i < static_cast<std::size_t>(patch.count); ++i) {
        const ContactPatchPoint& p = patch.points[i];
        const double a = motion_at(patch, p, island.bodies)[2] - p.target;
        worst = std::max(worst, std::abs(a - exact[point++]));
      }
  }
  INFO("largest difference " << worst << " m/s");
  CHECK(worst < 1e-8 * kStepGravity);  // [m/s] measured 2.1e-10, with 1e-9 g h asked for
}

TEST_CASE("A solved island meets Coulomb's conditions", "[exact][contact_damped]") {
  IslandSolver solver;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    for (const double speed : {1e-3, 0.05}) {
      TestIsland island(seed % 2 == 0 ? "pyramid" : "stack",
                        seed % 2 == 0 ? Settings{{"rows", "3"}} : Settings{{"count", "4"}}, speed,
                        seed);
      const IslandResult result = island.solve(solver, 2000);
      INFO("seed " << seed << ", speed " << speed << ", iterations " << result.iterations
                   << ", wrong " << result.residual);
      CHECK(result.accepted);
      CHECK(result.converged);
      const Wrong wrong = wrong_of(island);
      CHECK(wrong.pull <= 0.0);
      CHECK(wrong.beyond < 1e-12);                 // [N s] rounding
      CHECK(wrong.inside < 1e-6 * kStepGravity);   // [m/s]
      CHECK(wrong.both < 1e-6 * kStepGravity);     // [m/s]
      CHECK(wrong.slides < 1e-6 * kStepGravity);   // [m/s]
      CHECK(wrong.against < 1e-6 * kStepGravity);  // [J]
    }
  }
}

TEST_CASE("An island that would cost more than allowed is not changed", "[unit][contact_damped]") {
  TestIsland island("stack", {{"count", "3"}}, 0.1, 1);
  IslandSolver solver;
  const IslandLimits limits{1e-9, kStepGravity, 20, 1.0};
  const IslandResult result = solver.solve(island.view(), limits);
  CHECK(!result.accepted);
  CHECK(result.iterations == 0);
  for (std::size_t k = 0; k < island.bodies.size(); ++k)
    CHECK(island.bodies[k].velocity_w == island.free[k].velocity_w);
  for (const ContactPatch& patch : island.manifolds.patches()) CHECK(impulse_of(patch)[2] == 0.0);
}

TEST_CASE("A solution does not depend on what was solved before, and allocates nothing once warm",
          "[unit][contact_damped]") {
  IslandSolver solver;
  const auto solved = [&] {
    TestIsland island("stack", {{"count", "5"}}, 0.0, 1);
    CHECK(island.solve(solver, 60, 1e-5).converged);
    return island.bodies;
  };
  const std::vector<MovingBody> first = solved();
  TestIsland other("stack", {{"count", "7"}}, 0.0, 1);
  other.solve(solver, 60, 1e-5);
  const std::vector<MovingBody> again = solved();
  for (std::size_t k = 0; k < first.size(); ++k) CHECK(again[k].velocity_w == first[k].velocity_w);
  TestIsland warm("stack", {{"count", "5"}}, 0.0, 1);
  const AllocationCount count;
  warm.solve(solver, 60, 1e-5);
  CHECK(count.value() == 0);
}

TEST_CASE("A tower that leans is stopped as the block that sweeps leave",
          "[unit][contact_damped]") {
  const auto pairs_of_sweeps = [](bool with_blocks) {
    LeaningTower tower(10);
    const Island island = tower.leaning();
    IslandBlock left;
    for (int pairs = 1;; ++pairs) {
      if (sweep_down_and_up(island, left) < 1e-7) return pairs;
      if (with_blocks)
        IslandSolver().solve(left.find(island), {1e-6 * kStepGravity, kStepGravity, 100, 1e9});
    }
  };
  const int plain = pairs_of_sweeps(false), with_blocks = pairs_of_sweeps(true);
  CAPTURE(plain, with_blocks);
  CHECK(100 * with_blocks < plain);
}

TEST_CASE("A wedged body is in the block, although its velocity stays while its impulses change",
          "[unit][contact_damped]") {
  LeaningTower tower(24);
  const Island island = tower.leaning();
  IslandBlock left;
  for (double& change : left.changes(island)) change = 0.0;
  CHECK(left.find(island).bodies.empty());
  const int contact = island.patch_indices[12];
  left.changes(island)[idx(contact)] = 0.01 * kStepGravity;
  const ContactPatch& patch = island.all_patches[idx(contact)];
  const Island block = left.find(island);
  for (const int body : {patch.first, patch.second})
    CHECK(std::count(block.bodies.begin(), block.bodies.end(), body) == 1);
  CHECK(block.patch_indices.size() == 3);
}

TEST_CASE("While a block of an island is solved, all other impulses are held",
          "[unit][contact_damped]") {
  LeaningTower tower(24);
  const Island island = tower.leaning();
  IslandBlock left;
  sweep_down_and_up(island, left);
  const std::vector<ContactPatch> before = tower.manifolds.patches();
  const Island block = left.find(island);
  CHECK(block.patch_indices.size() > 10);
  CHECK(block.patch_indices.size() < before.size());
  CHECK(IslandSolver().solve(block, {1e-6 * kStepGravity, kStepGravity, 100, 1e9}).converged);
  for (std::size_t k = 0; k < before.size(); ++k) {
    const bool held = !std::binary_search(block.patch_indices.begin(), block.patch_indices.end(),
                                          static_cast<int>(k));
    CHECK((impulse_of(before[k]) == impulse_of(tower.manifolds.patches()[k])) == held);
  }
  // Velocities are those of all impulses.
  const std::vector<MovingBody> now = tower.bodies;
  tower.bodies = tower.free;
  warm_start(island);
  for (const int k : tower.members)
    CHECK((now[idx(k)].velocity_w - tower.bodies[idx(k)].velocity_w).norm() < 1e-12);
}
