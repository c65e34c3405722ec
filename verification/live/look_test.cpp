/// \file
/// \brief Bodies as a look at a session shows them.
#include "tumble/analytic_lcp/touch.hpp"
#include "tumble/contact/islands.hpp"
#include "tumble/geometric_stability/stable_boxes.hpp"

#include "live/seen.hpp"
#include "session.hpp"
#include "support/test.hpp"
#include "support/touching.hpp"

namespace {

using namespace tumble::live;

bool same_pose(const Vec3& position_w, const Quat& orientation_wb, const BodyState& state) {
  return position_w == state.position_w && orientation_wb.coeffs() == state.orientation_wb.coeffs();
}

// Which bodies are stable, as the library's own search says.
std::vector<char> stable_in(const World& world, StableRule rule) {
  std::vector<MovingBody> moving = test::moving_bodies(world);
  ContactList contacts;
  gather_near(world, moving, test::all_pairs(world), {}, contacts);
  StableBoxes boxes(rule);
  const std::span<const char> found = boxes.find(world, moving, contacts);
  return {found.begin(), found.end()};
}

}  // namespace

TEST_CASE("A look has each body but the ground with its poses now and before the step",
          "[unit][live]") {
  Session session(kTable);
  const World& world = session.run().world();
  session.look(0);
  std::vector<SeenBody> seen = bodies_of(session);
  REQUIRE(seen.size() == 3);  // the late one is not there yet, and the ground is none
  for (std::size_t k = 0; k < seen.size(); ++k) {
    const std::size_t i = k + 1;
    CHECK(seen[k].id == number_of(world.ids()[i]));
    CHECK(seen[k].size == world.bodies()[i].size);
    CHECK(same_pose(seen[k].position_w, seen[k].orientation_wb, world.states()[i]));
    CHECK(same_pose(seen[k].before_w, seen[k].before_wb, world.states()[i]));
  }

  World before = world;
  for (int k = 0; k < 8; ++k) {
    INFO("step " << k);
    // A body that comes in before a step is there before it, with the pose that it comes in with.
    const bool enters = k == 4;
    if (!enters) before = world;
    step(session, 1);
    session.look(0);
    seen = bodies_of(session);
    REQUIRE(seen.size() == (k < 4 ? 3 : 4));
    for (std::size_t b = 0; b < seen.size(); ++b) {
      const std::size_t i = b + 1;
      CHECK(same_pose(seen[b].position_w, seen[b].orientation_wb, world.states()[i]));
      if (enters) continue;
      CHECK(same_pose(seen[b].before_w, seen[b].before_wb, before.states()[i]));
    }
    if (!enters) continue;
    CHECK(seen[3].before_w == Vec3(9.0, 5.0, 0.0));
    CHECK(seen[3].before_wb.coeffs() == Quat::Identity().coeffs());
    CHECK(seen[3].position_w.x() == near(9.0 + kDt, 1e-12));
  }

  // A body thrown since has not moved; the poses of others stay theirs when one goes.
  before = world;
  step(session, 1);
  session.throw_in(cube(Vec3(-5.0, 8.0, 0.0), Vec3(1.0, 2.0, 3.0)));
  session.take_away(id_of(session, "lower"));
  session.look(0);
  seen = bodies_of(session);
  REQUIRE(seen.size() == 4);
  CHECK(seen[1].id == number_of(id_of(session, "upper")));
  CHECK(same_pose(seen[1].before_w, seen[1].before_wb, before.states()[3]));
  CHECK(same_pose(seen[2].before_w, seen[2].before_wb, before.states()[4]));
  CHECK(seen[3].before_w == Vec3(-5.0, 8.0, 0.0));
  CHECK(seen[3].position_w == Vec3(-5.0, 8.0, 0.0));
}

TEST_CASE("What a body is can be seen in its bits", "[unit][live]") {
  Session session(kTable + "\n");
  const auto kinds = [&](unsigned wanted) {
    session.look(wanted);
    std::vector<unsigned> bits;
    for (const SeenBody& body : bodies_of(session)) bits.push_back(body.kind);
    return bits;
  };
  CHECK(kinds(0) == std::vector<unsigned>{kFixed, 0, 0});
  session.throw_in(cube(Vec3(-5.0, 8.0, 0.0)));
  CHECK(kinds(0) == std::vector<unsigned>{kFixed, 0, 0, kThrown});
  // Immovable bodies are not asked whether they are stable; of the others the lower one is.
  CHECK((kinds(kLookStable)[1] & kStable) != 0);
  CHECK((kinds(kLookStable)[3] & kStable) == 0);
  CHECK(kinds(0)[1] == 0);

  Session sleepy("set technique.sleeping=on\n" + kTable);
  step(sleepy, 192);
  sleepy.look(0);
  const std::vector<SeenBody> seen = bodies_of(sleepy);
  CHECK(seen[1].kind == kAsleep);
  CHECK(seen[2].kind == kAsleep);
  CHECK(number(sleepy, "asleep") >= 2.0);
}

