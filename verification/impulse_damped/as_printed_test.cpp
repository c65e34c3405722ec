/// \file
/// \brief Damped integration as printed: laws that hold whichever errata are repaired, and
///        those of a single listing.
#include "tumble/impulse_damped/as_printed/damped_as_printed.hpp"
#include "tumble/impulse_damped/damped.hpp"

#include "support/runs.hpp"
#include "support/test.hpp"

namespace {

const char* const kSlips =
    "D2,D4,D5,D6,C1,C2,C3,C4,C5,C6,C7,C10,RK1,RK3,RC4,DM1,DM2,DM3,DM4,DM5,DM8,DM13,DM16,X1,X2,"
    "G1,G2,G3,G4,G5,G7,G8";

int add_cube(World& world, const Vec3& position_w, const Vec3& velocity_w = Vec3::Zero(),
             double restitution = 0.0, const Quat& turned = Quat::Identity()) {
  world.add(box_properties(Vec3::Ones(), 1.0, 0.5, restitution), position_w, turned, velocity_w);
  return world.count() - 1;
}

// A stack of two, a leaning cube, one in the air beside a wall.
World busy_world() {
  World world = ground_world();
  add_cube(world, Vec3(0.0, 0.5, 0.0));
  add_cube(world, Vec3(0.2, 1.5, 0.0), Vec3::Zero(), 0.9);
  add_cube(world, Vec3(1.3, 0.7, 0.1), Vec3(-1.0, 0.0, 0.0), 0.5,
           rotation_from_vector(Vec3(0.1, 0.2, 0.5)));
  const BodyProperties wall = fixed_box_properties(Vec3(1.0, 3.0, 3.0));
  world.add(wall, Vec3(-3.0, 1.5, 0.0));
  add_cube(world, Vec3(-1.9, 2.0, 0.0), Vec3(-2.0, 0.0, 0.0), 0.3);
  return world;
}

DampedAsPrinted with(const DampedErrata& repaired) {
  return DampedAsPrinted({.repaired = repaired, .push_cap = 50});
}

double reach_of(const World& world) {
  double most = 0.0;
  for (const BodyState& state : world.states()) most = std::max(most, state.position_w.norm());
  return most;
}

}  // namespace

TEST_CASE("There are 57 errata of damped integration", "[unit][impulse_damped]") {
  // 6 + 11 + 4 + 4 + 17 + 7 + 8
  CHECK(DampedErrata::known().size() == 57);
  CHECK(DampedErrata::known().front() == "D1");
  CHECK(DampedErrata::known().back() == "G8");
  CHECK_THROWS_AS(DampedErrata("T1"), std::invalid_argument);
}

TEST_CASE("Damped integration as printed ends every step with finite numbers, whatever is mended",
          "[unit][impulse_damped]") {
  std::vector<DampedErrata> sets{DampedErrata(), DampedErrata::all(), DampedErrata(kSlips)};
  for (const std::string& id : DampedErrata::known()) {
    sets.push_back(DampedErrata().with(id));
    sets.push_back(DampedErrata(kSlips).without(id));
  }
  for (const DampedErrata& set : sets) {
    INFO(set.text());
    World world = busy_world();
    DampedAsPrinted technique = with(set);
    for (int step = 0; step < 20; ++step) {
      const StepReport report = technique.step(world, kFrame);
      CHECK(report.status != StepStatus::not_finite);
      CHECK(std::isfinite(report.energy.total()));
    }
    CHECK(std::isfinite(reach_of(world)));
    CHECK(std::abs(world.time() - 20 * kFrame) < 1e-14);  // [s] rounding of 20 additions
  }
}

TEST_CASE("With all misprints mended the printed listings keep a cube at rest where it is",
          "[exact][impulse_damped]") {
  World world = ground_world();
  const int cube = add_cube(world, Vec3(0.0, 0.5, 0.0));
  DampedAsPrinted technique = with(DampedErrata(kSlips));
  double booked = 0.0;
  for (int step = 0; step < 120; ++step) booked += technique.step(world, kFrame).energy.total();
  const BodyState& state = world.states()[idx(cube)];
  CHECK((state.position_w - Vec3(0.0, 0.5, 0.0)).norm() < 1e-15);  // [m] measured 0
  CHECK(state.linear_momentum_w.norm() < 1e-15);                   // [kg m/s] measured 0
  CHECK(technique.geometrically_stable(world.ids()[idx(cube)]));
  // Impulses are booked in the middle of gravity's kick, so what rests costs nothing.
  CHECK(std::abs(booked) < 1e-12);  // [J] measured 0
}

