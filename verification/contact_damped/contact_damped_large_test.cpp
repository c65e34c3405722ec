/// \file
/// \brief Islands with more patches than the budget, and cards that slide on each other.

#include "contact_damped/helpers.hpp"
#include "support/test.hpp"

namespace {

// A wall of bricks without gaps, half a brick off from course to course, on a box that moves with it.
Scene moving_wall(int bricks, int courses, const Vec3& velocity_w) {
  const Vec3 size(1.0, 0.5, 0.5);
  Scene scene{.ground = SceneGround{0.0, 0.0}};
  scene.boxes.push_back({.name = "sled",
                         .size = Vec3(20.0, 0.5, 20.0),
                         .mass = 1e4,
                         .position_w = Vec3(0.0, 0.25, 0.0),
                         .friction = 0.6});
  for (int i = 0; i < courses; ++i)
    for (int k = 0; k < bricks; ++k)
      scene.boxes.push_back(
          {.name = "brick" + std::to_string(i) + "_" + std::to_string(k),
           .size = size,
           .position_w = Vec3(k - 0.5 * bricks + 0.5 * (i % 2), 0.75 + 0.5 * i, 0.0),
           .friction = 0.6});
  for (SceneBox& box : scene.boxes) box.velocity_w = velocity_w;
  return scene;
}

// The farthest way of a brick against the first box [m].
double farthest_from_first(const World& world, const Scene& scene) {
  const auto at = [&](std::size_t k) -> Vec3 {
    return world.body(scene.boxes[k].name).position_w() - scene.boxes[k].position_w;
  };
  double most = 0.0;
  for (std::size_t k = 1; k < scene.boxes.size(); ++k)
    most = std::max(most, (at(k) - at(0)).norm());
  return most;
}

// Cards on a slope, each with a friction and a velocity of its own. Returns the way of the lowest one in a second [m].
double way_of_lowest_card(int cards, double dt) {
  Random random(2);
  Scene scene{.gravity_w = 9.81 * Vec3(0.4, -0.9, 0.0), .ground = SceneGround{0.2, 0.0}};
  for (int k = 0; k < cards; ++k) {
    const double mass = random.uniform(1.0, 2.0), friction = random.uniform(0.05, 0.8);
    scene.boxes.push_back({.name = "card" + std::to_string(k),
                           .size = Vec3(8.0, 0.05, 8.0),
                           .mass = mass,
                           .position_w = Vec3(0.0, 0.05 * k + 0.025, 0.0),
                           .velocity_w = Vec3(random.uniform(-1.0, 1.0), 0.0, 0.0),
                           .friction = friction});
  }
  Simulation simulation(scene);
  simulation.run_for(1.0, dt);
  return simulation.body("card0").position_w().x();
}

// A load without friction that moves at 2 m/s over planks of 10 kg; each lies on two fixed posts, end to end with the next.
Scene loaded_planks(int planks, double load) {
  Scene scene;
  for (int k = 0; k <= planks; ++k)
    scene.boxes.push_back({.name = "post" + std::to_string(k),
                           .size = Vec3(0.3, 1.0, 1.0),
                           .fixed = true,
                           .position_w = Vec3(k, -0.5, 0.0),
                           .friction = 0.5});
  for (int k = 0; k < planks; ++k)
    scene.boxes.push_back({.name = "plank" + std::to_string(k),
                           .size = Vec3(1.0, 0.1, 1.0),
                           .mass = 10.0,
                           .position_w = Vec3(k + 0.5, 0.05, 0.0),
                           .friction = 0.5});
  scene.boxes.push_back({.name = "load",
                         .size = Vec3(1.2, 0.4, 0.6),
                         .mass = load,
                         .position_w = Vec3(0.8, 0.3, 0.1),
                         .velocity_w = Vec3(2.0, 0.0, 0.0),
                         .friction = 0.0});
  return scene;
}

}  // namespace

TEST_CASE("A wall stands on a sled that moves as on one that rests", "[unit][contact_damped]") {
  const Scene scene = moving_wall(14, 14, Vec3(2.0, 0.0, 0.0));
  Simulation simulation(scene);
  simulation.run_for(1.0);
  CHECK(farthest_from_first(simulation.world(), scene) < 1e-3);
  CHECK(simulation.step().deepest_overlap < 1e-3);
}

TEST_CASE("A wall without gaps stands where it is put", "[unit][contact_damped]") {
  const Scene scene = make_scene("wall", {"gap=0"});
  Simulation simulation(scene);
  simulation.run_for(1.0);
  CHECK(farthest_from_first(simulation.world(), scene) < 1e-6);
}

