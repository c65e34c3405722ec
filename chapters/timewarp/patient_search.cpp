/// \file
/// \brief A search over all bodies that misses nothing, as a reference for the order of collisions
///        (thesis 5.1).
#include "timewarp/patient_search.hpp"

#include <stdexcept>

namespace tumble::chapters {
namespace {

BasicOptions options_of(double resolution) {
  BasicOptions options;
  options.resolution = resolution;
  options.search = SearchMethod::conservative;
  return options;
}

// Keeps what happened until it is known whether it counts.
class Kept final : public Observer {
 public:
  void on_event(const Event& event) override { events.push_back(event); }
  EventLog events;
};

}  // namespace

PatientSearch::PatientSearch(double resolution)
    : resolution_(resolution), basic_(options_of(resolution)) {}

std::unique_ptr<Technique> PatientSearch::clone() const {
  return std::make_unique<PatientSearch>(*this);
}

StepReport PatientSearch::step(World& world, double dt) {
  World after = world;
  Kept kept;
  basic_.observe(&kept);
  StepReport report = basic_.step(after, dt);
  basic_.observe(nullptr);
  if (report.status == StepStatus::event_cap) {
    if (dt < resolution_)
      throw std::runtime_error("a search meets its cap however short the step is");
    const StepReport first = step(world, 0.5 * dt);
    report = step(world, 0.5 * dt);
    report.events += first.events;
    report.restarts += first.restarts + 1;
    return report;
  }
  world = after;
  if (observer() != nullptr)
    for (const Event& event : kept.events) observer()->on_event(event);
  return report;
}

}  // namespace tumble::chapters
