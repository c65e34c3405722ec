/// \file
/// \brief Tests of falling asleep and waking.
#include "tumble/contact/sleeping.hpp"

#include "support/test.hpp"

namespace {

BodyState place(double x, double y) { return BodyState{.position_w = Vec3(x, y, 0.0)}; }

// A technique as small as can be: boxes fall, stop dead on what is under them, and slide freely.
// Its use of the rule is the one that the header describes.
struct Rig {
  World world;
  SleepingRule rule;
  std::vector<Contact> contacts;
  Islands islands;
  int tests = 0;           // pairs tested in the last step
  int gathers = 0;         // searches for contacts in the last step
  bool backwards = false;  // hand over the contacts in the opposite order

  BodyId box(double x, double y) {
    return world.add(box_properties(Vec3::Ones(), 2.0), place(x, y));
  }
  BodyId fixed(double x, double y) {
    return world.add(fixed_box_properties(Vec3::Ones()), place(x, y));
  }
  bool asleep(BodyId id) const { return world.sleep_states()[idx(world.index_of(id))].asleep; }
  int sleepers() const {
    int count = 0;
    for (const SleepState& rest : world.sleep_states()) count += rest.asleep ? 1 : 0;
    return count;
  }

  void gather() {
    contacts.clear();
    ++gathers;
    for (int a = 0; a < world.count(); ++a)
      for (int b = a + 1; b < world.count(); ++b) {
        const auto& bodies = world.bodies();
        if (!bodies[idx(a)].movable() && !bodies[idx(b)].movable()) continue;
        if (!rule.needs_test(a, b)) continue;
        ++tests;
        Separation found;
        if (bodies[idx(a)].shape == Shape::ground) {
          found.distance = world.states()[idx(b)].position_w.y() - 0.5;
          found.normal_w = Vec3::UnitY();
        } else {
          found = separation(box_of(bodies[idx(a)], world.states()[idx(a)]),
                             box_of(bodies[idx(b)], world.states()[idx(b)]), {.enough = 0.01});
        }
        if (found.distance > 0.01) continue;
        contacts.push_back(Contact{.first = a, .second = b, .normal_w = found.normal_w});
      }
    if (backwards) std::ranges::reverse(contacts);
  }

  SleepReport step(double dt = kFrame) {
    tests = gathers = 0;
    rule.wake_disturbed(world);
    do gather();
    while (rule.wake_touched(world, contacts) > 0);
    for (int b = 0; b < world.count(); ++b) {
      const BodyProperties& body = world.bodies()[idx(b)];
      if (!body.movable() || world.sleep_states()[idx(b)].asleep) continue;
      BodyState& state = world.states()[idx(b)];
      state.linear_momentum_w += body.mass * dt * world.gravity_w;
      for (const Contact& contact : contacts) {
        const double up = contact.first == b ? -contact.normal_w.y() : contact.normal_w.y();
        if ((contact.first == b || contact.second == b) && up > 0.9)
          state.linear_momentum_w.y() = std::max(0.0, state.linear_momentum_w.y());
      }
      state.position_w += dt * velocity(body, state);
    }
    islands.build(world.bodies(), contacts);
    const SleepReport report = rule.update(world, contacts, islands, dt);
    world.finish_step(dt);
    return report;
  }

  SleepReport steps(int count) {
    SleepReport sum;
    for (int k = 0; k < count; ++k) {
      const SleepReport report = step();
      sum.fell_asleep += report.fell_asleep;
      sum.woke += report.woke;
      sum.energy += report.energy;
    }
    return sum;
  }
};

// The ground, a stack of three at x = 0 and a box by itself at x = 5; all asleep.
struct Heaps : Rig {
  BodyId ground, low, middle, high, other;
  Heaps() {
    ground = world.add_ground();
    low = box(0.0, 0.5);
    middle = box(0.0, 1.5);
    high = box(0.0, 2.5);
    other = box(5.0, 0.5);
    steps(40);
  }
  bool stack_asleep() const { return asleep(low) && asleep(middle) && asleep(high); }
  bool stack_awake() const { return !asleep(low) && !asleep(middle) && !asleep(high); }
};

}  // namespace

