/// \file
/// \brief A check of a run by any technique: bodies are where they were hit.
#pragma once

#include "tumble/record/run_checks.hpp"

#include <vector>

namespace tumble {

/// When an impulse acts at a point, the body is there, within half its shortest edge: it has come from where the step began, and
/// gets to where the step ends, no faster than its speeds before and after and all its impulses in the step allow.
///
/// A technique that lets impulses act at predicted poses stops a fast body where the step began instead, up to its way in a
/// step before it arrives. Collisions of bodies that move by less than half their shortest edge in the step are not looked
/// at. The status is StepStatus::held_by_nothing.
/// \par Cost
/// A copy of all states in each step, and a comparison for each collision.
class HitCheck : public RunCheck {
 public:
  void on_begin(const World& world) override;
  void on_change(const World& world, double energy_added) override;
  void on_event(const Event& event) override;
  void on_step(const World& world, const StepReport& report) override;

 private:
  void find_speeds(const World& world);
  void look(const World& world, const Event& event, BodyId body);

  double time_ = 0.0;              // [s] before the step
  std::vector<BodyState> before_;  // ditto
  std::vector<Event> events_;      // of this step
  std::vector<double> speeds_;     // [m/s] of each body in it, at most
};

}  // namespace tumble
