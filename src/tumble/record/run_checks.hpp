/// \file
/// \brief Checks of a run by any technique: no energy from nothing, no body through another one.
#pragma once

#include "tumble/dynamics/technique.hpp"
#include "tumble/geometry/bounding_tree.hpp"

#include <string>
#include <vector>

namespace tumble {

/// A check of every step of a run.
class RunCheck : public Observer {
 public:
  /// Verdict on the last step.
  /// \return StepStatus::done, or the fault
  [[nodiscard]] StepStatus status() const { return status_; }

  /// Message about the first fault: step, time, body, value, and a remedy if there is one.
  /// \return empty if there was none
  [[nodiscard]] const std::string& message() const { return message_; }

 protected:
  /// Keeps the message about the first fault.
  /// \param world  the bodies after the step
  /// \param what   the fault
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

/// No body may pass through another one in a step, and none may overlap another one by more than
/// `tolerance::deep_overlap` of the shorter of their shortest edges at the end of the run. (During the run deep overlaps
/// are allowed: a technique may need some steps to separate bodies that meet fast.)
///
/// Two bodies that are apart before and after a step have passed through each other if their cores meet on the straight
/// line between the two poses. The core of a body is a box inside it, so much smaller that the turning body covers it
/// during the whole step. If cores overlap after a step, or come to overlap in several, the pair is checked in the same way
/// once it has separated, from its last separate poses. So a reported passage is certain; one near an edge is missed, and of
/// a body that turns far all but those through its centre.
/// \par Cost
/// A comparison for each body, as long as none moves by half its shortest edge in a step or is deep in another one.
class PassageCheck : public RunCheck {
 public:
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
  BoundingTree near_;
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

/// Reports the first body that turns by more than a radian in a step, with a time step that is short enough. Not every
/// technique finds contacts and conserves energy in such a step (step_in_parts()). The status stays StepStatus::done.
class TurnCheck : public RunCheck {
 public:
  void on_begin(const World& world) override;
  void on_step(const World& world, const StepReport& report) override;

 private:
  double time_ = 0.0;  // [s] when the step began
};

}  // namespace tumble
