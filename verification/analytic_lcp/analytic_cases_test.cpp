/// \file
/// \brief Scenes from outside that the analytic technique did not finish or did wrong.
#include "tumble/record/run_checks.hpp"

#include "support/test.hpp"

namespace {

// A cube at rest on a slope of tan(angle) = 1/2 with friction 0.49: it slides at (g/√5)(1 - 2·0.49/2) = 0.02 g/√5.
Scene slope(double friction) {
  Scene scene{.gravity_w = Vec3(0.0, -9.8, 0.0)};
  const double angle = std::atan(0.5);
  const Quat turn = rotation_from_vector(Vec3(0.0, 0.0, -angle));
  SceneBox plane{.name = "slope",
                 .size = Vec3(120.0, 0.5, 10.0),
                 .fixed = true,
                 .orientation_wb = turn,
                 .friction = friction};
  SceneBox cube{.name = "cube",
                .position_w = turn * Vec3(-50.0, 0.75, 0.0),
                .orientation_wb = turn,
                .friction = friction};
  scene.boxes = {plane, cube};
  return scene;
}

// --- flush neighbours --------------------------------------------------------------------------------

SceneBox tile(const Vec3& position_w) {
  SceneBox box;
  box.size.setConstant(0.5);
  box.mass = 50.0;
  box.position_w = position_w;
  box.friction = 0.5;
  return box;
}

// A cube on tiles that begins to slide at 3.5 m/s along the first axis.
Scene slider_on(std::vector<SceneBox> tiles, double turned) {
  Scene scene{.gravity_w = Vec3(0.0, -9.81, 0.0), .boxes = std::move(tiles)};
  SceneBox slider{.name = "slider"};
  slider.size.setConstant(0.3);
  slider.position_w = Vec3(0.0, 0.65, 0.05);
  slider.velocity_w = Vec3(3.5, 0.0, 0.0);
  slider.orientation_wb = Quat(Eigen::AngleAxisd(turned, Vec3::UnitY()));
  slider.friction = 0.5;
  scene.boxes.push_back(slider);
  return scene;
}

// Heavy cubes that stand side by side on the ground.
Scene row() {
  std::vector<SceneBox> tiles;
  for (int k = 0; k < 4; ++k) tiles.push_back(tile(Vec3(0.5 * k, 0.25, 0.0)));
  Scene scene = slider_on(std::move(tiles), 0.0);
  scene.ground = SceneGround{0.5, 0.0};
  return scene;
}

// Fixed tiles whose seams cross below the slider, which is turned about the vertical.
Scene crossed() {
  std::vector<SceneBox> tiles;
  for (int k = 0; k < 4; ++k)
    for (const double side : {-0.2, 0.3}) {
      tiles.push_back(tile(Vec3(0.5 * k, 0.25, side)));
      tiles.back().fixed = true;
    }
  return slider_on(std::move(tiles), 0.3);
}

// The same turned about an axis aslant, with gravity: nothing lies along an axis of the world.
Scene tilted(Scene scene) {
  const Quat turn_w(Eigen::AngleAxisd(0.4, Vec3(1.0, 2.0, 3.0).normalized()));
  scene.gravity_w = turn_w * scene.gravity_w;
  for (SceneBox& box : scene.boxes) {
    box.position_w = turn_w * box.position_w;
    box.velocity_w = turn_w * box.velocity_w;
    box.orientation_wb = turn_w * box.orientation_wb;
  }
  return scene;
}

struct Slide {
  double way = 0.0;     // [m] of the slider until it rests
  double turned = 0.0;  // [rad]
};

Slide slide(const Scene& scene, const char* technique) {
  Simulation simulation(scene, technique);
  simulation.update_boxes();
  const BodyState start = simulation.world().states().back();  // the slider
  for (int k = 0; k < 48; ++k) REQUIRE(simulation.step(kFrame).status == StepStatus::done);
  const BodyState& end = simulation.world().states().back();
  return {(end.position_w - start.position_w).norm(),
          start.orientation_wb.angularDistance(end.orientation_wb)};
}

}  // namespace

