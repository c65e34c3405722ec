/// \file
/// \brief A check of a run that knows no technique: no passive scene gains energy.
#pragma once

#include "tumble/dynamics/technique.hpp"

#include <string>
#include <vector>

namespace tumble {

/// Watches the total energy of a run, kinetic and potential. Nothing in a scene adds any: contacts, friction and impacts
/// can only take it away. A run in which it rises shows something that cannot happen, however it was booked.
///
/// Small errors of a technique are allowed: `tolerance::energy_gain` times the kinetic energy at the start and the
/// sum of m g L over the movable bodies, L a body's longest edge.
class EnergyCheck : public Observer {
 public:
  void on_begin(const World& world) override;
  void on_change(const World& world, double energy_added) override;
  void on_step(const World& world, const StepReport& report) override;

  /// Whether the energy is above the limit.
  /// \return after the last step; false for a world that is not finite
  [[nodiscard]] bool failed() const { return failed_; }

  /// The first failure in words: step, time, energy, and the body that gained most in that step.
  /// \return empty if there was none
  [[nodiscard]] const std::string& message() const { return message_; }

 private:
  void begin(const World& world);

  double start_ = 0.0;            // [J] energy at the start, with what was added from outside
  double allowed_ = 0.0;          // [J] above it
  std::vector<double> energies_;  // [J] of each body, before the step
  bool failed_ = false;
  std::string message_;
};

}  // namespace tumble
