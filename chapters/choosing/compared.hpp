/// \file
/// \brief Every technique of the library, run for comparison, and how its work is counted.
#pragma once

#include "tumble/record/run.hpp"

#include "driver/experiment.hpp"

namespace tumble::chapters {

// All techniques of the library, so that none can be forgotten.
//
// Each has its standard options, but for chance, which is off: it would blur errors.
inline std::vector<PlayedTechnique> compared_techniques() {
  std::vector<PlayedTechnique> list;
  for (const TechniqueRecipe& recipe : technique_library()) {
    PlayedTechnique played{std::string(recipe.name)};
    const Parameters options = recipe.options();
    for (const Parameter& option : options.all())
      if (option.key == "randomness") played.settings.push_back("randomness=off");
    // Three times the work with eight.
    if (recipe.name == "time_stepping") played.settings.push_back("directions=4");
    // A quarter of the usual: what meets the one meets the other.
    if (recipe.name == "microcollisions") played.settings.push_back("event_cap=500");
    list.push_back(std::move(played));
  }
  return list;
}

// The work of a technique, without the clock: everything that its reports count.
//
// Sweeps, pivots, impulses, tests of pairs, bodies advanced and evaluations of searches, each as one.
// pivot: [-] how many others a pivot counts for
// Returns [-] their sum
inline double work_of(const StepReport& report, double pivot = 1.0) {
  const std::int64_t others = report.iterations + report.impulses + report.pair_tests +
                              report.integrations + report.searches;
  return static_cast<double>(others) + pivot * static_cast<double>(report.pivots);
}

class After : public RunObserver {
 public:
  explicit After(const std::function<void(const World&, const Metrics&)>& called)
      : called_(called) {}
  void on_step(const World& world, const Technique&, const StepReport&,
               const Metrics& metrics) override {
    if (called_) called_(world, metrics);
  }

 private:
  const std::function<void(const World&, const Metrics&)>& called_;
};

// Runs a scene under a technique.
// duration: [s] simulated time
// stop: called before every step; true ends the run as interrupted
inline RunResult run_compared(const Scene& scene, const PlayedTechnique& played, double dt,
                              double duration,
                              const std::function<void(const World&, const Metrics&)>& after = {},
                              const std::function<bool()>& stop = {}) {
  RunSettings settings{.dt = dt, .duration = duration};
  After observer(after);
  const std::array<RunObserver*, 1> observers = {&observer};
  return run_scene(scene, *make_technique(played.name, played.settings), settings, observers, stop);
}

// A cell that holds no number.
inline constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

// The name of a number of a technique.
inline std::string number_name(const std::string& technique, const std::string& what) {
  return technique + ": " + what;
}

// Adds a number unless there is none.
inline void add_number(std::vector<Quantity>& list, std::string name, std::string unit,
                       double value) {
  if (!std::isnan(value)) list.push_back({std::move(name), std::move(unit), value});
}

}  // namespace tumble::chapters
