/// \file
/// \brief The default technique in motion: bodies that do not move fast keep carrying, whatever moves among them.

#include "support/scenes.hpp"
#include "support/test.hpp"

namespace {

// A tower of crossed layers of three blocks; one block has a velocity along its length.
Scene tower(int layers, int layer, int block, double speed, double scale) {
  Scene scene{.ground = SceneGround{0.4, 0.0}};
  const Vec3 size = scale * Vec3(0.075, 0.015, 0.025);
  for (int l = 0; l < layers; ++l) {
    const bool along = l % 2 == 0;
    for (int k = 0; k < 3; ++k) {
      SceneBox box;
      box.name = "block" + std::to_string(l) + "_" + std::to_string(k);
      box.size = along ? size : Vec3(size.z(), size.y(), size.x());
      box.mass = 0.018 * scale * scale * scale;
      box.friction = 0.4;
      const double sideways = (k - 1) * size.z();
      box.position_w = Vec3(along ? 0.0 : sideways, (l + 0.5) * size.y(), along ? sideways : 0.0);
      if (l == layer && k == block)
        box.velocity_w = speed * (along ? Vec3::UnitX() : Vec3::UnitZ());
      scene.boxes.push_back(box);
    }
  }
  return scene;
}

// A floor of cubes with flush tops, and another cube that slides over them.
struct Floor {
  int along, across;
  double edge, mass;
  bool fixed;
};

constexpr double kSliderStart = 0.2;

Scene floor_with_slider(const Floor& floor, double speed) {
  Scene scene{.ground = SceneGround{0.5, 0.0}};
  for (int i = 0; i < floor.along; ++i) {
    for (int k = 0; k < floor.across; ++k) {
      SceneBox tile{.name = "tile" + std::to_string(i) + "_" + std::to_string(k),
                    .size = Vec3::Constant(floor.edge),
                    .fixed = floor.fixed,
                    .mass = floor.mass};
      tile.position_w =
          floor.edge * Vec3(i, 0.5, static_cast<double>(k) - 0.5 * (floor.across - 1));
      scene.boxes.push_back(tile);
    }
  }
  SceneBox slider{.name = "slider",
                  .size = Vec3(0.3, 0.3, 0.3),
                  .position_w = Vec3(kSliderStart, floor.edge + 0.15, 0.1 * floor.edge),
                  .velocity_w = Vec3(speed, 0.0, 0.0)};
  scene.boxes.push_back(slider);
  return scene;
}

}  // namespace

TEST_CASE("A cube that spins where it stands is stopped by friction, and stays so",
          "[unit][contact_damped]") {
  Scene scene{.ground = SceneGround{0.5, 0.0}};
  scene.boxes.push_back(
      SceneBox{.position_w = Vec3(0.0, 0.5, 0.0), .angular_velocity_w = Vec3(0.0, 0.1, 0.0)});
  Simulation simulation(scene, "contact_damped");
  for (int k = 0; k < 5; ++k) {
    simulation.step();
    CHECK(simulation.world().states()[1].angular_momentum_w.norm() < 1e-12);
  }
}

namespace {

// The deepest overlap [m] of cubes that fall together.
double deepest_in_clump(const char* per_edge, unsigned seed,
                        const std::vector<std::string>& settings) {
  Simulation simulation(make_scene("clump", {std::string("per_edge=") + per_edge}, seed),
                        "contact_damped", settings);
  double most = 0.0;
  for (int k = 0; k < 120; ++k) most = std::max(most, simulation.step().deepest_overlap);
  return most;
}

}  // namespace

TEST_CASE("Cubes that fall together overlap by less than 1.5 % of an edge on average",
          "[unit][contact_damped]") {
  // With a single point where edges cross it was 16 %, with the direct solver for all of them 4 %, and without the points that
  // impulses bring into reach 2 %.
  double sum = 0.0;
  for (const unsigned seed : {1U, 2U, 3U, 4U}) sum += deepest_in_clump("5", seed, {});
  CHECK(sum / 4.0 < 0.015);
}

