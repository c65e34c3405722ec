/// \file
/// \brief A column without glue that falls, and the moments at which its joints open (footnote of thesis
///        6.2).
#pragma once

#include "tumble/exterior_rotation/glued.hpp"

#include "driver/experiment.hpp"
#include "exterior_rotation/falling_column.hpp"
#include "exterior_rotation/glued_runs.hpp"

namespace tumble::chapters {

// A fall with joints that push only.
struct UnilateralRun {
  World world;                 // at the end
  std::vector<Joint> joints;   // at the end
  std::vector<double> events;  // [s] since the start, moments at which joints changed
};

// Options of a fall without glue.
// accuracy: [-] of dormand_prince
inline GluedOptions unilateral(GluedScheme scheme, GluedEvents events, double accuracy = 1e-12) {
  GluedOptions options = glued_options(scheme, PoseUpdate::separate, accuracy);
  options.joints = GluedJoints::unilateral;
  options.events = events;
  return options;
}

// Notes the time of each event.
class EventTimes : public Observer {
 public:
  void on_event(const Event& event) override { times.push_back(event.time); }

  std::vector<double> times;
};

// Lets a world fall.
// end: [s] length of the fall
inline UnilateralRun run_unilateral(
    World world, const GluedOptions& options, double end, int steps,
    const std::function<void(const World&, const Glued&)>& after = {}) {
  UnilateralRun run{.world = std::move(world)};
  Glued technique(options);
  EventTimes notes;
  technique.observe(&notes);
  technique.find(run.world);
  if (after) after(run.world, technique);
  for (int n = 0; n < steps; ++n) {
    finished(technique.step(run.world, end / steps));
    if (after) after(run.world, technique);
  }
  run.joints.assign(technique.joints().begin(), technique.joints().end());
  run.events = notes.times;
  return run;
}

}  // namespace tumble::chapters
