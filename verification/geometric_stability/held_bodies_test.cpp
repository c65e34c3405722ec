/// \file
/// \brief Stable boxes left out of the contact forces: all else is unchanged.
#include "tumble/analytic_lcp/held_bodies.hpp"

#include "tumble/analytic_lcp/analytic.hpp"

#include "analytic_lcp/instant.hpp"
#include "geometric_stability/resting_pile.hpp"
#include "support/scenes.hpp"
#include "support/test.hpp"

namespace {

using namespace tumble::chapters;
using test::kG;

constexpr const char* kSolver = "augmented_lagrangian";

constexpr std::array<StableRule, 3> kRules{StableRule::corners, StableRule::hull,
                                           StableRule::equilibrium};

// Three courses of boxes of random widths and masses. Neighbours may touch; upper boxes have random
// positions, so that some overhang, tip, and push their neighbours aside.
World random_courses(Random random) {
  World world = ground_world();
  double left = 0.0;
  double right = 4.5;
  for (int course = 0; course < 3; ++course) {
    double x = left;
    double end = left;
    while (x < right) {
      const double width = random.uniform(0.5, 1.4);
      const double depth = random.uniform(0.5, 1.0);
      const double mass = random.uniform(0.2, 3.0);
      const double z = random.uniform(-0.2, 0.2);
      test::add_box(world, Vec3(width, 0.5, depth), mass,
                    Vec3(x + 0.5 * width, 0.5 * course + 0.25, z));
      end = x + width;
      const bool touches = random.unit() < 0.4;
      x = touches ? end : end + random.uniform(0.02, 0.4);
    }
    left += random.uniform(-0.4, 0.5);
    right = end - 0.1;
  }
  return world;
}

// Checks common to all tests of one instant.
ForceReport check_nothing_changes(const RestingPile& instant, StableRule rule,
                                  const char* solver = kSolver) {
  const RestingForces all = forces_of(instant, solver, StableRule::off);
  const RestingForces left = forces_of(instant, solver, rule);
  const ForceChange change = change_of(instant, all, left);
  double held = 0.0;  // [-] of g: acceleration of held bodies in the full system
  for (std::size_t b = 0; b < left.held.size(); ++b)
    if (left.held[b] != 0 && instant.world.bodies()[b].movable())
      held = std::max(held, fastest_of(instant.world.bodies()[b], all.accelerations[b]) / kG);
  CAPTURE(static_cast<int>(rule), change.acceleration, change.wrench, held, left.report.stable);
  // [-] measured: 7e-11, 9e-12 and 2e-11.
  CHECK(change.acceleration <= 1e-9);
  CHECK(change.wrench <= 1e-9);
  CHECK(held <= 1e-9);
  CHECK(left.report.unknowns <= all.report.unknowns);
  return left.report;
}

StepReport one_step(Technique& technique, World& world) {
  const StepReport report = technique.step(world, kFrame);
  REQUIRE(report.status == StepStatus::done);
  return report;
}

AnalyticOptions options_of(AnalyticFriction friction, StableRule rule) {
  return AnalyticOptions{.friction = friction, .stable_boxes = rule};
}

}  // namespace

TEST_CASE("Leaving stable boxes out changes no acceleration", "[exact][geometric_stability]") {
  SECTION("random courses, some boxes of which tip") {
    std::array<int, 3> left_out{};
    int tip = 0;
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
      CAPTURE(seed);
      const RestingPile instant = pile_of(random_courses(Random(seed)));
      for (std::size_t k = 0; k < kRules.size(); ++k)
        left_out[k] += check_nothing_changes(instant, kRules[k]).stable;
      const RestingForces all = forces_of(instant, kSolver, StableRule::off);
      tip += std::ranges::any_of(
          all.accelerations, [](const Acceleration& a) { return a.linear_w.norm() > 0.01 * kG; });
    }
    // Otherwise nothing would have been tested.
    CHECK(left_out[0] > 100);
    CHECK(left_out[1] == left_out[0]);  // for boxes both rules agree
    CHECK(left_out[2] > left_out[0]);
    CHECK(tip > 20);
  }
  SECTION("the same while all slide along the ground, each at its own speed") {
    for (std::uint64_t seed = 1; seed <= 30; ++seed) {
      CAPTURE(seed);
      World world = random_courses(Random(seed));
      Random random = Random(seed).fork(1);
      for (int b = 1; b < world.count(); ++b) {
        Vec3 velocity_w = random.in_cube(0.1);
        velocity_w.y() = 0.0;
        world.states()[idx(b)].linear_momentum_w = world.bodies()[idx(b)].mass * velocity_w;
      }
      const RestingPile instant = pile_of(world);
      for (const StableRule rule : kRules) check_nothing_changes(instant, rule);
    }
  }
  SECTION("the pyramid of figure 5.6, with a gap and without, and a wall") {
    for (const char* rows : {"3", "7", "11"})
      for (const char* gap : {"0.05", "0"}) {
        CAPTURE(rows, gap);
        const RestingPile instant = pile_of(world_of("fig5_6", {{"rows", rows}, {"gap", gap}}));
        for (const StableRule rule : kRules) check_nothing_changes(instant, rule);
      }
    const RestingPile wall = pile_of(world_of("wall", {{"courses", "6"}, {"bricks", "6"}}));
    for (const StableRule rule : kRules) CHECK(check_nothing_changes(wall, rule).stable >= 21);
  }
  SECTION("with the solver of the thesis") {
    const RestingPile instant = pile_of(world_of("fig5_6", {{"rows", "7"}}));
    for (const StableRule rule : kRules) check_nothing_changes(instant, rule, "baraff");
  }
}