TEST_CASE("A cube that slides slowly keeps its direction and has the speed of the closed form",
          "[exact][analytic_lcp]") {
  for (const double friction : {0.49, 0.4, 0.499}) {
    for (const double dt : {1.0 / 50.0, 1.0 / 60.0, 1.0 / 240.0}) {
      CAPTURE(friction, dt);
      Simulation simulation(slope(friction), "analytic");
      const Vec3 start_w = simulation.body("cube").position_w();
      CHECK(simulation.run_for(2.0, dt) == StepStatus::done);
      const BodyView cube = simulation.body("cube");
      const double expected = 2.0 * (1.0 - 2.0 * friction) * 9.8 / std::sqrt(5.0);
      // After 2 s the way down the slope in m is the speed in m/s; sideways, x, it is shorter.
      CHECK(std::abs((cube.position_w() - start_w).norm() - expected) < 1e-4 * expected);
      CHECK(std::abs(cube.velocity_w().norm() - expected) < 1e-4 * expected);
      CHECK(std::abs(cube.velocity_w().z()) < 1e-6);
      CHECK(cube.angular_velocity_w().norm() < 1e-6);
    }
  }
}

TEST_CASE("A slow slide is as long as the closed form says, up to the way of half a step",
          "[exact][analytic_lcp]") {
  for (const std::string_view technique :
       {"contact_damped", "time_stepping", "impulse", "faure", "optimised"}) {
    CAPTURE(technique);
    Simulation simulation(slope(0.49), technique);
    const Vec3 start_w = simulation.body("cube").position_w();
    CHECK(simulation.run_for(2.0) == StepStatus::done);
    const double expected = 2.0 * (1.0 - 2.0 * 0.49) * 9.8 / std::sqrt(5.0);
    const double way = (simulation.body("cube").position_w() - start_w).norm();
    CHECK(std::abs(way - expected) < 0.51 * expected * kFrame);
  }
}