TEST_CASE("Cards that slide on each other lose no friction", "[unit][contact_damped]") {
  // Without an impact, swept impulses were discarded in each step, and cards of 22 and more slid off.
  for (const int cards : {20, 22, 26, 30}) {
    CAPTURE(cards);
    CHECK(std::abs(way_of_lowest_card(cards, 1.0 / 120.0)) < 0.01);
  }
}

TEST_CASE("Planks carry a load without friction, up to 500 times heavier, that slides along them",
          "[unit][contact_damped]") {
  // Solutions that were left unfinished braked it to 1.85 m/s, or let it fall through.
  for (const auto& [planks, load] : {std::pair{8, 2000.0}, {15, 5000.0}, {40, 5000.0}}) {
    CAPTURE(planks, load);
    Simulation simulation(loaded_planks(planks, load));
    simulation.run_for(3.0);
    const BodyView body = simulation.body("load");
    CHECK(std::abs(body.velocity_w().x() - 2.0) < 1e-4);
    CHECK(std::abs(body.position_w().x() - 6.8) < 1e-4);
    CHECK(std::abs(body.position_w().y() - 0.3) < 1e-5);
  }
}

TEST_CASE("Boxes that slide as one stay together, eighty of them too", "[exact][contact_damped]") {
  // Friction 0.1 with the ground stops them from 3 m/s; with 0.5 between them no layer may lag behind. Swept, walls of more
  // than twenty cubes sheared by decimetres. The direction in the last case is none of their edges.
  struct Case {
    int length, height, width;
    double dt;    // [s]
    double turn;  // [rad] of their velocity
  };
  for (const auto& [length, height, width, dt, turn] :
       {Case{6, 4, 1, kFrame, 0.0}, Case{10, 5, 1, kFrame, 0.0}, Case{20, 4, 1, kFrame, 0.0},
        Case{5, 3, 5, kFrame, 0.0}, Case{4, 4, 4, 1.0 / 240.0, 0.4}}) {
    CAPTURE(length, height, width, dt);
    constexpr double kSpeed = 3.0, kFriction = 0.5, kWithGround = 0.1;
    const Vec3 way_w(std::cos(turn), 0.0, std::sin(turn));
    Scene scene{.ground = SceneGround{kWithGround * kWithGround / kFriction, 0.0}};
    for (int k = 0; k < length * height * width; ++k)
      scene.boxes.push_back(
          {.name = "cube" + std::to_string(k),
           .position_w = Vec3(k % length, 0.5 + k / length % height, k / length / height),
           .velocity_w = kSpeed * way_w,
           .friction = kFriction});
    Simulation simulation(scene);
    CHECK(simulation.run_for(3.5, dt) == StepStatus::done);
    const double deceleration = kWithGround * scene.gravity_w.norm();
    // A step loses its friction before it goes on: half a step of the speed less than the closed form.
    const double way = kSpeed * kSpeed / (2.0 * deceleration) - 0.5 * kSpeed * dt;
    for (const SceneBox& box : scene.boxes) {
      const Vec3 moved_w = simulation.body(box.name).position_w() - box.position_w;
      CHECK((moved_w - way * way_w).norm() < 2e-3);
    }
  }
}

TEST_CASE("A train of boxes that friction brakes unequally has one speed",
          "[exact][contact_damped]") {
  // Friction grows from the last to the first, so that each box pushes the next one: the mean counts.
  for (const int count : {20, 30, 60}) {
    CAPTURE(count);
    constexpr double kSpeed = 5.0, kGround = 0.5, kSeconds = 0.5;
    Scene scene{.ground = SceneGround{kGround, 0.0}};
    double sum = 0.0;  // of the coefficients with the ground
    for (int k = 0; k < count; ++k) {
      const double with_ground = 0.05 + 0.3 * k / count;
      sum += with_ground;
      scene.boxes.push_back({.name = "box" + std::to_string(k),
                             .position_w = Vec3(k, 0.5, 0.0),
                             .velocity_w = Vec3(kSpeed, 0.0, 0.0),
                             .friction = with_ground * with_ground / kGround});
    }
    Simulation simulation(scene);
    simulation.run_for(kSeconds);
    const double expected = kSpeed - sum / count * scene.gravity_w.norm() * kSeconds;
    for (const SceneBox& box : scene.boxes)
      CHECK(std::abs(simulation.body(box.name).velocity_w().x() - expected) < 1e-3);
  }
}