TEST_CASE("A heap in motion costs no more than its budget", "[unit][contact_damped]") {
  // The most of what a step counts.
  const auto most = [&](const char* per_edge, int steps, std::int64_t StepReport::*counted,
                        const char* budget) {
    Simulation simulation(make_scene("clump", {std::string("per_edge=") + per_edge}),
                          "contact_damped", {budget, "sweeps=2"});
    std::int64_t count = 0;
    for (int k = 0; k < steps; ++k) count = std::max(count, simulation.step().*counted);
    return count;
  };
  // Two sweeps are made in any case, 24 at most, and two where an island is solved again; small islands beside the
  // heap have their own.
  CHECK(most("6", 90, &StepReport::impulses, "budget=1") <
        most("6", 90, &StepReport::impulses, "budget=50000") / 2);
  // Many small islands in the air are one heap to the budget.
  CHECK(most("10", 45, &StepReport::iterations, "budget=50000") <
        most("10", 45, &StepReport::iterations, "budget=1000000000") / 2);
}

TEST_CASE("Twenty sticks that tumble over each other cost no more than the budget of a step",
          "[unit][contact_damped]") {
  // Sticks turn far in a step, so that it has many parts, each with small islands that are solved to the end.
  const auto most = [](const char* budget) {
    Random random(1);
    Scene scene{.ground = SceneGround{}};
    for (int k = 0; k < 20; ++k) {
      // One by one: compilers evaluate arguments in different orders.
      const double x = random.uniform(-0.2, 0.2);
      const double z = random.uniform(-0.2, 0.2);
      const double turn = random.uniform(0.0, 3.0);
      scene.boxes.push_back({.name = "stick" + std::to_string(k),
                             .size = Vec3(1.0, 0.03, 0.03),
                             .mass = 0.3,
                             .position_w = Vec3(x, 0.3 + 0.3 * k, z),
                             .orientation_wb = rotation_from_vector(Vec3(0.0, turn, 0.1)),
                             .friction = 0.4});
    }
    Simulation simulation(scene, "contact_damped", {budget});
    std::int64_t count = 0;
    for (int k = 0; k < 60; ++k) count = std::max(count, simulation.step(1.0 / 30.0).iterations);
    return count;
  };
  CHECK(most("budget=50000") < most("budget=1000000000") / 4);
}

TEST_CASE("Steps in parts keep cubes that fall together from overlapping deep",
          "[unit][contact_damped]") {
  double one = 0.0, four = 0.0;
  for (const unsigned seed : {1U, 2U, 3U, 4U, 5U, 6U, 7U, 8U}) {
    one += deepest_in_clump("4", seed, {"parts=1"});
    four += deepest_in_clump("4", seed, {"parts=4"});
  }
  CHECK(four < one);
}

TEST_CASE("A tower that rides on a moving sled stands as one that rests",
          "[unit][contact_damped]") {
  for (const double speed : {0.0, 2.0, 8.0}) {
    Scene scene{.ground = SceneGround{0.0, 0.0}};
    scene.boxes.push_back(SceneBox{.size = Vec3(8.0, 0.5, 8.0),
                                   .mass = 50.0,
                                   .position_w = Vec3(0.0, 0.25, 0.0),
                                   .velocity_w = Vec3(speed, 0.0, 0.0)});
    for (int k = 0; k < 25; ++k)
      scene.boxes.push_back(
          SceneBox{.position_w = Vec3(0.0, 1.0 + k, 0.0), .velocity_w = Vec3(speed, 0.0, 0.0)});
    Simulation simulation(scene, "contact_damped");
    for (int k = 0; k < 180; ++k) simulation.step(1.0 / 60.0);
    INFO("speed " << speed);
    CHECK(simulation.world().states().back().position_w.y() > 25.0 - 1e-3);
  }
}

TEST_CASE("A body that turns by radians in a step keeps its energy", "[unit][contact_damped]") {
  Scene scene{.gravity_w = Vec3::Zero()};
  scene.boxes.push_back(SceneBox{.size = Vec3(1.2, 0.46, 1.8)});
  for (const double turn : {0.6, 2.0, 5.0, 30.0}) {
    for (const Vec3& axis : {Vec3(1.0, 0.1, 0.1), Vec3(1.0, 2.0, 3.0), Vec3(3.0, 1.0, 1.0)}) {
      scene.boxes[0].angular_velocity_w = turn * 60.0 * axis.normalized();
      Simulation simulation(scene, "contact_damped");
      const double start = energy_of(simulation.world()).total();
      double most = 0.0;
      for (int k = 0; k < 60; ++k) {
        simulation.step(1.0 / 60.0);
        most = std::max(most, std::abs(energy_of(simulation.world()).total() / start - 1.0));
      }
      INFO("turn " << turn << " about " << axis.transpose());
      CHECK(most < 0.005);
    }
  }
}

