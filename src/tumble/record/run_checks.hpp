/// \file
/// \brief Checks of a run by any technique: no energy from nothing, large turns, boxes that appear inside others, bodies that
///        are not where they were hit, bodies that hang in the air.
#pragma once

#include "tumble/dynamics/technique.hpp"
#include "tumble/geometry/bounding_tree.hpp"

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
/// (`tolerance::start_overlap`). The technique moves the two apart, which can add energy. Where it is deeper than a tenth of the
/// shorter edge (`tolerance::deep_overlap`) the status of the step is StepStatus::passed_through.
class AppearCheck : public RunCheck {
 public:
  void on_begin(const World& world) override;
  void on_change(const World& world, double energy_added) override;
  void on_step(const World& world, const StepReport& report) override;

 private:
  bool deep_ = false;          // a box has appeared so deep since the last step
  std::vector<BodyId> known_;  // there before the change, ascending
};

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

/// Under gravity bodies do not stay in place unless they reach something that is fixed or moves, by way of others that are
/// near: within `tolerance::deep_overlap` of their shortest edge, in any direction, or by a joint.
///
/// A body stays in place if it has moved by less than `tolerance::hang_move` of what it would have fallen from rest meanwhile:
/// at least that tenth of an edge, and for three steps, without a collision. Free flight never does so, nor at the top of a
/// throw. Bounds are compared, which makes a report certain.
/// \par Cost
/// A comparison for each body. Bodies that stay in place are looked at together, the next time after twice as long.
class HangCheck : public RunCheck {
 public:
  void on_begin(const World& world) override;
  void on_change(const World& world, double energy_added) override;
  void on_event(const Event& event) override;
  void on_step(const World& world, const StepReport& report) override;

 private:
  // Where a body has been since when.
  struct Stay {
    Vec3 place_w = Vec3::Zero();
    double since = 0.0;     // [s]
    double look_at = 0.0;   // [s] not before
    bool in_place = false;  // for long enough
  };
  void look(const World& world);
  void find_held(const World& world);

  double time_ = 0.0;        // [s] before the step
  std::vector<Stay> stays_;  // by index
  std::vector<BodyId> hit_;  // in collisions of this step
  std::vector<Bounds> bounds_;
  std::vector<IndexPair> pairs_;  // that are near each other
  std::vector<char> held_;        // by index: not 0 if it may stay
  BoundingTree near_;
};

}  // namespace tumble
