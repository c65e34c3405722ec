/// \file
/// \brief Scenes from outside that the analytic technique did not finish or did wrong.
#include "tumble/base/random.hpp"
#include "tumble/math/rotation.hpp"
#include "tumble/record/run_checks.hpp"
#include "tumble/scenes/simulation.hpp"

#include "support/catch.hpp"

namespace {

using namespace tumble;

// A cube at rest on a slope of tan(angle) = 1/2 with friction 0.49: it slides at (g/√5)(1 - 2·0.49/2) = 0.02 g/√5.
Scene slope(double friction) {
  Scene scene;
  scene.gravity_w = Vec3(0.0, -9.8, 0.0);
  const double angle = std::atan(0.5);
  const Quat turn = rotation_from_vector(Vec3(0.0, 0.0, -angle));
  SceneBox plane;
  plane.name = "slope";
  plane.size = Vec3(120.0, 0.5, 10.0);
  plane.fixed = true;
  plane.orientation_wb = turn;
  plane.friction = friction;
  SceneBox cube;
  cube.name = "cube";
  cube.orientation_wb = turn;
  cube.position_w = turn * Vec3(-50.0, 0.75, 0.0);
  cube.friction = friction;
  scene.boxes = {plane, cube};
  return scene;
}

Scene thrown_die(std::uint64_t seed) {
  Random chance(seed);
  Scene scene;
  scene.ground = SceneGround{0.5, 0.5};
  SceneBox die;
  die.name = "die";
  die.position_w = Vec3(0.0, 2.6, 0.0);
  die.orientation_wb = chance.orientation();
  die.angular_velocity_w = chance.in_cube(1.0);
  die.friction = 0.5;
  die.restitution = 0.5;
  scene.boxes = {die};
  return scene;
}

}  // namespace

TEST_CASE("A cube that slides slowly keeps its direction and has the speed of the closed form",
          "[exact][analytic_lcp]") {
  for (const double friction : {0.49, 0.4, 0.499}) {
    for (const double dt : {1.0 / 50.0, 1.0 / 60.0, 1.0 / 240.0}) {
      CAPTURE(friction, dt);
      Simulation simulation(slope(friction), "analytic");
      CHECK(simulation.run_for(2.0, dt) == StepStatus::done);
      const BodyView cube = simulation.body("cube");
      const double expected = 2.0 * (1.0 - 2.0 * friction) * 9.8 / std::sqrt(5.0);
      CHECK(std::abs(cube.velocity_w().norm() - expected) < 1e-4 * expected);
      CHECK(std::abs(cube.velocity_w().z()) < 1e-6);
      CHECK(cube.angular_velocity_w().norm() < 1e-6);
    }
  }
}

TEST_CASE("Dice come to rest under the analytic technique, none at the cap on events",
          "[unit][analytic_lcp]") {
  int unfinished = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    CAPTURE(seed);
    Simulation simulation(thrown_die(seed), "analytic");
    EnergyCheck energy;
    simulation.observe(energy);
    unfinished += simulation.run_for(3.0) == StepStatus::done ? 0 : 1;
    CHECK(energy.message().empty());
  }
  CHECK(unfinished == 0);
}

TEST_CASE("The rest of a step after many flights is one step of velocities, counted",
          "[unit][analytic_lcp]") {
  Scene scene;
  scene.ground = SceneGround{0.5, 0.5};
  for (int k = 0; k < 5; ++k) {
    SceneBox box;
    box.name = "box" + std::to_string(k);
    box.position_w = Vec3(0.2 * k, 0.7 + 1.2 * k, 0.1 * k);
    box.restitution = 0.5;
    scene.boxes.push_back(box);
  }
  Simulation simulation(scene, "analytic", {"event_cap=2"});
  EnergyCheck energy;
  simulation.observe(energy);
  std::int64_t fallbacks = 0;
  for (int k = 0; k < 120; ++k) {
    const StepReport report = simulation.step();
    CHECK(report.status == StepStatus::done);
    fallbacks += report.fallbacks;
  }
  CHECK(fallbacks > 0);
  CHECK(energy.message().empty());
  CHECK(std::abs(simulation.world().time() - 2.0) < 1e-9);
  CHECK(simulation.world().steps() == 120);
}