TEST_CASE("A stack at rest falls asleep after half a second, not before", "[unit][sleeping]") {
  Rig rig;
  rig.world.add_ground();
  rig.box(0.0, 0.5);
  rig.box(0.0, 1.5);
  const SleepReport early = rig.steps(29);  // 29/60 s
  CHECK(early.fell_asleep == 0);
  const SleepReport late = rig.steps(2);  // 30/60 s may round to either side of 0.5 s
  CHECK(late.fell_asleep == 2);
  CHECK(rig.sleepers() == 2);
  CHECK(rig.steps(100).woke == 0);
  CHECK(rig.tests == 0);  // a sleeping world costs no pair test
}

TEST_CASE("A body at the top of its flight does not fall asleep", "[unit][sleeping]") {
  // Also if the time asked for is so short that it is slow for long enough.
  Rig rig;
  rig.rule = SleepingRule(SleepingOptions{.speed = 1.0, .time = 0.0});
  rig.world.add_ground();
  rig.box(0.0, 3.0);
  rig.box(0.0, 4.0);  // touches the first one: together they are an island of two, still in the air
  for (int b = 1; b <= 2; ++b) rig.world.states()[idx(b)].linear_momentum_w.y() = 2.0 * 1.0;
  CHECK(rig.steps(20).fell_asleep == 0);  // they turn round after 6 steps
}

TEST_CASE("An island sleeps as a whole or not at all", "[unit][sleeping]") {
  Rig rig;
  rig.world.add_ground();
  const BodyId still = rig.box(0.0, 0.5);
  const BodyId slider = rig.box(0.2, 1.5);
  // 0.05 m/s is above the limit of 0.01 sqrt(9.81 m/s2 * 1 m) = 0.0313 m/s.
  rig.world.set_velocity(slider, Vec3(0.05, 0.0, 0.0), Vec3::Zero());
  rig.steps(100);
  CHECK_FALSE(rig.asleep(still));
  CHECK(rig.world.sleep_states()[1].quiet_time > 1.0);
  CHECK(rig.world.sleep_states()[2].quiet_time == 0.0);
}

TEST_CASE("A slow body's energy is booked when it falls asleep", "[unit][sleeping]") {
  Rig rig;
  rig.world.add_ground();
  const BodyId slow = rig.box(0.0, 0.5);
  rig.world.set_velocity(slow, Vec3(0.02, 0.0, 0.0), Vec3(0.0, 0.01, 0.0));
  const double energy = kinetic_energy(rig.world.bodies()[1], rig.world.states()[1]);
  CHECK(energy == near(0.5 * 2.0 * 4e-4 + 0.5 * (2.0 / 6.0) * 1e-4, 1e-12));
  CHECK(rig.steps(40).energy == near(-energy).epsilon(1e-12));
  CHECK(rig.world.states()[1].linear_momentum_w.isZero(0.0));
  CHECK(rig.world.states()[1].angular_momentum_w.isZero(0.0));
}

TEST_CASE("A fast spin keeps a body awake", "[unit][sleeping]") {
  Rig rig;
  rig.world.add_ground();
  // Half a diagonal is 0.866 m: 0.04 rad/s moves a corner at up to 0.0346 m/s, above 0.0313 m/s.
  rig.world.set_velocity(rig.box(0.0, 0.5), Vec3::Zero(), Vec3(0.0, 0.04, 0.0));
  rig.world.set_velocity(rig.box(3.0, 0.5), Vec3::Zero(), Vec3(0.0, 0.03, 0.0));
  rig.steps(40);
  CHECK_FALSE(rig.world.sleep_states()[1].asleep);
  CHECK(rig.world.sleep_states()[2].asleep);
}

TEST_CASE("The sleeping speed scales with the root of gravity times size", "[unit][sleeping]") {
  // The same motion seen in other units: lengths times 4, gravity through 4: speeds stay.
  for (const double speed : {0.031, 0.032}) {
    Rig rig;
    rig.world.gravity_w /= 4.0;
    rig.world.add_ground();
    const BodyId id =
        rig.world.add(box_properties(Vec3(4.0, 1.0, 4.0) * 4.0, 7.0), place(0.0, 0.5));
    rig.world.set_velocity(id, Vec3(speed, 0.0, 0.0), Vec3::Zero());
    rig.steps(40);
    CHECK(rig.asleep(id) == (speed < 0.0313));
  }
}

