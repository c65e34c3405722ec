/// \file
/// \brief Scenes that every technique steps, or refuses by its own name.
#include "tumble/scenes/simulation.hpp"

#include "impulse_damped/scene_runs.hpp"
#include "support/catch.hpp"

using namespace tumble;
using namespace tumble::test;

TEST_CASE("Every technique steps the scenes that are compared, or refuses them by its name",
          "[unit][technique]") {
  struct Compared {
    const char* scene;
    int steps;  // exact times take a second for one step of the pyramid of figure 6.6
  };
  for (const auto& [scene, steps] :
       {Compared{"bouncing_box", 30}, Compared{"stack", 3}, Compared{"dice", 3},
        Compared{"fig6_6", 1}, Compared{"fig6_7", 3}}) {
    for (const TechniqueRecipe& recipe : technique_library()) {
      INFO(scene << ", " << recipe.name);
      World world = world_of(scene);
      const double before = world.time();
      const auto technique = make_technique(recipe.name);
      std::string refusal;
      try {
        for (int k = 0; k < steps; ++k) {
          const StepReport report = technique->step(world, kFrame);
          CHECK(report.status < StepStatus::unsolved);
        }
      } catch (const std::invalid_argument& error) {
        refusal = error.what();
      }
      if (refusal.empty()) {
        CHECK(world.time() == near(before + steps * kFrame).margin(1e-12));
        for (const BodyState& state : world.states()) CHECK(state.position_w.allFinite());
      } else {
        CHECK(refusal.find("technique " + std::string(recipe.name)) != std::string::npos);
      }
    }
  }
}
