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
  done,       ///< the whole step was simulated
  event_cap,  ///< the cap on events was reached, and the rest of the step ignored collisions
  energy_gained,  ///< the total energy is above that at the start; set by run_simulation(), see EnergyCheck
  passed_through,  ///< a body passed through another one; set by run_simulation(), see PassageCheck
  held_by_nothing,  ///< a body hung in the air; set by run_simulation(), see HangCheck and HitCheck
  unsolved,         ///< a solver found no solution
  not_finite        ///< a state became infinite or NaN
};

/// Energy that a step added (above 0) or removed (below 0), by cause. Any other change of the total energy is
/// the technique's energy error.
struct BookedEnergy {
  double restitution = 0.0;  ///< [J] normal impulses of collisions and contacts
  double friction = 0.0;     ///< [J] tangential impulses
  double damping = 0.0;      ///< [J] scaled or zeroed momenta, sleeping
  double repair = 0.0;       ///< [J] bodies moved to end their overlap

  /// \return [J] the sum
  [[nodiscard]] double total() const { return restitution + friction + damping + repair; }
};

/// The work of one step, counted. Techniques are compared by these counts, never by wall time.
struct StepReport {
  StepStatus status = StepStatus::done;  ///< how it ended
  std::int64_t events = 0;               ///< collisions resolved
  std::int64_t contacts = 0;             ///< contact points at the end
  std::int64_t iterations = 0;           ///< sweeps of iterative solvers
  std::int64_t pivots = 0;               ///< pivots of direct solvers
  std::int64_t impulses = 0;             ///< impulses applied
  std::int64_t pair_tests = 0;           ///< separation tests of two bodies
  std::int64_t integrations = 0;         ///< times that a body was advanced
  std::int64_t searches = 0;             ///< evaluations of event searches
  std::int64_t rewinds = 0;              ///< bodies put back in time
  std::int64_t restarts = 0;             ///< event searches begun again for a missed third body
  std::int64_t fallbacks = 0;            ///< uses of a substitute method, see the technique
  double deepest_overlap = 0.0;          ///< [m] largest penetration found, 0 or above
  BookedEnergy energy;                   ///< energy added and removed, by cause
};

/// A matrix from a failed step, to be written to a file and examined.
struct Diagnostic {
  std::string_view file;     ///< name of the file, for example "unsolved_A.mtx"
  std::string_view comment;  ///< meaning of the matrix, for the head of the file
  MatX matrix;               ///< the numbers
};

class Observer;

/// A method that advances a world by one time step.
///
/// It may keep memory between steps, such as impulses for a warm start. clone() copies the memory, so a snapshot of a
/// simulation is a copy of the world and a clone of the technique.
class Technique {
 public:
  virtual ~Technique() = default;

  /// The name in commands and files, for example "basic".
  [[nodiscard]] virtual std::string_view name() const = 0;

  /// Advances the world, and its time by World::finish_step(), once for the step or once for each part of it.
  /// \param dt     [s] above 0; may differ from step to step
  /// \throws std::invalid_argument for a dt that is not finite and above 0; StepRefused for a world that the
  ///         technique cannot simulate, or not with this dt, with the reason
  virtual StepReport step(World& world, double dt) = 0;

  /// A copy with all memory: from here on it makes the same steps, bit by bit.
  [[nodiscard]] virtual std::unique_ptr<Technique> clone() const = 0;

  /// The contact points of the last step; valid until the next step.
  [[nodiscard]] virtual std::span<const ContactRecord> contacts() const { return {}; }

  /// Matrices of a last step that ended as StepStatus::unsolved.
  /// \return empty after any other step, or if the technique keeps none
  [[nodiscard]] virtual std::vector<Diagnostic> diagnostics() const { return {}; }

  /// Physical effects of a world that this technique does not simulate.
  /// \return for example "friction"; empty if it simulates everything
  [[nodiscard]] virtual std::vector<std::string> ignores(const World& world) const {
    (void)world;
    return {};
  }

  /// Whether it simulates joints. A technique that does not refuses a world with joints, see require_joints_held().
  /// \return false unless overridden
  [[nodiscard]] virtual bool holds_joints() const { return false; }

  /// Sets the observer of collisions.
  /// \param observer  called during every step until changed; nullptr: none. Not owned
  void observe(Observer* observer) { observer_ = observer; }

  /// Lets the technique's sleeping rule, if it has one, treat some bodies as slow whatever their speed.
  /// \param bodies  by index, not 0 for such a body; empty: none. Not owned: has to outlive the steps
  void count_as_slow(std::span<const char> bodies) { slow_bodies_ = bodies; }

 protected:
  Technique() = default;
  /// For clone().
  Technique(const Technique& other) = default;
  /// For clone().
  Technique& operator=(const Technique& other) = default;

  /// The observer; nullptr: none.
  [[nodiscard]] Observer* observer() const { return observer_; }

  /// See count_as_slow(), by index, or empty.
  [[nodiscard]] std::span<const char> slow_bodies() const { return slow_bodies_; }

 private:
  std::span<const char> slow_bodies_;
  Observer* observer_ = nullptr;
};

/// Refuses a world with joints for a technique without joints. Simulation calls it before each step; a program that
/// calls Technique::step() itself should, too.
/// \throws std::invalid_argument naming the technique, a joint and a technique with joints
void require_joints_held(const Technique& technique, const World& world);

/// Observes a Simulation: collisions are reported by its technique, all else by the Simulation. RunObserver, for files
/// and progress, gets the metrics of each step as well.
class Observer {
 public:
  virtual ~Observer() = default;

  /// The simulation begins, or begins again because its start was changed.
  virtual void on_begin(const World& world) { (void)world; }

  /// Bodies were added or removed between two steps.
  /// \param energy_added  [J] change of the total energy by it
  virtual void on_change(const World& world, double energy_added) {
    (void)world;
    (void)energy_added;
  }

  /// A collision has been resolved.
  virtual void on_event(const Event& event) { (void)event; }

  /// A step is complete.
  virtual void on_step(const World& world, const StepReport& report) {
    (void)world;
    (void)report;
  }
};

}  // namespace tumble
