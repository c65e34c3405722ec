/// \file
/// \brief The world as a container and as a value.
#include "tumble/dynamics/world.hpp"

#include "dynamics/random_bodies.hpp"
#include "support/test.hpp"

#include <cstring>

namespace {

BodyProperties cube() { return box_properties(Vec3::Ones(), 1.0); }

World three_cubes() {
  World world = ground_world();
  for (int i = 0; i < 3; ++i) world.add(cube(), Vec3(2.0 * i, 0.5, 0.0));
  return world;
}

}  // namespace

TEST_CASE("Over random additions and removals ids ascend, are never reused and find their bodies",
          "[unit][world]") {
  Random random(21);
  World world;
  std::vector<std::pair<BodyId, double>> expected;  // id and x of every body alive
  std::uint32_t largest = 0;
  int mistakes = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    if (expected.empty() || random.below(5) < 3) {
      const double x = random.unit();
      const BodyId id = world.add(cube(), Vec3(x, 0.0, 0.0));
      mistakes += !expected.empty() && number_of(id) <= largest ? 1 : 0;
      largest = number_of(id);
      expected.emplace_back(id, x);
    } else {
      const auto place =
          static_cast<std::ptrdiff_t>(random.below(static_cast<std::uint32_t>(expected.size())));
      world.remove((expected.begin() + place)->first);
      expected.erase(expected.begin() + place);
    }
    mistakes += std::ranges::is_sorted(world.ids()) ? 0 : 1;
    mistakes += world.count() == static_cast<int>(expected.size()) ? 0 : 1;
    for (const auto& alive : expected) {
      const int i = world.index_of(alive.first);
      mistakes += world.states()[idx(i)].position_w.x() == alive.second ? 0 : 1;
      mistakes += world.find(world.name(i)) == alive.first ? 0 : 1;
    }
  }
  CHECK(mistakes == 0);
}

TEST_CASE("Names are unique, and unnamed boxes are counted from 1", "[unit][world]") {
  World world = three_cubes();
  CHECK(world.name(0) == "ground");
  CHECK(world.name(1) == "box1");
  CHECK(world.name(3) == "box3");
  CHECK_THROWS_WITH(world.add(cube(), BodyState{}, "box2"), "tumble: the name \"box2\" is taken");
  world.add(cube(), BodyState{}, "box5");
  const BodyId next = world.add(cube(), BodyState{});
  CHECK(world.name(world.index_of(next)) == "box6");  // it is the fifth, but that name is taken
  CHECK(world.count() == 6);
}

TEST_CASE("A world of thirty thousand bodies is built in linear time and finds them by name",
          "[unit][world]") {
  World world;
  const BodyState state = make_state(cube(), Vec3::Zero());
  for (int k = 0; k < 30000; ++k)
    world.add(cube(), state);  // seconds, if each add looked at all names
  CHECK(world.index_of("box30000") == 29999);
  CHECK_FALSE(world.find("box30001").has_value());
  world.remove(*world.find("box100"));
  CHECK(world.index_of("box101") == 99);
  CHECK_FALSE(world.find("box100").has_value());
  CHECK(world.body(world.add(cube(), state, "box100")).name() == "box100");
}

TEST_CASE("Masses that are too far apart are refused with both names when the world is made",
          "[unit][world]") {
  World world = three_cubes();
  const BodyId light = world.add(box_properties(Vec3::Ones(), 1e-3), BodyState{}, "feather");
  const auto add = [&](double mass) {
    world.add(box_properties(Vec3::Ones(), mass), BodyState{}, "sun");
  };
  const int count = world.count();
  CHECK_THROWS_WITH(add(2e7),
                    "tumble: mass: \"sun\" (2e+07 kg) is more than 1e+10 times as heavy as "
                    "\"feather\" (0.001 kg): expected less; make the heavy one a fixed box, or the "
                    "light one heavier");
  CHECK(world.count() == count);
  world.remove(light);
  add(2e7);
  world.add(fixed_box_properties(Vec3::Ones()), BodyState{});
  CHECK_THROWS_WITH(world.add(box_properties(Vec3::Ones(), 1e-3), BodyState{}, "feather"),
                    Contains("\"sun\" (2e+07 kg) is more"));
  CHECK_FALSE(world.find("feather").has_value());
}