TEST_CASE("Without its stable boxes the pyramid of figure 5.6 has 112 unknown forces of 184",
          "[exact][geometric_stability]") {
  // Seven rows: 4 points a pair of faces; 15 light boxes on two others each, but for two on one.
  const RestingPile instant = pile_of(world_of("fig5_6", {{"rows", "7"}}));
  const ForceReport all = forces_of(instant, kSolver, StableRule::off).report;
  CHECK(all.unknowns == 4 * (6 + 2 * 21 - 2));
  CHECK(all.stable == 0);
  for (const StableRule rule : {StableRule::corners, StableRule::hull}) {
    const ForceReport left = forces_of(instant, kSolver, rule).report;
    CHECK(left.unknowns == 4 * (2 * 15 - 2));
    CHECK(left.stable == 12);
  }
  // All of it is in equilibrium.
  const ForceReport none = forces_of(instant, kSolver, StableRule::equilibrium).report;
  CHECK(none.unknowns == 0);
  CHECK(none.stable == 27);
}

TEST_CASE("Stable boxes are not left out of forces with Coulomb's friction",
          "[unit][geometric_stability]") {
  for (const StableRule rule : kRules) {
    CHECK_THROWS_WITH(ContactForces({.stable_boxes = rule}),
                      Contains("friction=none or friction=damping"));
    CHECK_THROWS_WITH(Analytic(options_of(AnalyticFriction::coulomb, rule)),
                      Contains("stable_boxes=off"));
    CHECK_NOTHROW(Analytic(options_of(AnalyticFriction::none, rule)));
    CHECK_NOTHROW(Analytic(options_of(AnalyticFriction::damping, rule)));
  }
}

TEST_CASE("A box that lands on a stable one comes to rest on it, whichever bodies are held",
          "[exact][geometric_stability]") {
  // The second cube lands over the edge of the first one by a quarter, and stays.
  const auto drop = [](StableRule rule) {
    World world = ground_world();
    test::add_box(world, Vec3::Ones(), 1.0, Vec3(0.0, 0.5, 0.0));
    test::add_box(world, Vec3::Ones(), 1.0, Vec3(0.25, 1.7, 0.0));
    Analytic analytic(options_of(AnalyticFriction::none, rule));
    for (int step = 0; step < 60; ++step) one_step(analytic, world);
    if (rule != StableRule::off) {
      CHECK(analytic.held()[1] != 0);
      CHECK((analytic.held()[2] != 0) == (rule == StableRule::equilibrium));
    }
    return world;
  };
  const World off = drop(StableRule::off);
  CHECK(off.states()[2].position_w.y() == near(1.5, 1e-4));  // [m] within the margin of contacts
  for (const StableRule rule : kRules) {
    CAPTURE(static_cast<int>(rule));
    const World left = drop(rule);
    for (int b : {1, 2}) {
      // [m] and [kg m/s]; measured 2e-16 and 6e-16.
      const BodyState& a = off.states()[idx(b)];
      const BodyState& c = left.states()[idx(b)];
      CHECK((a.position_w - c.position_w).norm() <= 1e-9);
      CHECK((a.linear_momentum_w - c.linear_momentum_w).norm() <= 1e-9);
    }
    CHECK(left.states()[1].position_w.y() == near(0.5, 1e-12));
  }
}

TEST_CASE("A stable box that slides is left out, and is damped as if it were not",
          "[exact][geometric_stability]") {
  const auto slide = [](StableRule rule, int steps) {
    World world = world_of("fig5_4", {{"speed", "0.5"}});
    Analytic analytic(options_of(AnalyticFriction::damping, rule));
    for (int step = 0; step < steps; ++step) {
      one_step(analytic, world);
      if (rule == StableRule::off) continue;
      CHECK(analytic.held()[1] != 0);
      CHECK(analytic.held()[2] != 0);
    }
    return world;
  };
  const DampingShares shares;
  for (const StableRule rule : kRules) {
    CAPTURE(static_cast<int>(rule));
    // [kg m/s] the share of 0.5 that remains after a step.
    const World once = slide(rule, 1);
    CHECK(once.states()[2].linear_momentum_w.x() == near(0.5 * shares.velocity, 1e-12));
    const World later = slide(rule, 20);
    const World off = slide(StableRule::off, 20);
    CHECK(later.states()[2].linear_momentum_w.x() ==
          near(0.5 * elementary::pow(shares.velocity, 20.0), 1e-12));
    for (int b : {1, 2})
      CHECK((later.states()[idx(b)].position_w - off.states()[idx(b)].position_w).norm() <= 1e-12);
  }
}
