/// \file
/// \brief A check of a run by any technique: bodies are where they were hit.
#pragma once

#include "tumble/record/run_checks.hpp"

#include <vector>

namespace tumble {

/// From its last collision in a step a body flies to where the step ends, with the velocity that it has there. So it was at
/// the point of the impulse when that acted: within half its shortest edge.
///
/// A technique that lets impulses act at predicted poses stops a fast body where the step began instead, up to its way in a
/// step before it arrives. Collisions of bodies that move by less than half their shortest edge in the step are not looked
/// at. The status is StepStatus::held_by_nothing.
/// \par Cost
/// A comparison for each collision.
class HitCheck : public RunCheck {
 public:
  void on_begin(const World& world) override;
  void on_change(const World& world, double energy_added) override;
  void on_event(const Event& event) override;
  void on_step(const World& world, const StepReport& report) override;

 private:
  void look(const World& world, const Event& event, BodyId body, double speed_before, double dt);

  double time_ = 0.0;            // [s] before the step
  std::vector<double> speeds_;   // [m/s] of each body, ditto
  std::vector<Event> events_;    // of this step
  std::vector<char> looked_at_;  // by index: not 0 if its last collision has been looked at
};

}  // namespace tumble
