/// \file
/// \brief The interface of every technique.
#pragma once

#include "tumble/dynamics/event_log.hpp"
#include "tumble/dynamics/step_mistakes.hpp"
#include "tumble/dynamics/world.hpp"
#include "tumble/math/dense.hpp"

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tumble {

/// How a step ended.
enum class StepStatus : std::uint8_t {
  done,            ///< the whole step was simulated
  event_cap,       ///< more events than the cap allows: the rest of the step ignored them
  energy_gained,   ///< the total energy is above that of the start: seen by a run, see EnergyCheck
  passed_through,  ///< a body went through another one: seen by a run, see PassageCheck
  unsolved,        ///< a solver found no solution; the report names it
  not_finite       ///< a state became infinite or NaN
};

/// Energy that a step added (above 0) or removed (below 0), by cause.
///
/// The part that is not booked here is the technique's energy error.
struct BookedEnergy {
  double restitution = 0.0;  ///< [J] normal impulses of collisions and contacts
  double friction = 0.0;     ///< [J] tangential impulses
  double damping = 0.0;      ///< [J] scaled or zeroed momenta, sleeping
  double repair = 0.0;       ///< [J] bodies moved to end their overlap

  /// All of it.
  /// \return [J]
  [[nodiscard]] double total() const { return restitution + friction + damping + repair; }
};

/// What one step did, in counts: verdicts are made of these, never of wall time.
struct StepReport {
  StepStatus status = StepStatus::done;  ///< how it ended
  std::int64_t events = 0;               ///< collisions resolved
  std::int64_t contacts = 0;             ///< contact points at the end
  std::int64_t iterations = 0;           ///< sweeps of iterative solvers
  std::int64_t pivots = 0;               ///< pivots of direct solvers
  std::int64_t impulses = 0;             ///< impulses applied
  std::int64_t pair_tests = 0;           ///< separation tests of two bodies
  std::int64_t integrations = 0;         ///< bodies advanced, each advance counted
  std::int64_t searches = 0;             ///< evaluations of event searches
  std::int64_t rewinds = 0;              ///< bodies put back in time
  std::int64_t restarts = 0;             ///< event searches begun again for a missed third body
  std::int64_t fallbacks = 0;            ///< times that another method stepped in, as documented
  double deepest_overlap = 0.0;          ///< [m] largest penetration found, 0 or above
  BookedEnergy energy;                   ///< energy added and removed, by cause
};

/// A file about a failed step that a technique offers, to be looked at or solved again.
struct Diagnostic {
  std::string_view file;     ///< its name, for example "unsolved_A.mtx"
  std::string_view comment;  ///< what the matrix is, for the head of the file
  MatX matrix;               ///< what it holds
};

class Observer;

/// A way to advance a world by one time step.
///
/// A technique may keep memory between steps (warm starts, remembered axes); copying it with
/// clone() copies the memory, so a snapshot is a copy of the world and a clone of the technique.
class Technique {
 public:
  virtual ~Technique() = default;

  /// The name that a user calls it by.
  /// \return for example "basic"
  [[nodiscard]] virtual std::string_view name() const = 0;

  /// Advances the world.
  /// \param world  all bodies; in and out
  /// \param dt     [s] above 0; may differ from step to step
  /// \return what was done
  /// \throws std::invalid_argument for a dt that is not finite and above 0; StepRefused for a world that the
  ///         technique cannot simulate, or not with this dt, with the reason
  virtual StepReport step(World& world, double dt) = 0;

  /// A copy with all memory.
  /// \return steps exactly like this one from here on
  [[nodiscard]] virtual std::unique_ptr<Technique> clone() const = 0;

  /// The contact points of the last step.
  /// \return valid until the next step; each at the pose that it belongs to
  [[nodiscard]] virtual std::span<const ContactRecord> contacts() const { return {}; }

  /// Files about a failed last step.
  /// \return empty unless the last step ended as StepStatus::unsolved and there is something to keep
  [[nodiscard]] virtual std::vector<Diagnostic> diagnostics() const { return {}; }

  /// What this technique leaves out of a world's physics.
  /// \param world the bodies
  /// \return for example "friction"; nothing if it simulates everything
  [[nodiscard]] virtual std::vector<std::string> ignores(const World& world) const {
    (void)world;
    return {};
  }

  /// Whether it holds the joints of a world. A world with joints is refused for any other technique: see
  /// require_joints_held().
  /// \return false unless overridden
  [[nodiscard]] virtual bool holds_joints() const { return false; }

  /// Sets the observer of events during a step.
  /// \param observer  called during every step until changed; nullptr: none. Not owned
  void observe(Observer* observer) { observer_ = observer; }

  /// Makes bodies count as slow when the technique's sleeping rule decides about them, whatever their
  /// speed; without such a rule it changes nothing.
  /// \param bodies  by index, not 0 for such a body; empty: none. Not owned, so it has to be taken back
  ///                before it ends
  void count_as_slow(std::span<const char> bodies) { slow_bodies_ = bodies; }

 protected:
  Technique() = default;
  /// For clone().
  /// \param other the original
  Technique(const Technique& other) = default;
  /// For clone().
  /// \param other the original
  /// \return this
  Technique& operator=(const Technique& other) = default;

  /// The observer.
  /// \return nullptr: none
  [[nodiscard]] Observer* observer() const { return observer_; }

  /// See count_as_slow().
  /// \return by index, or empty
  [[nodiscard]] std::span<const char> slow_bodies() const { return slow_bodies_; }

 private:
  std::span<const char> slow_bodies_;
  Observer* observer_ = nullptr;
};

/// Refuses a world with joints for a technique that knows none. A Simulation asks before each step; a program that
/// steps a technique by hand should ask, too.
/// \param technique  the one that is to step
/// \param world      the bodies
/// \throws std::invalid_argument naming the technique, a joint and a technique that holds it
void require_joints_held(const Technique& technique, const World& world);

/// Watches a run. A technique reports events; whatever steps it, for example a Simulation, reports the rest.
class Observer {
 public:
  virtual ~Observer() = default;

  /// A run begins, or begins anew because its start was changed.
  /// \param world the bodies at time 0
  virtual void on_begin(const World& world) { (void)world; }

  /// Bodies were added or removed from outside, between two steps.
  /// \param world         the bodies now
  /// \param energy_added  [J] change of the total energy
  virtual void on_change(const World& world, double energy_added) {
    (void)world;
    (void)energy_added;
  }

  /// A collision has been resolved.
  /// \param event what happened
  virtual void on_event(const Event& event) { (void)event; }

  /// A step is complete.
  /// \param world   the bodies after it
  /// \param report  what was done
  virtual void on_step(const World& world, const StepReport& report) {
    (void)world;
    (void)report;
  }
};

}  // namespace tumble