TEST_CASE("There is at most one ground, and it stays where it is", "[unit][world]") {
  World world;
  const BodyId ground = world.add_ground(0.25, 0.5);
  CHECK(world.bodies()[0].friction == 0.25);
  CHECK(world.bodies()[0].restitution == 0.5);
  CHECK_THROWS_AS(world.add_ground(), std::invalid_argument);
  CHECK_THROWS_AS(world.add(ground_properties(), BodyState{}), std::invalid_argument);
  CHECK_THROWS_AS(world.set_state(ground, BodyState{}), std::invalid_argument);
  world.remove(ground);
  CHECK(number_of(world.add_ground()) == 1);
}

TEST_CASE("A push changes P by j and L by r x j, and wakes", "[unit][world]") {
  World world = three_cubes();
  const BodyId id = world.ids()[2];
  world.sleep_states()[2] = SleepState{3.0, true};
  const Vec3 r(0.5, 0.25, -0.125);
  const Vec3 j(1.0, 2.0, 3.0);
  world.push(id, j, world.states()[2].position_w + r);
  CHECK(world.states()[2].linear_momentum_w == j);
  CHECK(world.states()[2].angular_momentum_w == r.cross(j));
  CHECK_FALSE(world.sleep_states()[2].asleep);
  CHECK(world.sleep_states()[2].quiet_time == 0.0);
  world.push(id, -j, world.states()[2].position_w + r);
  CHECK(world.states()[2].linear_momentum_w == Vec3::Zero());
  CHECK(world.states()[2].angular_momentum_w == Vec3::Zero());
}

TEST_CASE("New velocities and new states arrive, and wake", "[unit][world]") {
  World world = three_cubes();
  const BodyId id = world.ids()[1];
  world.sleep_states()[1].asleep = true;
  world.set_velocity(id, Vec3(1.0, 2.0, 3.0), Vec3(6.0, 0.0, 0.0));
  CHECK(world.states()[1].linear_momentum_w == Vec3(1.0, 2.0, 3.0));
  CHECK((world.states()[1].angular_momentum_w - Vec3::UnitX()).norm() < 1e-15);  // 6 · 1/6
  CHECK(world.states()[1].position_w == Vec3(0.0, 0.5, 0.0));
  CHECK_FALSE(world.sleep_states()[1].asleep);

  world.sleep_states()[1].asleep = true;
  world.set_state(id, make_state(cube(), Vec3(7.0, 8.0, 9.0)));
  CHECK(world.states()[1].position_w == Vec3(7.0, 8.0, 9.0));
  CHECK_FALSE(world.sleep_states()[1].asleep);
}

