/// \file
/// \brief Checks of a run that know no technique: what no scene can do.
#pragma once

#include "tumble/dynamics/technique.hpp"
#include "tumble/geometry/broad_phase.hpp"

#include <memory>
#include <string>
#include <vector>

namespace tumble {

/// A check of every step of a run.
class RunCheck : public Observer {
 public:
  /// The verdict on the last step.
  /// \return StepStatus::done, or the fault that was found
  [[nodiscard]] StepStatus status() const { return status_; }

  /// The first finding in words: step, time, body, value, and a remedy if there is one.
  /// \return empty if there was none
  [[nodiscard]] const std::string& message() const { return message_; }

 protected:
  /// Keeps the first finding.
  /// \param world  the bodies after the step
  /// \param what   the finding
  void find(const World& world, const std::string& what);

  StepStatus status_ = StepStatus::done;  ///< the verdict on the last step

 private:
  std::string message_;
};

/// The total energy of a run, kinetic and potential, does not rise. Nothing in a scene adds any: contacts,
/// friction and impacts can only take it away.
///
/// Small errors of a technique are allowed: `tolerance::energy_gain` times the kinetic energy at the start and the
/// sum of m g L over the movable bodies, L a body's longest edge; and of that which the technique has not booked,
/// `tolerance::unbooked_gain` times the largest kinetic energy so far and that sum.
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
  std::vector<double> energies_;  // [J] of each body, before the step
};

/// No body goes through another one in a step, and none is left deep in one when the run ends: by more than
/// `tolerance::deep_overlap` of the shorter of their shortest edges. A technique may need some steps to part those that
/// meet fast.
///
/// Two bodies that were apart before a step and are apart after it went through each other if their cores meet
/// on the straight way between; so did two that a step left with their cores in each other, if the way from where they were
/// apart before to where they are apart again leads through, in however many steps. The core of a body is a box within it, so much smaller that it stays inside
/// however the body turned in the step. So a finding is certain; a passage near an edge is not found, nor, of a body that
/// turned far, one with no more than its innermost part.
/// \par Cost
/// A comparison for each body, as long as none moves by half its shortest edge in a step or is deep in another one.
class PassageCheck : public RunCheck {
 public:
  /// Makes the check; no step has been seen.
  PassageCheck();
  void on_begin(const World& world) override;
  void on_change(const World& world, double energy_added) override;
  void on_step(const World& world, const StepReport& report) override;
  /// Looks for bodies that a step has brought into others, however slowly: they are found once they leave on the other side.
  /// \param world    after the step, which on_step() has seen
  /// \param deepest  [m] deepest overlap in it, see OverlapMeter; nothing is looked at where no core can have met another
  void on_overlap(const World& world, double deepest);
  /// Looks for bodies that are left in others.
  /// \param world  after the last step, finite
  void at_end(const World& world);

 private:
  void look_for_passages(const World& world);
  void look_at_entered(const World& world);
  void find_passage(const World& world, std::size_t first, std::size_t second);
  [[nodiscard]] double turn_of(const World& world, std::size_t k) const;

  std::vector<BodyState> before_;       // at the start of the step
  double time_ = 0.0;                   // [s] ditto
  std::vector<BodyState> last_before_;  // at the start of the one before
  double last_time_ = 0.0;              // [s] ditto
  std::unique_ptr<BroadPhase> near_;
  std::vector<char> fast_;          // not 0: moved by more than half its shortest edge
  std::vector<std::size_t> solid_;  // bodies with a core, by index; the next two are theirs
  std::vector<Box> cores_;          // where the step began
  std::vector<Bounds> swept_;
  std::vector<IndexPair> pairs_;

  // Two bodies whose cores met in a step and have not parted since.
  struct Entering {
    std::size_t body = 0;
    BodyState before;     // where that step began
    double turned = 0.0;  // [rad] since, at most
  };
  struct Entered {
    Entering first, second;
  };
  std::vector<Entered> entered_;
};

/// A body that turns by more than a radian in a step is named, once, with a step that would do. Not every technique finds its
/// contacts and keeps its energy then (step_in_parts()); the step counts as done all the same.
class TurnCheck : public RunCheck {
 public:
  void on_begin(const World& world) override;
  void on_step(const World& world, const StepReport& report) override;

 private:
  double time_ = 0.0;  // [s] when the step began
};

}  // namespace tumble
