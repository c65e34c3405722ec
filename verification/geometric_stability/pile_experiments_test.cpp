/// \file
/// \brief Random piles: their boxes, those that rest, and all ways to classify them (thesis 5.4, 6.3.1).
#include "tumble/geometric_stability/load_proof.hpp"
#include "tumble/geometric_stability/static_equilibrium.hpp"

#include "driver/quick.hpp"
#include "geometric_stability/disputes.hpp"
#include "geometric_stability/pile_builder.hpp"
#include "geometric_stability/pile_forces.hpp"
#include "geometric_stability/pile_levels.hpp"
#include "geometric_stability/pile_loads.hpp"
#include "geometric_stability/prisms.hpp"
#include "geometric_stability/random_piles.hpp"
#include "support/test.hpp"

using namespace tumble::chapters;

namespace {

constexpr int kPiles = 60;

World pile(int seed) { return random_pile(static_cast<std::uint64_t>(seed)); }

// The difference of two accelerations of one body.
double apart(const BodyProperties& body, const Acceleration& a, const Acceleration& b) {
  return fastest_of(body, {a.linear_w - b.linear_w, a.angular_w - b.angular_w});
}

// A load of a thousand weights on each corner of each top of bodies that are in a set, or not.
std::vector<std::vector<Wrench>> single_loads(const World& world) {
  std::vector<std::vector<Wrench>> cases;
  for (int b = 0; b < world.count(); ++b) {
    if (!world.bodies()[idx(b)].movable()) continue;
    for (const Vec3& corner_w : top_of(world, b)) {
      cases.emplace_back(world.bodies().size());
      cases.back()[idx(b)] =
          weight_at(world.states()[idx(b)], corner_w, 1000.0 * world.bodies()[idx(b)].mass * 9.81);
    }
  }
  return cases;
}

}  // namespace

TEST_CASE("Boxes of a random pile rest on one another without overlap and without a gap",
          "[unit][geometric_stability]") {
  const SeparationOptions exact{.prefer_faces = false, .enough = kInfinity};
  int vertical = 0;
  int others = 0;
  for (int seed = 1; seed <= kPiles; ++seed) {
    const World world = pile(seed);
    REQUIRE(world.count() > 5);
    std::vector<char> touched(world.bodies().size(), 0);
    for (const Contact& contact : touching(world)) {
      touched[idx(contact.first)] = touched[idx(contact.second)] = 1;
      (std::abs(contact.normal_w.y()) > 0.999 ? vertical : others) += 1;
    }
    for (int a = 1; a < world.count(); ++a) {
      const BodyState& state = world.states()[idx(a)];
      CHECK(state.linear_momentum_w == Vec3::Zero());
      CHECK(state.angular_momentum_w == Vec3::Zero());
      if (world.bodies()[idx(a)].movable()) CHECK(touched[idx(a)] != 0);
      const Box box = box_of(world.bodies()[idx(a)], state);
      // [m] rounding; measured 1e-16
      CHECK(box.center_w.y() - reach(box, Vec3::UnitY()) > -1e-12);
      for (int b = 1; b < a; ++b) {
        const Box other = box_of(world.bodies()[idx(b)], world.states()[idx(b)]);
        const double distance = separation(box, other, exact).distance;
        CHECK(distance > -1e-10);
        // [m] exact, or farther apart than any tolerance.
        CHECK((distance < 1e-10 || distance > 4e-3));
      }
    }
  }
  // Enough of both kinds; measured 1448 and 206.
  CHECK(vertical > 500);
  CHECK(others > 100);
}

TEST_CASE("Balance and the complementarity problem agree on random piles",
          "[reference][geometric_stability]") {
  StaticEquilibrium equilibrium;
  int balanced = 0;
  int moving = 0;
  for (int seed = 1; seed <= 2 * kPiles; ++seed) {
    const World world = pile(seed);
    const ContactList contacts = touching(world);
    PileForces forces("augmented_lagrangian");
    REQUIRE(forces.solve(world, contacts));
    equilibrium.solve(world, {.contacts = contacts, .loads = {}, .held = {}});
    Islands islands;
    islands.build(world.bodies(), contacts);
    for (int i = 0; i < islands.count(); ++i) {
      double fastest = 0.0;
      for (const int b : islands.bodies(i)) {
        const BodyProperties& body = world.bodies()[idx(b)];
        const Acceleration& a = forces.accelerations()[idx(b)];
        fastest = std::max(fastest, fastest_of(body, a));
        // [m/s²] two ways to one answer; measured 3e-10
        CHECK(apart(body, a, equilibrium.motion()[idx(b)]) < 1e-7);
      }
      // [m/s²] rounding below, and nothing in between; measured 1e-10 and 0.4
      const bool rests = equilibrium.balanced()[idx(islands.bodies(i)[0])] != 0;
      CHECK((rests ? fastest < 1e-7 : fastest > 1e-4));
      (rests ? balanced : moving) += 1;
    }
  }
  CHECK(balanced > 100);  // 462
  CHECK(moving > 100);    // 260
}