TEST_CASE("A box that tumbles on the ground does not sink into it", "[unit][contact_damped]") {
  // By up to 0.4 rad in a step. Turned about the corner on which they stand, 22 of them put another one deeper than 0.01.
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    Random chance(seed);
    Scene scene{.ground = SceneGround{1.0, 0.0}};
    SceneBox box{.friction = 1.0};
    for (Eigen::Index i = 0; i < 3; ++i) box.size[i] = chance.uniform(0.3, 3.0);
    box.orientation_wb = chance.orientation();
    box.position_w = Vec3(0.0, 0.5 * box.size.norm() + 0.2, 0.0);
    const double speed = chance.uniform(0.0, 3.0);
    box.velocity_w = speed * chance.direction();
    const double spin = chance.uniform(10.0, 25.0);
    box.angular_velocity_w = spin * chance.direction();
    scene.boxes = {box};
    Simulation simulation(scene, "contact_damped");
    double deepest = 0.0;
    for (int k = 0; k < 120; ++k)
      deepest = std::max(deepest, simulation.step(1.0 / 60.0).deepest_overlap);
    CAPTURE(seed);
    CHECK(deepest < 0.01 * box.size.minCoeff());
  }
}

TEST_CASE("A plate that turns by radians in a step does not go through the ground",
          "[unit][contact_damped]") {
  Scene scene{.ground = SceneGround{}};
  SceneBox plate{.size = Vec3(4.4, 2.3, 0.36), .position_w = Vec3(0.0, 3.0, 0.0)};
  plate.angular_velocity_w = Vec3(-2.5, -5.7, -17.5);  // 2 rad in a step
  scene.boxes = {plate};
  Simulation simulation(scene, "contact_damped");
  double deepest = 0.0;
  for (int k = 0; k < 40; ++k) deepest = std::max(deepest, simulation.step(0.1085).deepest_overlap);
  CHECK(deepest < 1.0);  // [m] of 4.4; 4.8 if steps are not divided
}

TEST_CASE("Boxes that move by many edges in a step meet where their ways cross",
          "[unit][contact_damped]") {
  struct Case {
    const char* name;
    SceneBox first, second;
  };
  const Vec3 cube = Vec3::Constant(0.2);
  const SceneBox plate{.size = Vec3(0.02, 4.0, 4.0), .fixed = true};
  const std::vector<Case> cases = {
      {"at right angles",
       {.size = cube, .position_w = Vec3(-5.0, 0.0, 0.0), .velocity_w = Vec3(50.0, 0.0, 0.0)},
       {.size = cube, .position_w = Vec3(0.0, -5.0, 0.0), .velocity_w = Vec3(0.0, 50.0, 0.0)}},
      {"head on, beside each other, one of them turning",
       {.size = cube,
        .position_w = Vec3(-20.0, 0.0, 0.0),
        .velocity_w = Vec3(60.0, 0.0, 0.0),
        .angular_velocity_w = Vec3(0.0, 3.0, 9.0)},
       {.size = cube, .position_w = Vec3(20.3, 0.03, 0.03), .velocity_w = Vec3(-60.0, 0.0, 0.0)}},
      {"a corner first, into a plate",
       plate,
       {.size = Vec3(0.3, 0.2, 0.1),
        .position_w = Vec3(-19.0, 1.0, -1.2),
        .orientation_wb = rotation_from_vector(Vec3(0.3, 0.5, 0.7)),
        .velocity_w = Vec3(60.0, 0.0, 0.0)}},
      {"a rod that spins, into a plate",
       plate,
       {.size = Vec3(0.05, 2.0, 0.05),
        .position_w = Vec3(-4.0, 0.0, 0.0),
        .velocity_w = Vec3(30.0, 0.0, 0.0),
        .angular_velocity_w = Vec3(0.0, 0.0, 40.0)}}};
  for (const Case& c : cases) {
    CAPTURE(c.name);
    Scene scene{.gravity_w = Vec3::Zero()};
    scene.boxes = {c.first, c.second};
    Simulation simulation(scene);
    const double start = energy_of(simulation.world()).total();
    CHECK(simulation.run_for(1.0) == StepStatus::done);
    CHECK(energy_of(simulation.world()).total() < 0.99 * start);  // they have met
    const Vec3 between_w =
        simulation.world().states()[1].position_w - simulation.world().states()[0].position_w;
    if (c.first.fixed) CHECK(between_w.x() < 0.0);  // and not gone through
  }
}

