/// \file
/// \brief The default technique where a large island comes to rest: it does, and then a step costs a sweep.

#include "contact_damped/helpers.hpp"
#include "support/test.hpp"

namespace {

// A floor of loose cubes of unlike masses, a sled with a bottle on it that slides over them, and a spinning cube that falls.
Scene crossed_floor(std::uint64_t seed) {
  constexpr double kEdge = 0.14;
  Random random(seed);
  Scene scene{.ground = SceneGround{0.6, 0.0}};
  for (int i = 0; i < 14; ++i)
    for (int k = 0; k < 9; ++k)
      scene.boxes.push_back({.name = "tile" + std::to_string(i) + "_" + std::to_string(k),
                             .size = Vec3::Constant(kEdge),
                             .mass = 0.4 * std::pow(10.0, random.uniform(-0.7, 0.7)),
                             .position_w = kEdge * Vec3(i - 6.5, 0.5, k - 4),
                             .friction = 0.4});
  const Vec3 slides_w(2.5, 0.0, 0.1);
  scene.boxes.push_back({.name = "sled",
                         .size = Vec3(0.3, 0.1, 0.2),
                         .mass = 12.0,
                         .position_w = Vec3(-0.7, kEdge + 0.05, 0.02),
                         .velocity_w = slides_w,
                         .friction = 0.2});
  scene.boxes.push_back({.name = "bottle",
                         .size = Vec3(0.07, 0.25, 0.07),
                         .mass = 0.8,
                         .position_w = Vec3(-0.7, kEdge + 0.225, 0.02),
                         .velocity_w = slides_w,
                         .friction = 0.5});
  SceneBox& falls = scene.boxes.emplace_back(SceneBox{.name = "falls",
                                                      .size = Vec3::Constant(0.12),
                                                      .mass = 1.5,
                                                      .position_w = Vec3(0.5, 0.9, 0.0),
                                                      .friction = 0.5,
                                                      .restitution = 0.8});
  falls.position_w.z() = random.uniform(-0.2, 0.2);
  for (double& spin : falls.angular_velocity_w) spin = random.uniform(-30.0, 30.0);
  return scene;
}

}  // namespace

TEST_CASE("Loose tiles of unlike masses come to rest after a sled has crossed them",
          "[unit][contact_damped]") {
  // Without Newton steps these went on jittering at millimetres a second for as long as one looked. Some creep by a hundredth of one.
  for (const std::uint64_t seed : {2U, 4U, 6U, 7U, 8U, 9U, 20U, 30U}) {
    CAPTURE(seed);
    Simulation simulation(crossed_floor(seed));
    simulation.run_for(4.0);
    double late = 0.0;  // [m/s]
    for (int k = 0; k < 60; ++k) {
      simulation.step();
      late = std::max(late, test::fastest_of(simulation.world()));
    }
    CHECK(late < 1e-4);
  }
}

TEST_CASE(
    "A deck of cards stands whose cards are thinner than what gravity moves in a step, under a "
    "weight as well",
    "[unit][contact_damped]") {
  // Two sweeps throw cards at rest about by half of their thickness: Newton steps have to follow all the same.
  struct Case {
    int cards;
    double thickness, weight;  // [m], [kg]
    double dt;                 // [s]
  };
  for (const auto& [cards, thickness, weight, dt] :
       {Case{52, 3e-4, 0.0, kFrame}, Case{20, 3e-4, 0.1, kFrame}, Case{30, 5e-4, 0.1, kFrame},
        Case{20, 2e-3, 1.0, 1.0 / 30.0}}) {
    CAPTURE(cards, thickness, weight, dt);
    Scene scene{.ground = SceneGround{0.4, 0.0}};
    for (int k = 0; k < cards; ++k)
      scene.boxes.push_back({.name = "card" + std::to_string(k),
                             .size = Vec3(0.09, thickness, 0.06),
                             .mass = 0.002,
                             .position_w = Vec3(0.0, (k + 0.5) * thickness, 0.0),
                             .friction = 0.4});
    if (weight > 0.0)
      scene.boxes.push_back({.name = "weight",
                             .size = Vec3::Constant(0.05),
                             .mass = weight,
                             .position_w = Vec3(0.01, cards * thickness + 0.025, 0.0),
                             .friction = 0.4});
    Simulation simulation(scene);
    CHECK(simulation.run_for(3.0, dt) == StepStatus::done);
    // A weight beside the middle lets cards creep by micrometres until all is solved.
    const double creep = weight > 0.0 ? 1e-5 : 1e-6;
    for (const SceneBox& box : scene.boxes)
      CHECK((simulation.body(box.name).position_w() - box.position_w).norm() < creep);
  }
}

TEST_CASE("Heaps of a thousand cubes come to rest, and cost fewer sweeps then",
          "[.long][unit][contact_damped]") {
  constexpr int kHeaps = 8, kSteps = 60;
  std::int64_t impulses = 0;
  for (std::uint64_t seed = 1; seed <= kHeaps; ++seed) {
    CAPTURE(seed);
    Simulation simulation(make_scene("clump", {"per_edge=10"}, seed));
    simulation.run_for(40.0);
    CHECK(test::fastest_of(simulation.world()) < 1e-4);
    for (int k = 0; k < kSteps; ++k) {
      const StepReport report = simulation.step();
      CHECK(report.pivots == 0);  // the direct solver was not used
      impulses += report.impulses;
    }
  }
  // A sweep is an impulse in each of 2100 patches. In motion a step makes 24 of them.
  CHECK(impulses < std::int64_t{kHeaps} * kSteps * 16 * 2100);
}