TEST_CASE("The world refuses bad bodies, states, ids and values, and is unchanged then",
          "[unit][world]") {
  World world = three_cubes();
  const BodyId fixed = world.add(fixed_box_properties(Vec3::Ones()), BodyState{}, "fixed");
  const BodyId box = world.ids()[1];
  const BodyId nobody{99};
  const std::uint64_t before = world.hash().value();
  const int count = world.count();

  BodyState bad;
  bad.position_w.x() = kNan;
  CHECK_THROWS_AS(world.add(cube(), bad), std::invalid_argument);
  CHECK_THROWS_AS(world.set_state(box, bad), std::invalid_argument);
  bad = BodyState{};
  bad.orientation_wb = Quat(0.5, 0.0, 0.0, 0.0);
  CHECK_THROWS_AS(world.add(cube(), bad), std::invalid_argument);
  bad = BodyState{};
  bad.linear_momentum_w.x() = 1.0;
  CHECK_THROWS_AS(world.set_state(fixed, bad), std::invalid_argument);
  BodyProperties contradictory = cube();
  contradictory.mass = 2.0;
  CHECK_THROWS_WITH(world.add(contradictory, BodyState{}),
                    "tumble: body.inverse_mass = 1: expected 1 / mass = 0.5");
  contradictory = cube();
  contradictory.inertia_b.y() = 2.0;
  CHECK_THROWS_AS(world.add(contradictory, BodyState{}), std::invalid_argument);
  contradictory = fixed_box_properties(Vec3::Ones());
  contradictory.inverse_inertia_b.z() = 1.0;
  CHECK_THROWS_AS(world.add(contradictory, BodyState{}), std::invalid_argument);
  contradictory = cube();
  contradictory.size.z() = 0.0;
  CHECK_THROWS_AS(world.add(contradictory, BodyState{}), std::invalid_argument);

  CHECK_THROWS_WITH(world.remove(nobody), "tumble: there is no body with id 99 in this world");
  CHECK_THROWS_AS(world.index_of(nobody), std::invalid_argument);
  CHECK_THROWS_AS(world.push(nobody, Vec3::Zero(), Vec3::Zero()), std::invalid_argument);
  CHECK_THROWS_WITH(world.push(fixed, Vec3::UnitX(), Vec3::Zero()),
                    "tumble: body \"fixed\" is immovable: expected a movable one");
  CHECK_THROWS_AS(world.push(box, Vec3(kNan, 0.0, 0.0), Vec3::Zero()), std::invalid_argument);
  CHECK_THROWS_AS(world.push(box, Vec3::UnitX(), Vec3(kNan, 0.0, 0.0)), std::invalid_argument);
  CHECK_THROWS_AS(world.set_velocity(fixed, Vec3::Zero(), Vec3::Zero()), std::invalid_argument);
  CHECK_THROWS_AS(world.set_velocity(box, Vec3(kNan, 0.0, 0.0), Vec3::Zero()),
                  std::invalid_argument);
  CHECK_THROWS_AS(world.add_ground(-1.0), std::invalid_argument);
  CHECK(world.hash().value() == before);
  CHECK(world.count() == count);
}

TEST_CASE("The hash changes with every single bit of every state", "[unit][determinism][world]") {
  const World world = three_cubes();
  const std::uint64_t hash = world.hash().value();
  int same = 0;
  const auto flip_each_bit = [&](auto&& number_in) {
    for (unsigned bit = 0; bit < 64; ++bit) {
      World changed = world;
      double& number = number_in(changed);
      std::uint64_t bits = 0;
      std::memcpy(&bits, &number, sizeof bits);
      bits ^= std::uint64_t{1} << bit;
      std::memcpy(&number, &bits, sizeof bits);
      same += changed.hash().value() == hash ? 1 : 0;
    }
  };
  for (std::size_t i = 0; i < world.states().size(); ++i) {
    for (int k = 0; k < 3; ++k) {
      flip_each_bit([=](World& w) -> double& { return w.states()[i].position_w[k]; });
      flip_each_bit([=](World& w) -> double& { return w.states()[i].linear_momentum_w[k]; });
      flip_each_bit([=](World& w) -> double& { return w.states()[i].angular_momentum_w[k]; });
    }
    for (int k = 0; k < 4; ++k)
      flip_each_bit([=](World& w) -> double& { return w.states()[i].orientation_wb.coeffs()[k]; });
    flip_each_bit([=](World& w) -> double& { return w.sleep_states()[i].quiet_time; });
    World asleep = world;
    asleep.sleep_states()[i].asleep = true;
    same += asleep.hash().value() == hash ? 1 : 0;
  }
  World stepped = world;
  stepped.finish_step(0.0);
  same += stepped.hash().value() == hash ? 1 : 0;
  World heavier = world;
  heavier.gravity_w.y() = -9.8;
  same += heavier.hash().value() == hash ? 1 : 0;
  CHECK(same == 0);
}

TEST_CASE("A copy of the world is a snapshot", "[unit][determinism][world]") {
  World world = three_cubes();
  const World snapshot = world;
  world.push(world.ids()[1], Vec3::UnitX(), Vec3::Zero());
  world.finish_step(0.5);
  world.remove(world.ids()[2]);
  CHECK(world.hash().value() != snapshot.hash().value());
  CHECK(snapshot.hash().value() == three_cubes().hash().value());
  world = snapshot;
  CHECK(world.hash().value() == snapshot.hash().value());
  CHECK(world.time() == 0.0);
  // What comes after is the same too: ids and default names are part of the value.
  World other = snapshot;
  const BodyId id = world.add(cube(), BodyState{});
  CHECK(other.add(cube(), BodyState{}) == id);
  CHECK(world.name(world.index_of(id)) == other.name(other.index_of(id)));
}