TEST_CASE("Cubes that are thrown at each other hardly get into each other",
          "[unit][contact_damped]") {
  // One in 170 was not seen coming, and got in by up to 6 cm of the 10 that it moves in a step. One of these still does: it
  // is turned by the impact, and the energy allows no more.
  Random random(1);
  int deep = 0;
  for (int k = 0; k < 1500; ++k) {
    CAPTURE(k);
    Scene scene{.gravity_w = Vec3::Zero()};
    const Vec3 from_w = 2.2 * random.direction();
    const Vec3 aim_w = random.in_cube(0.7) - from_w;
    scene.boxes = {{.name = "target", .orientation_wb = random.orientation()},
                   {.name = "thrown",
                    .position_w = from_w,
                    .orientation_wb = random.orientation(),
                    .velocity_w = 6.0 * aim_w.normalized(),
                    .angular_velocity_w = random.in_cube(1.0)}};
    Simulation simulation(scene);
    double deepest = 0.0;
    for (int n = 0; n < 30; ++n) {
      CHECK(simulation.step().status == StepStatus::done);
      const World& world = simulation.world();
      const auto box = [&](std::size_t body) {
        return box_of(world.bodies()[body], world.states()[body]);
      };
      deepest = std::max(deepest, -separation(box(0), box(1)).distance);
    }
    if (deepest > 0.02) ++deep;
  }
  CHECK(deep <= 1);
}

TEST_CASE("No layer of a tower sinks while one of its blocks is pulled out",
          "[unit][contact_damped]") {
  struct Pull {
    int layers, layer, block;
    double speed, scale;
  };
  for (const Pull& p :
       {Pull{8, 5, 1, 0.3, 1.0}, Pull{3, 0, 1, -0.64, 40.0}, Pull{13, 11, 2, 1.04, 1.0},
        Pull{18, 8, 1, 0.3, 1.0}, Pull{22, 0, 2, 0.34, 40.0}, Pull{9, 6, 2, -4.23, 1.0},
        Pull{22, 5, 0, 3.76, 1.0}, Pull{30, 10, 1, -0.65, 1.0}, Pull{16, 15, 0, 3.49, 40.0},
        Pull{29, 27, 2, -3.42, 40.0}}) {
    CAPTURE(p.layers, p.layer, p.block, p.speed, p.scale);
    const Scene scene = tower(p.layers, p.layer, p.block, p.speed, p.scale);
    Simulation simulation(scene);
    CHECK(simulation.run_for(0.1) == StepStatus::done);
    const std::string pulled = "block" + std::to_string(p.layer) + "_" + std::to_string(p.block);
    double sunk = 0.0;
    for (const SceneBox& box : scene.boxes) {
      if (box.name == pulled) continue;
      sunk = std::max(sunk, box.position_w.y() - simulation.body(box.name).position_w().y());
    }
    CHECK(sunk < 1e-3);
  }
}

TEST_CASE("A slider crosses the seams of flush tiles straight", "[unit][contact_damped]") {
  // Where sweeps end too early small tiles tilt, and the slider trips over them.
  for (const Floor& floor : {Floor{8, 1, 0.5, 50.0, true}, Floor{8, 1, 0.5, 50.0, false},
                             Floor{30, 1, 0.1, 5.0, false}, Floor{30, 3, 0.1, 5.0, false},
                             Floor{30, 5, 0.1, 5.0, false}, Floor{20, 15, 0.15, 1.0, false}}) {
    for (const double dt : {1.0 / 240.0, 1.0 / 100.0, 1.0 / 60.0, 1.0 / 50.0, 1.0 / 30.0}) {
      if (floor.across == 15 && dt != 1.0 / 60.0) continue;  // 300 tiles take their time
      for (const double speed : {0.7, 2.0, 3.5}) {
        CAPTURE(floor.fixed, floor.along, floor.across, dt, speed);
        Simulation simulation(floor_with_slider(floor, speed));
        CHECK(simulation.run_for(1.0, dt) == StepStatus::done);
        const BodyView slider = simulation.body("slider");
        // It brakes at the end of each step rather than over it, which costs v dt / 2.
        // A step longer than a tile rubs on tiles that it has left.
        const double left = speed * dt > floor.edge ? 0.01 : 0.0;
        const double stops = kSliderStart + speed * speed / (2.0 * 0.5 * 9.81) - 0.5 * speed * dt;
        CHECK(std::abs(slider.position_w().x() - stops) <
              1e-3 + 0.5 * 9.81 * dt * dt + left * stops);
        // [m] Tiles of 0.1 m sink by the slop, 1e-5 of their edge, and its hundredth for rounding.
        CHECK(std::abs(slider.position_w().y() - floor.edge - 0.15) < 1.01e-6);
        // Loose tiles give way, and are held to 1e-5 of g dt.
        const double sideways = floor.across > 1  ? std::max(2e-5, 0.01 * 9.81 * dt * dt)
                                : floor.along > 8 ? 5e-6
                                                  : 1e-6;
        CHECK(std::abs(slider.position_w().z() - 0.1 * floor.edge) < sideways);
        CHECK(std::abs(slider.orientation_wb().w()) > 1.0 - 1e-9);
      }
    }
  }
}

