/// \file
/// \brief A run: a simulation of a given duration, measured and checked after each step.
#pragma once

#include "tumble/base/parameters.hpp"
#include "tumble/dynamics/technique.hpp"
#include "tumble/record/metrics.hpp"
#include "tumble/scenes/simulation.hpp"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace tumble {

/// Settings of a run.
struct RunSettings {
  double dt = kTimeStep;   ///< [s] time step; the last one is shortened to end at the duration
  double duration = 10.0;  ///< [s] simulated time
  std::uint64_t seed = 1;  ///< random seed of the scene and of the technique
  int every = 1;           ///< steps between two recorded frames, or rows of a table
};

/// Checks settings.
/// \throws std::invalid_argument naming the value: dt as require_time_step() refuses it, duration below 0, every below 1,
///         10^12 steps or more
void require_run_settings(const RunSettings& settings);

/// How a run ended.
enum class RunEnd : std::uint8_t {
  complete,     ///< the whole duration was simulated
  interrupted,  ///< `stop` ended it
  failed        ///< a step was unsolved, not finite, refused or broken off
};

/// The outcome of a run.
struct RunResult {
  RunEnd end = RunEnd::complete;        ///< how it ended
  StepStatus worst = StepStatus::done;  ///< the worst status of a step
  std::int64_t capped_steps = 0;        ///< steps with StepStatus::event_cap
  std::int64_t steps = 0;               ///< steps done
  double time = 0.0;                    ///< [s] simulated
  StepReport totals;                    ///< sums over all steps
  StepReport last_report;               ///< of the last step
  StepReport worst_report;              ///< the largest value of each count
  Metrics last;                         ///< after the last step; at the start if there was none
  Metrics worst_metrics;                ///< the value of each number that is farthest from 0
  std::string state_hash;               ///< 16 hexadecimal digits, of the last state
  /// The message of a step that broke off, or of one after the first that was refused; otherwise empty. The numbers
  /// above are those after the step before; the hash is of the state in which the step ended.
  std::string refusal;
  std::vector<std::string> findings;  ///< the first message of each RunCheck
};

/// Observes a run: files, progress lines, experiments. Unlike Observer it gets the metrics of each step.
class RunObserver {
 public:
  virtual ~RunObserver() = default;

  /// The run begins.
  virtual void on_begin(const World& world) { (void)world; }
  /// A step is complete.
  /// \param technique  to read its contacts
  /// \param metrics    energies, overlap and chatter after it
  virtual void on_step(const World& world, const Technique& technique, const StepReport& report,
                       const Metrics& metrics) {
    (void)world;
    (void)technique;
    (void)report;
    (void)metrics;
  }
  /// A check of the run has failed. The run goes on.
  /// \param message  step, time, body and the fault
  virtual void on_finding(const std::string& message) { (void)message; }
  /// A collision was resolved.
  /// \param world  the bodies during the step, to read their names
  virtual void on_event(const World& world, const Event& event) {
    (void)world;
    (void)event;
  }
};

/// Runs a simulation for the duration of its settings.
///
/// The checks of run_checks.hpp look at every step. If one fails, the status of the step is at least
/// StepStatus::energy_gained, and the run goes on. It ends after a step that is unsolved or not finite, and at one that
/// breaks off or, after the first, is refused.
/// \param simulation  no step done yet
/// \param settings    step, duration; valid, see require_run_settings()
/// \param observers   called in this order
/// \param stop        called before every step; true ends the run as interrupted
/// \throws StepRefused if the technique refuses the first step
/// \throws CannotWrite from an observer that writes
RunResult run_simulation(Simulation& simulation, const RunSettings& settings,
                         std::span<RunObserver* const> observers,
                         const std::function<bool()>& stop = {});

/// run_simulation() of a scene.
/// \param technique  no step done yet
/// \throws std::invalid_argument for settings out of range, or if the technique refuses the first step
/// \throws CannotWrite from an observer that writes; the technique has no observer then, as after every run
RunResult run_scene(const Scene& scene, Technique& technique, const RunSettings& settings,
                    std::span<RunObserver* const> observers,
                    const std::function<bool()>& stop = {});

/// The name of a step's status in files, for example "event_cap".
std::string_view name_of(StepStatus status);

/// The name of a run's end in files, for example "interrupted".
std::string_view name_of(RunEnd end);

}  // namespace tumble
