/// \file
/// \brief Scenes from outside with too many contacts with friction for one dense problem.
#include "tumble/record/run_checks.hpp"

#include "support/shared_data.hpp"
#include "support/test.hpp"

#include <ctime>

namespace {

double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

// Layers of three blocks, crosswise; one in the middle is pulled.
Scene tower_of_blocks(int layers, int pulled) {
  Scene scene{.ground = SceneGround{0.4, 0.0}};
  for (int layer = 0; layer < layers; ++layer)
    for (int k = -1; k <= 1; ++k) {
      SceneBox block;
      const bool across = layer % 2 != 0;
      block.name = "b" + std::to_string(layer) + "_" + std::to_string(k + 1);
      block.size = across ? Vec3(0.025, 0.015, 0.075) : Vec3(0.075, 0.015, 0.025);
      const double aside = 0.025 * k;
      block.position_w = Vec3(across ? aside : 0.0, 0.015 * (layer + 0.5), across ? 0.0 : aside);
      block.mass = 0.018;
      block.friction = 0.4;
      if (layer == pulled && k == 0)
        block.velocity_w = 1.5 * (across ? Vec3::UnitZ() : Vec3::UnitX());
      scene.boxes.push_back(block);
    }
  return scene;
}

// A tent of two cards that lean on each other at 65 degrees, a millimetre above its floor.
void add_tent(const std::string& name, double x, double floor, Scene& scene) {
  const double angle = 65.0 * std::numbers::pi / 180.0;
  const Vec3 half(1.25 * std::cos(angle) + 0.01 * std::sin(angle) + 0.0005,
                  1.25 * std::sin(angle) + 0.01 * std::cos(angle), 0.0);
  for (const double side : {-1.0, 1.0}) {
    scene.boxes.push_back({.name = name + (side < 0.0 ? "l" : "r"),
                           .size = Vec3(2.5, 0.02, 1.25),
                           .mass = 0.3,
                           .position_w = Vec3(x + side * half.x(), floor + half.y(), 0.0),
                           .orientation_wb = rotation_from_vector(Vec3(0.0, 0.0, -side * angle)),
                           .friction = 0.6});
  }
}

// Two storeys of tents side by side, with flat cards between them; all fall a little first.
Scene card_house(int tents, double drop) {
  Scene scene{.ground = SceneGround{0.6, 0.0}};
  const double pitch = 2.24;
  for (int k = 0; k < tents; ++k)
    add_tent("a" + std::to_string(k), pitch * (k - 0.5 * (tents - 1)), drop, scene);
  const double top = 2.0 * scene.boxes.front().position_w.y();
  for (int k = 0; k < tents - 1; ++k) {
    SceneBox flat{.name = "flat" + std::to_string(k),
                  .size = Vec3(tents == 2 ? 2.6 : 2.2, 0.02, 1.25),
                  .mass = 0.3,
                  .friction = 0.6};
    const double x = pitch * (k - 0.5 * (tents - 2));
    flat.position_w = Vec3(x, top + 0.01, 0.0);
    scene.boxes.push_back(flat);
    add_tent("b" + std::to_string(k), x, top + 0.02 + drop, scene);
  }
  return scene;
}

std::vector<Vec3> places(const Simulation& simulation) {
  std::vector<Vec3> all;
  for (const BodyState& state : simulation.world().states()) all.push_back(state.position_w);
  return all;
}

double fastest(const Simulation& simulation) {
  double most = 0.0;
  for (const BodyState& state : simulation.world().states())
    most = std::max(most, state.linear_momentum_w.norm());
  return most;  // [kg m/s]
}

}  // namespace