TEST_CASE("The rest of a step after many flights is one step of velocities, counted",
          "[unit][analytic_lcp]") {
  Scene scene{.ground = SceneGround{0.5, 0.5}};
  for (int k = 0; k < 5; ++k) {
    SceneBox box{.name = "box" + std::to_string(k),
                 .position_w = Vec3(0.2 * k, 0.7 + 1.2 * k, 0.1 * k),
                 .restitution = 0.5};
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

TEST_CASE("A box slides over flush neighbours as over one", "[unit][analytic_lcp]") {
  const double way = 3.5 * 3.5 / (2.0 * 0.5 * 9.81);  // [m]
  for (const Scene& scene : {row(), crossed(), tilted(crossed())}) {
    const Slide exact = slide(scene, "analytic");
    CHECK(std::abs(exact.way - way) < 1e-3);
    CHECK(exact.turned < 1e-3);
    const Slide steps = slide(scene, "time_stepping");
    // Half a step of the start, and eight directions of friction.
    CHECK(std::abs(steps.way - way) < 0.5 * 3.5 * kFrame + 0.01);
    CHECK(steps.turned < 1e-3);
  }
}

TEST_CASE("A box that passes a tile in a step is held by those that it comes to",
          "[exact][analytic_lcp]") {
  // A cube on tiles a quarter wider than itself, on one of them wholly at the start: 5 m at 7 m/s.
  Scene scene;
  for (int k = 0; k < 40; ++k) {
    scene.boxes.push_back({.size = Vec3(0.25, 0.1, 0.5),
                           .fixed = true,
                           .position_w = Vec3(0.25 * k, -0.05, 0.0),
                           .friction = 0.5});
  }
  SceneBox cube;
  cube.size.setConstant(0.2);
  cube.position_w = Vec3(1.0, 0.1, 0.0);
  cube.velocity_w = Vec3(std::sqrt(2.0 * 0.5 * 9.81 * 5.0), 0.0, 0.0);
  cube.friction = 0.5;
  scene.boxes.push_back(cube);
  Simulation simulation(scene, "analytic");
  CHECK(simulation.run_for(1.5, 0.0223) == StepStatus::done);
  CHECK((simulation.world().states().back().position_w - Vec3(6.0, 0.1, 0.0)).norm() < 1e-6);
}

namespace {

// A fixed plate of 2 cm, and a toy brick that falls on it at 44 m/s.
Scene brick_over_plate() {
  Scene scene{.gravity_w = Vec3(0.0, -9.81, 0.0)};
  SceneBox plate{.size = Vec3(1.0, 0.02, 1.0),
                 .fixed = true,
                 .position_w = Vec3(0.0, -0.01, 0.0),
                 .friction = 0.5};
  SceneBox brick{.size = Vec3(0.032, 0.0096, 0.016),
                 .mass = 0.0025,
                 .velocity_w = Vec3(0.0, -44.0, 0.0),
                 .friction = 0.5};
  scene.boxes = {plate, brick};
  return scene;
}

}  // namespace

TEST_CASE("A brick that hits a thin plate with a corner at 44 m/s does not pass it",
          "[unit][analytic][analytic_lcp]") {
  Scene scene = brick_over_plate();
  SceneBox& brick = scene.boxes[1];
  for (const double height : {0.3, 0.4, 0.5, 0.6, 0.7}) {
    brick.position_w = Vec3(0.0, height, 0.0);
    brick.orientation_wb = Quat(Eigen::AngleAxisd(0.5 + height, Vec3(1.0, 2.0, 3.0).normalized()));
    brick.angular_velocity_w = Vec3(height > 0.45 ? 300.0 : 0.0, 0.0, 100.0);
    Simulation simulation(scene, "analytic");
    simulation.update_boxes();
    for (int k = 0; k < 4; ++k) simulation.step(kFrame);
    CAPTURE(height);
    CHECK(simulation.world().states()[1].position_w.y() > 0.0);
  }
}

// Its corners hit one after the other: it slides off, as it would with any step. A limit that analytic.hpp states.
TEST_CASE("The end of a rod that turns does not pass a thin peg beside its middle",
          "[unit][analytic_lcp]") {
  Scene scene{.gravity_w = Vec3::Zero()};
  SceneBox peg{.name = "peg",
               .size = Vec3(0.05, 2.0, 0.05),
               .fixed = true,
               .position_w = Vec3(0.9, 0.0, -0.3)};
  SceneBox rod{.name = "rod", .size = Vec3(2.0, 0.05, 0.05)};
  rod.angular_velocity_w = Vec3(0.0, 25.0, 0.0);  // 0.4 rad a step: eight times the peg
  scene.boxes = {peg, rod};
  Simulation simulation(scene, "analytic");
  for (int k = 0; k < 6; ++k) simulation.step(kFrame);
  CHECK(simulation.body("rod").angular_velocity_w().y() < 20.0);  // [rad/s] measured 6.2
}

TEST_CASE("A brick that falls on a plate leaves it sideways as fast with any step",
          "[unit][analytic][analytic_lcp]") {
  Scene scene = brick_over_plate();
  scene.boxes[1].position_w.y() = 0.67;
  scene.boxes[1].orientation_wb = rotation_from_vector(Vec3(0.08, 0.39, 0.49));
  for (const int parts : {1, 4, 16}) {
    Simulation simulation(scene, "analytic");
    simulation.update_boxes();
    for (int k = 0; k < 2 * parts; ++k)
      CHECK(simulation.step(kFrame / parts).status == StepStatus::done);
    const BodyState& brick = simulation.world().states()[1];
    CAPTURE(parts);
    CHECK(brick.linear_momentum_w.head<1>().norm() / 0.0025 == Approx(2.91).margin(0.02));
    CHECK(brick.position_w.y() > 0.0);
  }
}
