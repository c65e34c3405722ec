/// \file
/// \brief The default technique where a large island comes to rest: it does, and then a step costs a sweep.
#include "tumble/base/random.hpp"
#include "tumble/scenes/library.hpp"
#include "tumble/scenes/simulation.hpp"

#include "support/catch.hpp"

#include <algorithm>
#include <cmath>

namespace {

using namespace tumble;

// A floor of loose cubes of unlike masses, a sled with a bottle on it that slides over them, and a spinning cube that falls.
Scene crossed_floor(std::uint64_t seed) {
  constexpr double kEdge = 0.14;
  Random random(seed);
  Scene scene;
  scene.ground = SceneGround{0.6, 0.0};
  const auto add = [&scene](std::string name, const Vec3& size, double mass, double friction,
                            const Vec3& position_w, const Vec3& velocity_w) -> SceneBox& {
    SceneBox& box = scene.boxes.emplace_back();
    box.name = std::move(name);
    box.size = size;
    box.mass = mass;
    box.friction = friction;
    box.position_w = position_w;
    box.velocity_w = velocity_w;
    return box;
  };
  for (int i = 0; i < 14; ++i)
    for (int k = 0; k < 9; ++k)
      add("tile" + std::to_string(i) + "_" + std::to_string(k), Vec3::Constant(kEdge),
          0.4 * std::pow(10.0, random.uniform(-0.7, 0.7)), 0.4, kEdge * Vec3(i - 6.5, 0.5, k - 4),
          Vec3::Zero());
  const Vec3 slides(2.5, 0.0, 0.1);
  add("sled", Vec3(0.3, 0.1, 0.2), 12.0, 0.2, Vec3(-0.7, kEdge + 0.05, 0.02), slides);
  add("bottle", Vec3(0.07, 0.25, 0.07), 0.8, 0.5, Vec3(-0.7, kEdge + 0.225, 0.02), slides);
  SceneBox& falls = add("falls", Vec3::Constant(0.12), 1.5, 0.5,
                        Vec3(0.5, 0.9, random.uniform(-0.2, 0.2)), Vec3::Zero());
  falls.restitution = 0.8;
  for (double& spin : falls.angular_velocity_w) spin = random.uniform(-30.0, 30.0);
  return scene;
}

// The fastest body [m/s].
double fastest(const World& world) {
  double most = 0.0;
  for (int k = 0; k < world.count(); ++k)
    most = std::max(most, world.states()[static_cast<std::size_t>(k)].linear_momentum_w.norm() /
                              world.bodies()[static_cast<std::size_t>(k)].mass);
  return most;
}

}  // namespace

TEST_CASE("Loose tiles of unlike masses come to rest after a sled has crossed them",
          "[unit][contact_damped]") {
  // Without Newton steps these went on jittering at millimetres a second for as long as one looked.
  for (const std::uint64_t seed : {2U, 6U, 9U, 20U}) {
    CAPTURE(seed);
    Simulation simulation(crossed_floor(seed));
    simulation.run_for(4.0);
    double late = 0.0;  // [m/s]
    for (int k = 0; k < 60; ++k) {
      simulation.step();
      late = std::max(late, fastest(simulation.world()));
    }
    CHECK(late < 1e-5);
  }
}

TEST_CASE("A deck of cards stands whose cards are thinner than what gravity moves in a step",
          "[unit][contact_damped]") {
  // Two sweeps throw cards at rest about by half of their thickness: Newton steps have to follow all the same.
  Scene scene;
  scene.ground = SceneGround{};
  const Vec3 size(0.09, 0.0003, 0.06);
  for (int k = 0; k < 52; ++k)
    scene.boxes.push_back({.name = "card" + std::to_string(k),
                           .size = size,
                           .mass = 0.002,
                           .position_w = Vec3(0.0, (k + 0.5) * size.y(), 0.0)});
  Simulation simulation(scene);
  CHECK(simulation.run_for(3.0) == StepStatus::done);
  for (int k = 0; k < 52; ++k)
    CHECK((simulation.body("card" + std::to_string(k)).position_w() -
           scene.boxes[static_cast<std::size_t>(k)].position_w)
              .norm() < 1e-6);
}

TEST_CASE("A heap of a thousand cubes comes to rest, and a step of it costs a sweep then",
          "[.long][unit][contact_damped]") {
  const SceneRecipe& recipe = scene_recipe("clump");
  Parameters p = recipe.parameters();
  p.set("per_edge", "10");
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    CAPTURE(seed);
    Simulation simulation(recipe.build(p, Random(seed)));
    simulation.run_for(25.0);
    CHECK(fastest(simulation.world()) < 1e-5);
    int solved = 0;  // steps in which the direct solver was used
    for (int k = 0; k < 60; ++k)
      if (simulation.step().pivots > 0) ++solved;
    CHECK(solved <= 30);
  }
}