TEST_CASE("A slider crosses seams with gaps on twenty and more heavy tiles",
          "[unit][contact_damped]") {
  // Tiles of an island that is swept are pressed down by up to a ten-thousandth of their edge.
  struct Tiles {
    int count;
    double gap, mass, speed;  // [m], [kg] and [m/s] of the slider
  };
  for (const Tiles& t :
       {Tiles{20, 0.0, 1.0, 2.0}, Tiles{20, 1e-5, 10.0, 3.0}, Tiles{24, 1e-4, 10.0, 3.0},
        Tiles{24, 1e-5, 2.0, 4.0}, Tiles{24, 1e-4, 20.0, 1.5}, Tiles{2, 1e-4, 300.0, 1.0}}) {
    CAPTURE(t.count, t.gap, t.mass, t.speed);
    Scene scene;
    scene.ground.emplace().friction = 5.0;
    for (int k = 0; k < t.count; ++k)
      scene.boxes.push_back({.name = "tile" + std::to_string(k),
                             .size = Vec3(0.4, 0.3, 0.4),
                             .mass = 10.0,
                             .position_w = Vec3(k * (0.4 + t.gap), 0.15, 0.0),
                             .friction = 0.5});
    scene.boxes.push_back({.name = "slider",
                           .size = Vec3(0.3, 0.1, 0.2),
                           .mass = t.mass,
                           .position_w = Vec3(0.0, 0.35, 0.05),
                           .velocity_w = Vec3(t.speed, 0.0, 0.0),
                           .friction = 0.2});
    Simulation simulation(scene);
    CHECK(simulation.run_for(2.0, kFrame) == StepStatus::done);
    const BodyView slider = simulation.body("slider");
    const double stops = t.speed * t.speed / (2.0 * std::sqrt(0.1) * 9.81);
    // It brakes at the end of each step rather than over it.
    CHECK(std::abs(slider.position_w().x() - stops) < 0.01 * stops + 0.6 * t.speed * kFrame);
    CHECK(std::abs(slider.position_w().z() - 0.05) < 0.002);
    CHECK(std::abs(slider.position_w().y() - 0.35) < 1e-4);
  }
}

TEST_CASE(
    "A slider up to a hundred times heavier than the loose tiles under it crosses them straight",
    "[unit][contact_damped]") {
  for (const double mass : {1000.0, 100.0, 10.0})
    for (const double edge : {2.0, 1.0})
      for (const double dt : {kFrame, 1.0 / 240.0}) {
        CAPTURE(mass, edge, dt);
        constexpr double kSpeed = 3.0, kFriction = 0.3;
        Scene scene;
        scene.ground.emplace().friction = kFriction;
        for (int k = 0; k < 24; ++k)  // that touch: an island of more than twenty bodies
          scene.boxes.push_back({.name = "tile" + std::to_string(k),
                                 .size = Vec3(0.3, 0.1, 1.0),
                                 .mass = mass,
                                 .position_w = Vec3(0.3 * k, 0.05, 0.0),
                                 .friction = kFriction});
        scene.boxes.push_back({.name = "slider",
                               .size = Vec3::Constant(edge),
                               .mass = 1000.0,
                               .position_w = Vec3(0.0, 0.1 + 0.5 * edge, 0.0),
                               .velocity_w = Vec3(kSpeed, 0.0, 0.0),
                               .friction = kFriction});
        Simulation simulation(scene);
        CHECK(simulation.run_for(1.5, dt) == StepStatus::done);
        // It brakes at the end of each step rather than over it.
        const double stops = kSpeed * kSpeed / (2.0 * kFriction * 9.81) - 0.5 * kSpeed * dt;
        const Vec3 slider_w = simulation.body("slider").position_w();
        CHECK((slider_w - Vec3(stops, 0.1 + 0.5 * edge, 0.0)).norm() < 1e-3);
        double moved = 0.0;
        for (int k = 0; k < 24; ++k)
          moved = std::max(
              moved,
              std::abs(simulation.body("tile" + std::to_string(k)).position_w().x() - 0.3 * k));
        CHECK(moved < 1e-4);
      }
}

