/// \file
/// \brief Every technique of the library, run for comparison, and how its work is counted.
#include "choosing/compared.hpp"

#include <array>
#include <cmath>
#include <utility>

namespace tumble::chapters {
namespace {

class After : public RunObserver {
 public:
  explicit After(const std::function<void(const World&, const Metrics&, const StepReport&)>& told)
      : told_(told) {}
  void on_step(const World& world, const Technique&, const StepReport& report,
               const Metrics& metrics) override {
    if (told_) told_(world, metrics, report);
  }

 private:
  const std::function<void(const World&, const Metrics&, const StepReport&)>& told_;
};

}  // namespace

std::vector<PlayedTechnique> compared_techniques() {
  std::vector<PlayedTechnique> list;
  for (const TechniqueRecipe& recipe : technique_library()) {
    PlayedTechnique played{std::string(recipe.name)};
    const Parameters options = recipe.options();
    for (const Parameter& option : options.all())
      if (option.key == "randomness") played.settings.push_back("randomness=off");
    list.push_back(std::move(played));
  }
  return list;
}

double work_of(const StepReport& report, double pivot) {
  const std::int64_t others = report.iterations + report.impulses + report.pair_tests +
                              report.integrations + report.searches;
  return static_cast<double>(others) + pivot * static_cast<double>(report.pivots);
}

RunResult run_compared(
    const Scene& scene, const PlayedTechnique& played, double dt, double duration,
    const std::function<void(const World&, const Metrics&, const StepReport&)>& after) {
  const auto technique = make_technique(played.name, played.settings);
  RunSettings settings;
  settings.dt = dt;
  settings.duration = duration;
  After observer(after);
  const std::array<RunObserver*, 1> observers = {&observer};
  return run_scene(scene, *technique, settings, observers);
}

std::string number_name(const std::string& technique, const std::string& what) {
  std::string name = technique;
  name += ": ";
  return name += what;
}

void add_number(std::vector<Quantity>& list, std::string name, std::string unit, double value) {
  if (!std::isnan(value)) list.push_back({std::move(name), std::move(unit), value});
}

}  // namespace tumble::chapters