TEST_CASE("A tower of blocks with one pulled out keeps its height at first",
          "[unit][analytic][time_stepping][analytic_lcp]") {
  const auto cases = shared_data("../cases");
  if (!cases) return;
  for (const char* technique : {"time_stepping", "analytic"}) {
    INFO(technique);
    Simulation simulation(read_scene(*cases / "36-jenga-pull.toml"), technique);
    EnergyCheck energy;
    simulation.observe(energy);
    const std::vector<Vec3> start = places(simulation);
    const double began = processor_seconds();
    std::int64_t fallbacks = 0;
    for (int k = 0; k < 6; ++k) {
      const StepReport report = simulation.step(kFrame);
      REQUIRE(report.status == StepStatus::done);
      CHECK(report.deepest_overlap < 0.001);
      fallbacks += report.fallbacks;
    }
    CHECK(fallbacks > 0);
    CHECK(processor_seconds() - began < 30.0);  // it was minutes for one step
    CHECK(energy.message().empty());
    const std::vector<Vec3> end = places(simulation);
    for (std::size_t b = 0; b < start.size(); ++b) CHECK(end[b].y() > start[b].y() - 0.001);
  }
}

TEST_CASE("A card house of two storeys stands",
          "[reference][analytic][time_stepping][analytic_lcp]") {
  for (const char* technique : {"time_stepping", "analytic"}) {
    INFO(technique);
    Simulation simulation(card_house(2, 0.001), technique);
    const std::vector<Vec3> start = places(simulation);
    for (int k = 0; k < 60; ++k) REQUIRE(simulation.step(kFrame).status == StepStatus::done);
    const std::vector<Vec3> end = places(simulation);
    for (std::size_t b = 0; b < start.size(); ++b) CHECK((end[b] - start[b]).norm() < 0.02);
  }
}

TEST_CASE("The forces of a step in a corner are found with bounded work, then velocities",
          "[unit][analytic_lcp]") {
  Scene scene{.gravity_w = Vec3(-4.0, -10.0, -4.0)};
  const auto wall = [&](const std::string& name, const Vec3& size, const Vec3& position_w) {
    SceneBox& box = scene.boxes.emplace_back();
    box.name = name;
    box.size = size;
    box.position_w = position_w;
    box.fixed = true;
    box.friction = 0.4;
  };
  wall("floor", Vec3(1.0, 0.2, 1.0), Vec3(-0.4, -0.1, -0.4));
  wall("back", Vec3(1.0, 1.0, 0.2), Vec3(-0.4, 0.4, -0.8));
  wall("side", Vec3(0.2, 1.0, 1.0), Vec3(-0.8, 0.4, -0.4));
  for (int i = 0; i < 9; ++i) {
    SceneBox& box = scene.boxes.emplace_back();
    box.size = Vec3::Constant(0.1);
    box.position_w = Vec3(-0.6 + 0.17 * (i % 3), 0.1, -0.6 + 0.17 * (i / 3));
    box.friction = 0.4;
  }
  Simulation simulation(scene, "analytic");
  std::int64_t most = 0;
  for (int k = 0; k < 37; ++k) {
    const StepReport report = simulation.step(kFrame);
    CHECK(report.status == StepStatus::done);
    most = std::max(most, report.pivots);
  }
  CHECK(most < 40000);  // measured 21366; without a bound 80320, in eight seconds
}

TEST_CASE("Eighteen boxes in a corner, a tower of 36 blocks and a card house take no minutes",
          "[.long][unit][analytic][time_stepping][analytic_lcp]") {
  const auto cases = shared_data("../cases");
  if (!cases) return;
  const std::vector<Scene> scenes = {read_scene(*cases / "scenes/corner18.toml"),
                                     tower_of_blocks(12, 8), card_house(3, 0.07)};
  for (const char* technique : {"time_stepping", "analytic"})
    for (const Scene& scene : scenes) {
      INFO(technique << ", " << scene.title << ", boxes: " << scene.boxes.size());
      Simulation simulation(scene, technique);
      EnergyCheck energy;
      simulation.observe(energy);
      const double began = processor_seconds();
      for (int k = 0; k < 120; ++k) REQUIRE(simulation.step(kFrame).status == StepStatus::done);
      CHECK(processor_seconds() - began < 60.0);
      CHECK(energy.message().empty());
      if (scene.boxes.size() == 21) CHECK(fastest(simulation) < 0.001);  // the corner is at rest
    }
}