TEST_CASE("A box slides over a seam on a slope that is hardly too steep for its friction",
          "[unit][contact_damped]") {
  constexpr double kAngle = 44.0 / 180.0 * std::numbers::pi, kFriction = 0.95, kTime = 2.0;
  const double dt = 1.0 / 60.0;
  Scene scene{.gravity_w = 9.81 * Vec3(std::sin(kAngle), -std::cos(kAngle), 0.0)};
  for (int k = 0; k < 4; ++k) {
    SceneBox tile{.size = Vec3(0.5, 0.5, 2.0), .position_w = Vec3(0.5 * k, -0.25, 0.0)};
    tile.fixed = true;
    tile.friction = kFriction;
    scene.boxes.push_back(tile);
  }
  SceneBox slider{.size = Vec3::Constant(0.3), .position_w = Vec3(0.0, 0.15, 0.03)};
  slider.name = "slider";
  slider.friction = kFriction;
  scene.boxes.push_back(slider);
  Simulation simulation(scene);
  CHECK(simulation.run_for(kTime, dt) == StepStatus::done);
  const double acceleration = 9.81 * (std::sin(kAngle) - kFriction * std::cos(kAngle));
  const double way =
      0.5 * acceleration * kTime * (kTime + dt);  // in steps with the speed of their ends
  CHECK(simulation.body("slider").position_w().x() == near(way, 0.01 * way));
}

TEST_CASE("A thin rod that tumbles on the ground gains no energy", "[unit][contact_damped]") {
  for (const Vec3& size :
       {Vec3(2.0, 0.005, 0.005), Vec3(1.0, 0.01, 1.0), Vec3(0.15, 0.007, 0.007)}) {
    for (const double dt : {1.0 / 60.0, 1.0 / 120.0, 1.0 / 240.0}) {
      CAPTURE(size.transpose(), dt);
      Scene scene{.ground = SceneGround{0.4, 0.2}};
      SceneBox rod;
      rod.size = size;
      rod.position_w = Vec3(0.0, 1.2 * size.x(), 0.0);
      rod.orientation_wb = rotation_from_vector(Vec3(0.0, 0.26, 0.35));
      rod.angular_velocity_w = Vec3(0.0, 0.0, 0.3 / dt);
      rod.friction = 0.4;
      rod.restitution = 0.2;
      scene.boxes = {rod};
      Simulation simulation(scene);
      const double start = energy_of(simulation.world()).total();
      double most = start;
      for (double t = 0.0; t < 3.0; t += dt) {
        CHECK(simulation.step(dt).status == StepStatus::done);
        most = std::max(most, energy_of(simulation.world()).total());
      }
      CHECK(most < 1.001 * start);
    }
  }
}

TEST_CASE("A rod that spins about an axis across it and lands keeps its energy out of its spin",
          "[unit][contact_damped]") {
  Scene scene{.ground = SceneGround{}};
  SceneBox rod{.size = Vec3(0.02, 2.0, 0.02), .position_w = Vec3(0.0, 2.0, 0.0)};
  rod.orientation_wb = rotation_from_vector(Vec3(0.0, 0.0, 1.4));
  rod.angular_velocity_w = Vec3(30.0, 0.0, 0.0);
  scene.boxes = {rod};
  Simulation simulation(scene);
  const double start = energy_of(simulation.world()).total();
  double most = start;
  for (int k = 0; k < 240; ++k) {
    CHECK(simulation.step(1.0 / 60.0).status == StepStatus::done);
    most = std::max(most, energy_of(simulation.world()).total());
  }
  CHECK(most < 1.001 * start);
  CHECK(energy_of(simulation.world()).kinetic < 1e-6);  // it has come to rest
}