TEST_CASE("Load-proof bodies do not accelerate, whatever is put on top",
          "[reference][geometric_stability]") {
  LoadProof load_proof;
  std::vector<char> members;
  int beyond_the_rule = 0;
  for (int seed = 1; seed <= kPiles / 2; ++seed) {
    const World world = pile(seed);
    const ContactList contacts = touching(world);
    load_proof.run(world, contacts, members);
    const std::vector<char> firm = called_stable(StabilityLevel::hull, world, contacts);
    Random random(static_cast<std::uint64_t>(seed));
    std::vector<std::vector<Wrench>> cases = single_loads(world);
    for (int k = 0; k < 10; ++k) cases.push_back(random_loads(world, random));
    PileForces forces("least_constraint");
    for (const std::vector<Wrench>& loads : cases) {
      REQUIRE(forces.solve(world, contacts, loads));
      for (int b = 0; b < world.count(); ++b)
        if (members[idx(b)] != 0 && world.bodies()[idx(b)].movable())
          // [m/s²] rounding under loads of 1e4 m/s²; measured 1e-7
          CHECK(fastest_of(world.bodies()[idx(b)], forces.accelerations()[idx(b)]) < 1e-6);
    }
    for (std::size_t b = 0; b < members.size(); ++b) {
      if (firm[b] != 0) CHECK(members[b] != 0);
      beyond_the_rule += members[b] != 0 && firm[b] == 0 ? 1 : 0;
    }
  }
  CHECK(beyond_the_rule > 20);  // 52
}

TEST_CASE(
    "Which boxes are stable does not depend on the order of bodies and contacts, in any of six "
    "ways",
    "[determinism][geometric_stability]") {
  for (int seed = 1; seed <= kPiles; ++seed) {
    const World world = pile(seed);
    const ContactList contacts = touching(world);
    Random random = Random(static_cast<std::uint64_t>(seed)).fork(1);
    for (int shuffled = 0; shuffled < 3; ++shuffled) {
      const World other = reordered(world, random);
      ContactList others = touching(other);
      shuffle(others, random);
      for (const StabilityLevel level : kStabilityLevels) {
        CAPTURE(seed, name_of(level));
        const std::vector<char> stable = called_stable(level, world, contacts);
        const std::vector<char> there = called_stable(level, other, others);
        for (int b = 0; b < world.count(); ++b)
          CHECK((stable[idx(b)] != 0) ==
                (there[idx(other.index_of(*other.find(world.name(b))))] != 0));
      }
    }
  }
}

TEST_CASE("No way to classify boxes calls one stable that moves", "[claims][geometric_stability]") {
  const FigureUnderTest figure("stable_confusion");
  CHECK(figure.number("boxes called stable that move, all six ways") == 0.0);
  CHECK(figure.number("boxes on which corners and hull differ") == 0.0);
  // At least three in ten, or the piles would be no test; measured 0.43 over 400 piles.
  CHECK(figure.number("share of them that the thesis's rule calls stable") > 0.3);
  const auto missed = [&](const char* way) {
    return figure.number(std::string("share of the resting boxes missed by ") + way);
  };
  // Each finds more than the one before. Measured over 400 piles 0.38, 0.33 and 0.14.
  CHECK(missed("hull and towers") < missed("corners"));
  CHECK(missed("hull, towers, balance") < missed("hull and towers"));
  CHECK(missed("hull, towers, balance") < missed("balance of islands"));
  CHECK(missed("every load on top") < missed("corners"));
  // [-] of g; nothing in between makes the verdict hang on a limit. Measured 2e-10 and 9e-4.
  CHECK(figure.number("largest acceleration of a box that rests, three solvers, over g") < 1e-8);
  CHECK(figure.number("least acceleration of a box that moves, three solvers, over g") > 1e-5);
}