TEST_CASE("Without gravity only what moves less than a ten-thousandth of its size sleeps",
          "[unit][sleeping]") {
  Rig rig;
  rig.world.gravity_w.setZero();
  const BodyId still = rig.box(0.0, 0.0);
  const BodyId drifting = rig.box(5.0, 0.0);
  rig.world.set_velocity(drifting, Vec3(0.007, 0.0, 0.0), Vec3::Zero());  // limit 0.006 m/s
  rig.steps(100);
  CHECK(rig.asleep(still));
  CHECK_FALSE(rig.asleep(drifting));
}

TEST_CASE("Taking a support away wakes what it carried, and nothing else", "[unit][sleeping]") {
  Heaps heaps;
  REQUIRE(heaps.sleepers() == 4);
  heaps.world.remove(heaps.low);
  const SleepReport report = heaps.step();
  CHECK(report.woke == 2);
  CHECK_FALSE(heaps.asleep(heaps.middle));
  CHECK_FALSE(heaps.asleep(heaps.high));
  CHECK(heaps.asleep(heaps.other));
  heaps.steps(60);
  const int middle = heaps.world.index_of(heaps.middle);
  CHECK(heaps.world.states()[idx(middle)].position_w.y() < 0.6);  // it does not float
  CHECK(heaps.sleepers() >= 1);
}

TEST_CASE("Taking the body of a group that named it away wakes the rest", "[unit][sleeping]") {
  // The smallest id of a group is its name: the group must be found without it.
  Heaps heaps;
  heaps.world.remove(heaps.low);
  heaps.world.remove(heaps.other);
  heaps.step();
  CHECK(heaps.sleepers() == 0);
}

TEST_CASE("Taking away or moving a fixed support wakes what stands on it", "[unit][sleeping]") {
  for (const bool remove : {true, false}) {
    Rig rig;
    const BodyId table = rig.fixed(0.0, 0.5);
    const BodyId far_table = rig.fixed(5.0, 0.5);
    const BodyId cup = rig.box(0.0, 1.5);
    const BodyId hat = rig.box(0.0, 2.5);  // touches the table only over the cup
    const BodyId far_cup = rig.box(5.0, 1.5);
    rig.steps(40);
    REQUIRE(rig.sleepers() == 3);
    if (remove) {
      rig.world.remove(table);
    } else {
      rig.world.set_state(table, place(0.0, -3.0));
    }
    CHECK(rig.step().woke == 2);
    CHECK_FALSE(rig.asleep(cup));
    CHECK_FALSE(rig.asleep(hat));
    CHECK(rig.asleep(far_cup));
    rig.steps(20);
    CHECK(rig.world.states()[idx(rig.world.index_of(cup))].position_w.y() < 1.2);
    rig.world.remove(far_table);
    rig.step();
    CHECK_FALSE(rig.asleep(far_cup));
  }
}

TEST_CASE("A lost support is noticed whatever its age and whichever fell asleep last",
          "[unit][sleeping]") {
  Rig rig;
  std::vector<BodyId> cups;
  std::vector<BodyId> tables;
  for (int k = 0; k < 4; ++k) cups.push_back(rig.box(5.0 * k, 1.5));
  for (int k = 0; k < 4; ++k) tables.push_back(rig.fixed(5.0 * k, 0.5));  // the newest bodies
  rig.steps(40);
  // Wake them one after the other: they fall asleep again in the order 2, 0, 3, 1.
  for (const int k : {2, 0, 3, 1}) {
    rig.world.set_velocity(cups[idx(k)], Vec3::Zero(), Vec3::Zero());
    rig.step();
  }
  rig.steps(40);
  for (const int k : {3, 0, 2, 1}) {
    REQUIRE(rig.asleep(cups[idx(k)]));
    rig.world.remove(tables[idx(k)]);
    CHECK(rig.step().woke == 1);
    CHECK_FALSE(rig.asleep(cups[idx(k)]));
  }
}

