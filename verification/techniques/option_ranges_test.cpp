/// \file
/// \brief Options of all techniques at the ends of their ranges: every step ends, and the work in it is counted.

#include "support/test.hpp"

namespace tumble {
namespace {

constexpr double kMuch = 1000;  // of what is counted: passes, events, impacts

// Two boxes that slide and fall onto a third one, with a bounce: contacts and collisions from the second step on.
Scene small_heap() {
  Scene scene;
  scene.ground.emplace(SceneGround{0.4, 0.5});
  SceneBox below{.position_w = Vec3(0.0, 0.5, 0.0)};
  SceneBox on_it = below;
  on_it.position_w = Vec3(0.1, 1.502, 0.05);
  on_it.velocity_w = Vec3(0.5, -1.0, 0.0);
  SceneBox thrown = below;
  thrown.size = Vec3(0.4, 0.2, 0.3);
  thrown.mass = 0.1;
  thrown.restitution = 0.8;
  thrown.position_w = Vec3(-0.9, 0.7, 0.0);
  thrown.velocity_w = Vec3(6.0, -1.0, 0.3);
  thrown.angular_velocity_w = Vec3(2.0, 9.0, -4.0);
  scene.boxes = {below, on_it, thrown};
  return scene;
}

std::int64_t work_of(const StepReport& report) {
  return report.events + report.iterations + report.pivots + report.impulses + report.pair_tests +
         report.integrations + report.searches + report.rewinds + report.restarts;
}

// A few steps with these settings; a value that does not fit the others is refused when the technique is made.
std::int64_t busiest_step(const TechniqueRecipe& recipe, const Parameters& settings) {
  std::int64_t most = 0;
  try {
    Simulation run(small_heap(), recipe.make(settings, 1));
    for (int k = 0; k < 4; ++k) {
      const StepReport report = run.step();
      most = std::max(most, work_of(report));
      if (report.status >= StepStatus::unsolved) break;
    }
  } catch (const std::invalid_argument& refusal) {
    CHECK(std::string(refusal.what()).size() > std::string("tumble: ").size());
  } catch (const StepFault& fault) {
    CHECK(std::string(fault.what()).size() > std::string("tumble: ").size());
  }
  return most;
}

// The values of an option that may hurt; of whole numbers none above `most`.
std::vector<std::string> ends_of(const Parameter& option, double most) {
  if (option.kind == ParameterKind::word) return option.choices;
  if (option.kind == ParameterKind::flag) return {"on", "off"};
  if (option.kind == ParameterKind::text) return {};
  const bool whole = option.kind == ParameterKind::whole;
  return {shortest_text(option.low),
          shortest_text(whole ? std::min(option.high, most) : option.high)};
}

void try_each(double most_counted, std::int64_t most_work) {
  for (const TechniqueRecipe& recipe : technique_library()) {
    const Parameters usual = recipe.options();
    for (const Parameter& option : usual.all()) {
      for (const std::string& value : ends_of(option, most_counted)) {
        INFO(recipe.name << " " << option.key << "=" << value);
        Parameters settings = usual;
        settings.set(option.key, value);
        CHECK(busiest_step(recipe, settings) < most_work);
      }
    }
  }
}

}  // namespace

TEST_CASE("No option at an end of its range makes a step go on for ever", "[unit][technique]") {
  try_each(kMuch, 200000);  // 116 105: `basic`, resolution=1e-15
}

TEST_CASE("No count at the end of its range makes a step go on for ever",
          "[.long][unit][technique]") {
  try_each(1e9, 100'000'000);  // 49 000 049: `basic`, event_cap=1e6
}

TEST_CASE("No options at ends of their ranges together make a step go on for ever",
          "[unit][technique]") {
  Random chance(26);
  for (const TechniqueRecipe& recipe : technique_library()) {
    for (int k = 0; k < 10; ++k) {
      const Parameters usual = recipe.options();
      Parameters settings = usual;
      std::string tried(recipe.name);
      for (const Parameter& option : usual.all()) {
        const std::vector<std::string> ends = ends_of(option, kMuch / 10);
        if (ends.empty()) continue;
        const std::string& value = ends[chance.below(static_cast<std::uint32_t>(ends.size()))];
        settings.set(option.key, value);
        tried += " " + option.key + "=" + value;
      }
      INFO(tried);
      CHECK(busiest_step(recipe, settings) < 2'000'000);
    }
  }
}

}  // namespace tumble