TEST_CASE("Stable boxes of a look are those of the library's own search", "[unit][live]") {
  Session session("scene fig5_6");
  const World& world = session.run().world();
  for (int k = 0; k < 4; ++k) {
    INFO("after " << 3 * k << " steps");
    for (const auto& [wanted, rule] :
         {std::pair{+kLookStable, StableRule::hull},
          std::pair{+kLookBalanced, StableRule::equilibrium},
          std::pair{kLookStable | kLookBalanced, StableRule::equilibrium}}) {
      const std::vector<char> stable = stable_in(world, rule);
      session.look(wanted);
      const std::vector<SeenBody> seen = bodies_of(session);
      std::size_t b = 0;
      int count = 0;
      for (std::size_t i = 0; i < stable.size(); ++i) {
        if (world.bodies()[i].shape != Shape::box) continue;
        const bool bit = (seen.at(b++).kind & kStable) != 0;
        CHECK(bit == (stable[i] != 0));
        count += bit ? 1 : 0;
      }
      CHECK(b == seen.size());
      if (k > 0) continue;
      // At the start all are in balance; not all of them are held by their supports alone.
      CHECK(count > 10);
      CHECK((count < static_cast<int>(seen.size())) == (rule == StableRule::hull));
    }
    step(session, 3);
    // A box out of the middle: others are stable then.
    if (k == 1) session.take_away(world.ids()[world.ids().size() / 2]);
  }
  session.look(kEverything & ~(kLookStable | kLookBalanced));
  for (const SeenBody& body : bodies_of(session)) CHECK((body.kind & kStable) == 0);
}

TEST_CASE("Islands of a look are those of the contacts in the last step", "[unit][live]") {
  Session session(kTable);
  session.throw_in(cube(Vec3(20.0, 0.5, 0.0)));
  step(session, 10);
  session.look(kLookIslands);
  std::vector<SeenBody> seen = bodies_of(session);
  REQUIRE(seen.size() == 5);
  CHECK(seen[0].island == -1);  // the table
  CHECK(seen[1].island >= 0);
  CHECK(seen[1].island == seen[2].island);
  const std::set<int> islands = {seen[1].island, seen[3].island, seen[4].island};
  CHECK(islands == std::set<int>{0, 1, 2});
  session.look(kEverything & ~kLookIslands);
  for (const SeenBody& body : bodies_of(session)) CHECK(body.island == -1);
}

TEST_CASE("Overlap of a look is how deep each body is in others", "[unit][live]") {
  Session session("scene clump\nset scene.per_edge=2");
  step(session, 40);
  session.throw_in(cube(session.run().world().states()[1].position_w));  // into another one
  session.look(kLookOverlap);
  const World& world = session.run().world();
  OverlapMeter meter;
  const double deepest = meter.look(world.bodies(), world.states());
  const std::vector<SeenBody> seen = bodies_of(session);
  REQUIRE(seen.size() + 1 == meter.depths().size());
  CHECK(deepest > 0.1);
  for (std::size_t b = 0; b < seen.size(); ++b) CHECK(seen[b].overlap == meter.depths()[b + 1]);
  session.look(kEverything & ~kLookOverlap);
  for (const SeenBody& body : bodies_of(session)) CHECK(body.overlap == 0.0);
}

TEST_CASE("Pivots of figure 6.1 are the points on which each box of the column turns",
          "[unit][live][exterior_rotation]") {
  const std::string technique = GENERATE(as<std::string>(), "contact_damped", "analytic");
  INFO(technique);
  Session session("scene fig6_1\ntechnique " + technique + "\nset technique.pose=exponential");
  const World& world = session.run().world();
  session.look(kLookPivots);
  for (const SeenBody& body : bodies_of(session)) CHECK(body.pivot_w.array().isNaN().all());
  step(session, 12);
  session.look(kLookPivots);
  const std::vector<SeenBody> seen = bodies_of(session);
  std::vector<MovingBody> moving = test::moving_bodies(world);
  int with_pivot = 0;
  for (const SeenBody& body : seen) {
    INFO("body " << body.id);
    if ((body.kind & kFixed) != 0) {
      CHECK(body.pivot_w.array().isNaN().all());
      continue;
    }
    if (body.pivot_w.array().isNaN().any()) continue;
    ++with_pivot;
    // On the body's own surface, near enough for a step, and on that of another one.
    const auto outside = [&](const SeenBody& other) {
      const Vec3 b = other.orientation_wb.conjugate() * (body.pivot_w - other.position_w);
      return (b.cwiseAbs() - 0.5 * other.size).maxCoeff();  // [m] 0 on the surface
    };
    CHECK(std::abs(outside(body)) < 0.02);
    CHECK(std::ranges::any_of(seen, [&](const SeenBody& other) {
      return other.id != body.id && std::abs(outside(other)) < 0.02;
    }));
  }
  CHECK(with_pivot == static_cast<int>(std::ranges::count_if(
                          seen, [](const SeenBody& body) { return (body.kind & kFixed) == 0; })));
  session.look(kEverything & ~kLookPivots);
  for (const SeenBody& body : bodies_of(session)) CHECK(body.pivot_w.array().isNaN().all());
}