TEST_CASE("With all misprints mended the printed listings follow the reading as meant",
          "[reference][impulse_damped]") {
  // Written apart from each other. Boxes are equal, so that one set of constants is right for all.
  std::vector<World> worlds(3);
  for (World& world : worlds) world.add_ground();
  for (int k = 0; k < 5; ++k) add_cube(worlds[0], Vec3(0.0, 0.5 + k, 0.0));
  add_cube(worlds[1], Vec3(0.0, 3.0, 0.0), Vec3(0.5, 0.0, 0.0), 0.5);
  add_cube(worlds[2], Vec3(0.0, 0.5, 0.0));
  add_cube(worlds[2], Vec3(0.2, 1.5, 0.1));
  add_cube(worlds[2], Vec3(-0.3, 4.0, 0.0), Vec3(0.0, -2.0, 0.0), 0.4,
           rotation_from_vector(Vec3(0.1, 0.3, 0.2)));
  for (World& world : worlds) {
    World other = world;
    DampedOptions no_chance;
    no_chance.noise.where = Randomness::off;
    Damped meant(no_chance);
    DampedAsPrinted printed = with(DampedErrata(kSlips));
    double most = 0.0;
    for (int step = 0; step < 180; ++step) {
      meant.step(world, kFrame);
      printed.step(other, kFrame);
      most = std::max(most, distance_of(world, other));
    }
    CHECK(most < 1e-11);  // [m] rounding that tumbling has enlarged; measured 3e-16
  }
}

TEST_CASE("What the printed listings know of a body goes with its id", "[unit][impulse_damped]") {
  World world = ground_world();
  add_cube(world, Vec3(-3.0, 0.5, 0.0));
  const int second = add_cube(world, Vec3(0.0, 0.5, 0.0));
  const BodyId first_id = world.ids()[1];
  const BodyId second_id = world.ids()[idx(second)];
  DampedAsPrinted technique = with(DampedErrata(kSlips));
  technique.step(world, kFrame);
  CHECK(technique.geometrically_stable(second_id));
  world.remove(first_id);
  add_cube(world, Vec3(0.0, 5.0, 0.0));
  technique.step(world, kFrame);
  CHECK(technique.geometrically_stable(second_id));
  CHECK_FALSE(technique.geometrically_stable(first_id));
  CHECK_FALSE(technique.geometrically_stable(world.ids()[2]));
}

TEST_CASE("Options of the printed listings that make no sense are refused",
          "[unit][impulse_damped]") {
  const auto refused = [](auto change) {
    DampedAsPrintedOptions options;
    change(options);
    CHECK_THROWS_AS(DampedAsPrinted(options), std::invalid_argument);
  };
  refused([](DampedAsPrintedOptions& o) { o.collision_passes = -1; });
  refused([](DampedAsPrintedOptions& o) { o.contact_passes = -1; });
  refused([](DampedAsPrintedOptions& o) { o.push_cap = 0; });
  refused([](DampedAsPrintedOptions& o) { o.index_base = 2; });
  refused([](DampedAsPrintedOptions& o) { o.loop_base = -1; });
  refused([](DampedAsPrintedOptions& o) { o.numbers.k1 = 1.5; });
  World world;
  DampedAsPrinted technique;
  CHECK_THROWS_AS(technique.step(world, 0.0), std::invalid_argument);
}

TEST_CASE("What the listings leave open is read in the milder way unless traps are taken",
          "[unit][impulse_damped]") {
  const auto places_after = [](const char* repaired, const char* traps) {
    World world = busy_world();
    const auto technique = make_technique(
        "damped",
        {"reading=as_printed", std::string("repaired=") + repaired, std::string("traps=") + traps});
    for (int k = 0; k < 30; ++k) technique->step(world, kFrame);
    double sum = 0.0;
    for (const BodyState& state : world.states()) sum += state.position_w.sum();
    return sum;
  };
  const double milder = places_after("none", "avoided");
  CHECK(milder ==
        places_after("D4,D5,D6,C3,C4,C6,C7,RK1,RC4,DM4,DM5,DM8,DM13,DM16,X1,G5,G7,G8", "taken"));
  CHECK(milder != places_after("none", "taken"));
  CHECK(places_after("all", "avoided") == places_after("all", "taken"));
  CHECK_THROWS_AS(make_technique("damped", {"traps=taken"}), std::invalid_argument);
}
