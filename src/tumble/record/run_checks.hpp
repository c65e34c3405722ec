/// \file
/// \brief Checks of a run by any technique: no energy from nothing, large turns, boxes that appear inside others.
#pragma once

#include "tumble/dynamics/technique.hpp"

#include <string>
#include <vector>

namespace tumble {

/// A check of every step of a run.
class RunCheck : public Observer {
 public:
  /// Verdict on the last step: StepStatus::done, or the fault.
  [[nodiscard]] StepStatus status() const { return status_; }

  /// Message about the first fault: step, time, body, value, and a remedy if there is one.
  /// \return empty if there was none
  [[nodiscard]] const std::string& message() const { return message_; }

 protected:
  /// Keeps the message about the first fault.
  void find(const World& world, const std::string& what);

  StepStatus status_ = StepStatus::done;  ///< the verdict on the last step

 private:
  std::string message_;
};

/// The total energy of a run, kinetic and potential, must not rise: contacts, friction and impacts only remove energy.
///
/// Small errors of a technique are allowed: `tolerance::energy_gain` times the kinetic energy at the start and the
/// sum of m g L over the movable bodies, L a body's longest edge; and of that which the technique has not booked,
/// `tolerance::unbooked_gain` times the largest kinetic energy so far and that sum. What rounds positions in a step gives
/// bodies at rest in free space speeds, whose energy is allowed too.
class EnergyCheck : public RunCheck {
 public:
  void on_begin(const World& world) override;
  void on_change(const World& world, double energy_added) override;
  void on_step(const World& world, const StepReport& report) override;

 private:
  void begin(const World& world);

  double start_ = 0.0;            // [J] energy at the start, with what was added from outside
  double allowed_ = 0.0;          // [J] above it
  double booked_ = 0.0;           // [J] since the start
  double kinetic_ = 0.0;          // [J] the most so far
  double weight_ = 0.0;           // [J] sum of m g L
  double time_ = 0.0;             // [s] before the step
  std::vector<double> energies_;  // [J] of each body, before the step
};

/// Reports the first body that turns by more than a radian in a step, with a time step that is short enough. Not every
/// technique finds contacts and conserves energy in such a step (step_in_parts()). The status stays StepStatus::done.
class TurnCheck : public RunCheck {
 public:
  void on_begin(const World& world) override;
  void on_step(const World& world, const StepReport& report) override;

 private:
  double time_ = 0.0;  // [s] when the step began
};

/// Reports the first box that appears inside another body, deeper than a scene may have it at its start
/// (`tolerance::start_overlap`). The technique moves the two apart, which can add energy. The status stays StepStatus::done.
class AppearCheck : public RunCheck {
 public:
  void on_begin(const World& world) override;
  void on_change(const World& world, double energy_added) override;

 private:
  std::vector<BodyId> known_;  // there before the change, ascending
};

}  // namespace tumble
