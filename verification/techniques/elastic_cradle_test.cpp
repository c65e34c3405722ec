/// \file
/// \brief Elastic bodies that meet one after another: energy is kept, or the loss is booked and stated.
#include "tumble/record/metrics.hpp"

#include "support/test.hpp"

namespace tumble {
namespace {

// A cube comes at 1 m/s into four with gaps of 1 cm: without loss the last one leaves with 0.5 J, and the others rest.
Scene cradle(bool floor) {
  Scene scene;
  if (floor) scene.ground.emplace(SceneGround{0.0, 1.0});
  if (!floor) scene.gravity_w.setZero();
  for (int k = 0; k < 5; ++k) {
    SceneBox cube;
    cube.size.setConstant(0.2);
    cube.friction = 0.0;
    cube.restitution = 1.0;
    cube.position_w = Vec3(k == 0 ? -0.5 : 0.21 * (k - 1), 0.1, 0.0);
    if (k == 0) cube.velocity_w.x() = 1.0;
    scene.boxes.push_back(cube);
  }
  return scene;
}

bool is_one_of(std::string_view name, std::initializer_list<std::string_view> list) {
  return std::ranges::find(list, name) != list.end();
}

// As the lines of `tumble techniques` say: several impacts of a step are one; nothing bounces; or bodies are damped.
bool may_lose(std::string_view name, bool floor) {
  if (is_one_of(name, {"time_stepping", "faure", "damped", "relaxation", "settling"})) return true;
  return floor && (name.substr(0, 8) == "timewarp" || name == "glued");
}

}  // namespace

TEST_CASE("Elastic bodies keep their energy, or the technique says that they do not and books it",
          "[unit][technique]") {
  for (const TechniqueRecipe& recipe : technique_library()) {
    for (const bool floor : {false, true}) {
      INFO(recipe.name << (floor ? " on a floor" : ""));
      Simulation run(cradle(floor), recipe.name);
      MetricsMeter meter;
      run.observe(meter);
      CHECK(run.run_for(1.2) <= StepStatus::event_cap);
      const Metrics& m = meter.metrics();
      CHECK(std::abs(m.energy_error) < 0.05);  // J, of 0.5 J; springs are not at rest
      const double start = 0.5 + (floor ? 5 * 9.81 * 0.1 : 0.0);  // [J]
      const double lost = start - m.kinetic - m.potential;
      INFO(lost << " J are lost");
      CHECK((lost > 0.06) ==
            may_lose(recipe.name, floor));  // 0.068 or more; springs sink in: 0.048
    }
  }
}

}  // namespace tumble