TEST_CASE("A push, a velocity, a new place or a momentum wakes the whole heap",
          "[unit][sleeping]") {
  for (int way = 0; way < 5; ++way) {
    Heaps heaps;
    REQUIRE(heaps.stack_asleep());
    const int high = heaps.world.index_of(heaps.high);
    if (way == 0) heaps.world.push(heaps.high, Vec3(0.1, 0.0, 0.0), Vec3(0.0, 2.5, 0.0));
    if (way == 1) heaps.world.set_velocity(heaps.high, Vec3(0.1, 0.0, 0.0), Vec3::Zero());
    if (way == 2) heaps.world.set_state(heaps.high, place(0.0, 7.0));
    if (way == 3) heaps.world.states()[idx(high)].linear_momentum_w.x() = 0.1;
    if (way == 4) heaps.world.states()[idx(high)].position_w.x() = 0.1;
    CHECK(heaps.step().woke == 3);
    CHECK(heaps.stack_awake());
    CHECK(heaps.asleep(heaps.other));
  }
}

TEST_CASE("A change of gravity wakes everything", "[unit][sleeping]") {
  Heaps heaps;
  heaps.world.gravity_w = Vec3(0.0, -1.62, 0.0);
  CHECK(heaps.step().woke == 4);
  heaps.steps(40);
  CHECK(heaps.sleepers() == 4);
}

TEST_CASE("A box that falls on a sleeping heap wakes it in the step in which it arrives",
          "[unit][sleeping]") {
  Heaps heaps;
  heaps.box(0.0, 3.6);
  bool touched = false;
  for (int k = 0; k < 30 && !touched; ++k) {
    CHECK(heaps.stack_asleep());
    heaps.step();
    touched = heaps.gathers == 2;  // the contacts within the heap were looked for again
  }
  REQUIRE(touched);
  CHECK(heaps.stack_awake());
  CHECK(heaps.contacts.size() == 4);  // ground, two joints, and the new one
  CHECK(heaps.asleep(heaps.other));
  heaps.steps(60);
  CHECK(heaps.sleepers() == 5);
}

TEST_CASE("A fixed body put against a sleeper wakes it, once", "[unit][sleeping]") {
  Heaps heaps;
  const BodyId wall = heaps.fixed(1.005, 0.5);  // within the contact margin of the stack's foot
  CHECK(heaps.step().woke == 3);
  heaps.steps(40);
  CHECK(heaps.stack_asleep());
  CHECK(heaps.steps(10).woke == 0);
  heaps.world.set_state(wall, place(3.995, 0.5));  // from here over to the other box
  CHECK(heaps.step().woke == 4);
  CHECK(heaps.sleepers() == 0);
}

TEST_CASE("A sleeper that the rule does not know is woken", "[unit][sleeping]") {
  Heaps heaps;
  heaps.rule = SleepingRule();
  heaps.step();
  CHECK(heaps.sleepers() == 0);
}

TEST_CASE("A copy of world and rule goes on in the same bits", "[determinism][sleeping]") {
  Heaps heaps;
  heaps.box(0.0, 4.0);
  heaps.steps(5);
  Heaps copy = heaps;
  Heaps backwards = heaps;
  backwards.backwards = true;
  for (int k = 0; k < 100; ++k) {
    const double dt = k % 3 == 0 ? kFrame : 0.5 * kFrame;
    if (k == 20) {
      heaps.world.remove(heaps.low);
      copy.world.remove(copy.low);
      backwards.world.remove(backwards.low);
    }
    heaps.step(dt);
    copy.step(dt);
    backwards.step(dt);
    CHECK(heaps.world.hash().value() == copy.world.hash().value());
    CHECK(heaps.world.hash().value() == backwards.world.hash().value());
  }
}

TEST_CASE("Bad input to the sleeping rule is refused", "[unit][sleeping]") {
  CHECK_THROWS_WITH(SleepingRule(SleepingOptions{.speed = -1.0}), Contains("speed"));
  CHECK_THROWS_WITH(SleepingRule(SleepingOptions{.speed_weightless = kNan}),
                    Contains("speed_weightless"));
  CHECK_THROWS_WITH(SleepingRule(SleepingOptions{.time = -0.1}), Contains("time"));
  Heaps heaps;
  CHECK_THROWS_WITH(heaps.rule.update(heaps.world, heaps.contacts, heaps.islands, 0.0),
                    Contains("dt"));
  heaps.box(9.0, 9.0);
  CHECK_THROWS_WITH(heaps.rule.wake_touched(heaps.world, heaps.contacts),
                    Contains("wake_disturbed"));
  CHECK_THROWS_AS(heaps.rule.update(heaps.world, heaps.contacts, heaps.islands, kFrame),
                  std::invalid_argument);
}
