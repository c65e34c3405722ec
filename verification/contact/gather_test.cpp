/// \file
/// \brief Tests of how contacts are gathered, and of loading and storing velocities.
#include "tumble/contact/gather.hpp"

#include "support/test.hpp"
#include "support/touching.hpp"

namespace {

// The ground, a box on it that sinks in by 1 cm, a box on that one, and a fixed box beside.
World small_world() {
  World world = ground_world(0.9, 0.1);
  const BodyProperties lower = box_properties(Vec3::Ones(), 2.0, 0.4, 0.3);
  const BodyProperties upper = box_properties(Vec3(0.5, 0.5, 0.5), 1.0, 0.1, 0.2);
  world.add(lower, Vec3(0, 0.49, 0), Quat::Identity(), Vec3(0, -2, 0));
  world.add(upper, Vec3(0, 1.24, 0), Quat::Identity(), Vec3(1, -3, 0));
  const BodyProperties wall = fixed_box_properties(Vec3::Ones());
  world.add(wall, Vec3(3, 0.4, 0));
  return world;
}

}  // namespace

TEST_CASE(
    "Contacts carry combined coefficients, approach speeds and the normal from the older body",
    "[unit][gather]") {
  const World world = small_world();
  std::vector<MovingBody> bodies = moving_bodies(world);
  ContactList contacts;
  const GatherReport report = gather_contacts(world, bodies, all_pairs(world), 0.001, {}, contacts);

  // Ground and wall are both immovable: their pair is not even tested.
  REQUIRE(contacts.size() == 2);
  CHECK(report.pair_tests == 5);
  CHECK(report.points == 8);
  CHECK(report.deepest_overlap == near(0.01).epsilon(1e-12));

  const Contact& low = contacts[0];
  CHECK(low.first == 0);
  CHECK(low.second == 1);
  CHECK(low.first_id < low.second_id);
  CHECK((low.normal_w - Vec3::UnitY()).norm() < 1e-15);
  CHECK(low.friction == near(0.6, 1e-12));  // √(0.9 · 0.4)
  CHECK(low.restitution == 0.3);
  CHECK(low.count == 4);
  const Contact& high = contacts[1];
  CHECK(high.friction == near(0.2, 1e-12));  // √(0.4 · 0.1)
  CHECK(high.restitution == 0.3);
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(low.points[i].approach_speed == near(-2.0, 1e-12));
    CHECK(high.points[i].approach_speed == near(-1.0, 1e-12));
    CHECK(low.points[i].distance == near(-0.01, 1e-12));
    CHECK(low.points[i].normal_impulse == 0.0);
  }
}

TEST_CASE("A ground that is younger than a box is the second body", "[unit][gather]") {
  World world;
  world.add(box_properties(Vec3::Ones(), 1.0), Vec3(0, 0.5, 0), Quat::Identity(), Vec3(0, -1, 0));
  world.add_ground();
  std::vector<MovingBody> bodies = moving_bodies(world);
  ContactList contacts;
  gather_contacts(world, bodies, all_pairs(world), 0.001, {}, contacts);
  REQUIRE(contacts.size() == 1);
  CHECK((contacts[0].normal_w + Vec3::UnitY()).norm() < 1e-15);
  CHECK(contacts[0].points[0].approach_speed == near(-1.0, 1e-12));
}

TEST_CASE("Points that touched before get their impulses back, by feature", "[unit][gather]") {
  World world = small_world();
  std::vector<MovingBody> bodies = moving_bodies(world);
  ContactList before;
  ContactList after;
  gather_contacts(world, bodies, all_pairs(world), 0.001, {}, before);
  double impulse = 1.0;
  for (Contact& c : before) {
    for (int i = 0; i < c.count; ++i) {
      ContactPoint& p = c.points[idx(i)];
      p.normal_impulse = impulse++;
      p.friction_impulse_w = Vec3(0.1, 7.0, 0.2);  // what lies along the normal is not friction
    }
  }

  // The upper box turns by a degree about y: all corners are still there.
  const BodyProperties& upper = world.bodies()[2];
  const Quat turned(Eigen::AngleAxisd(0.0175, Vec3::UnitY()));
  world.set_state(world.ids()[2], make_state(upper, Vec3(0, 1.24, 0), turned));
  gather_contacts(world, bodies, all_pairs(world), 0.001, before, after);
  CHECK(carry_over_impulses(before, after) == 8);
  REQUIRE(after.size() == 2);
  for (std::size_t c = 0; c < 2; ++c) {
    CHECK(after[c].axis == before[c].axis);
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t k = 0; k < 4; ++k) {
        const ContactPoint& now = after[c].points[i];
        const ContactPoint& then = before[c].points[k];
        if (now.feature != then.feature) continue;
        CHECK(now.normal_impulse == then.normal_impulse);
        CHECK((now.friction_impulse_w - Vec3(0.1, 0.0, 0.2)).norm() < 1e-14);
      }
    }
  }

  // A pair that is new, or a list that has nothing of it, gets nothing.
  ContactList other(before.begin() + 1, before.end());
  gather_contacts(world, bodies, all_pairs(world), 0.001, other, after);
  CHECK(carry_over_impulses(other, after) == 4);
  CHECK(after[0].points[0].normal_impulse == 0.0);
}

TEST_CASE("The remembered axis keeps a contact on its face", "[unit][gather]") {
  // A cube that sinks into another one along two faces by nearly the same depth: either face could
  // be taken, and the one of the step before is.
  World world;
  const BodyProperties cube = box_properties(Vec3::Ones(), 1.0);
  world.add(cube, Vec3::Zero());
  const BodyId second = world.add(cube, Vec3(0.9, 0.8, 0));
  std::vector<MovingBody> bodies = moving_bodies(world);
  ContactList before;
  ContactList after;
  gather_contacts(world, bodies, all_pairs(world), 0.001, {}, before);
  REQUIRE(before.size() == 1);
  CHECK(before[0].normal_w.x() == near(1.0, 1e-12));
  world.set_state(second, make_state(cube, Vec3(0.9, 0.902, 0)));
  gather_contacts(world, bodies, all_pairs(world), 0.001, before, after);
  CHECK(after[0].axis == before[0].axis);
  CHECK(after[0].normal_w.x() == near(1.0, 1e-12));
  gather_contacts(world, bodies, all_pairs(world), 0.001, {}, after);
  CHECK(after[0].normal_w.y() == near(1.0, 1e-12));
}

TEST_CASE("Bad candidates, bodies and margins are refused", "[unit][gather]") {
  const World world = small_world();
  std::vector<MovingBody> bodies = moving_bodies(world);
  ContactList out;
  const auto gather = [&](std::vector<IndexPair> pairs, double margin) {
    gather_contacts(world, bodies, pairs, margin, {}, out);
  };
  CHECK_THROWS_WITH(gather({{1, 0}}, 0.0), Contains("candidates"));
  CHECK_THROWS_WITH(gather({{1, 1}}, 0.0), Contains("candidates"));
  CHECK_THROWS_WITH(gather({{1, 4}}, 0.0), Contains("candidates"));
  CHECK_THROWS_WITH(gather({{-1, 2}}, 0.0), Contains("candidates"));
  CHECK_THROWS_WITH(gather({{1, 2}, {0, 1}}, 0.0), Contains("candidates"));
  CHECK_THROWS_WITH(gather({{0, 1}, {0, 1}}, 0.0), Contains("candidates"));
  CHECK_THROWS_WITH(gather({{0, 1}}, -1.0), Contains("margin"));
  CHECK_THROWS_WITH(gather({{0, 1}}, kInfinity), Contains("margin"));
  bodies.pop_back();
  CHECK_THROWS_WITH(gather({{0, 1}}, 0.0), Contains("bodies"));
}
