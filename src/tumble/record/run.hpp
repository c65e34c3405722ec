/// \file
/// \brief A run: a simulation from its start to its end, with its numbers and observers.
#pragma once

#include "tumble/base/parameters.hpp"
#include "tumble/dynamics/technique.hpp"
#include "tumble/record/metrics.hpp"
#include "tumble/scenes/simulation.hpp"

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace tumble {

/// Settings of a run.
struct RunSettings {
  double dt = 1.0 / 60.0;  ///< [s] time step; the last one is cut to end at the duration
  double duration = 10.0;  ///< [s] simulated time
  std::uint64_t seed = 1;  ///< random seed of the scene and of the technique
  int every = 1;  ///< steps from one recorded frame to the next, and from one row of a table
};

/// Checks settings before anything is made of them.
/// \param settings  what a user asks for
/// \throws std::invalid_argument naming the value: dt as require_time_step() refuses it, duration below 0, every below 1,
///         10^12 steps or more
void require_valid(const RunSettings& settings);

/// How a run ended.
enum class RunEnd : std::uint8_t {
  complete,     ///< the whole duration was simulated
  interrupted,  ///< it was asked to stop
  failed        ///< a step ended with a status after which going on makes no sense
};

/// The outcome of a run.
struct RunResult {
  RunEnd end = RunEnd::complete;        ///< how it ended
  StepStatus worst = StepStatus::done;  ///< the worst status of a step
  std::int64_t capped_steps = 0;        ///< steps that ended at the event cap
  std::int64_t steps = 0;               ///< steps done
  double time = 0.0;                    ///< [s] simulated
  StepReport totals;                    ///< counts of all steps added up
  StepReport last_report;               ///< of the last step
  StepReport worst_report;              ///< each count where it was largest
  Metrics last;                         ///< after the last step; at the start if there was none
  Metrics worst_metrics;                ///< each number where it was farthest from 0
  std::string state_hash;               ///< 16 hexadecimal digits, of the last state
  /// Why a step broke off, or a later one than the first was refused, for example because a state overflowed; empty
  /// if none did. The numbers above are of the step before, the hash of where that step stopped.
  std::string refusal;
  std::vector<std::string>
      findings;  ///< of the checks of every step, see RunCheck: the first of each
};

/// Follows a run as it goes: files, progress lines, experiments.
class RunObserver {
 public:
  virtual ~RunObserver() = default;

  /// The run begins.
  /// \param world the bodies at time 0
  virtual void on_begin(const World& world) { (void)world; }
  /// A step is complete.
  /// \param world      the bodies after it
  /// \param technique  for its contacts
  /// \param report     what it did
  /// \param metrics    energies, overlap and chatter after it
  virtual void on_step(const World& world, const Technique& technique, const StepReport& report,
                       const Metrics& metrics) {
    (void)world;
    (void)technique;
    (void)report;
    (void)metrics;
  }
  /// A check has found something, and the run goes on.
  /// \param message  step, time, body and the fault
  virtual void on_finding(const std::string& message) { (void)message; }
  /// A collision was resolved.
  /// \param world  the bodies during the step, for their names
  /// \param event  what happened
  virtual void on_event(const World& world, const Event& event) {
    (void)world;
    (void)event;
  }
};

/// Runs a simulation from its start to its end.
///
/// The checks of run_checks.hpp watch every step; one that fails has a status of at least StepStatus::energy_gained,
/// and the run goes on. A step that leaves something unsolved or not finite is the last one, and so is one that breaks off, or that,
/// after the first, the technique refuses: the result has what was simulated before it.
/// \param simulation  no step done yet
/// \param settings    step, duration; valid, see require_valid()
/// \param observers   called in this order
/// \param stop        asked before every step; true ends the run as interrupted
/// \return how it ended, and its numbers
/// \throws StepRefused for a scene that the technique cannot simulate, or not with this step, from its first step
/// \throws CannotWrite from an observer that writes
RunResult run(Simulation& simulation, const RunSettings& settings,
              std::span<RunObserver* const> observers, const std::function<bool()>& stop = {});

/// Runs a scene, as run() does.
/// \param scene      the start
/// \param technique  how to step
/// \param settings   step, duration
/// \param observers  called in this order
/// \param stop       asked before every step; true ends the run as interrupted
/// \return how it ended, and its numbers
/// \throws std::invalid_argument for settings out of range or a scene that the technique cannot
///         simulate, from its first step
/// \throws CannotWrite from an observer that writes; the technique has no observer then, as after every run
RunResult run_scene(const Scene& scene, Technique& technique, const RunSettings& settings,
                    std::span<RunObserver* const> observers,
                    const std::function<bool()>& stop = {});

/// The name of a step's status in files.
/// \param status the status
/// \return for example "event_cap"
std::string_view name_of(StepStatus status);

/// The name of a run's end in files.
/// \param end the end
/// \return for example "interrupted"
std::string_view name_of(RunEnd end);

}  // namespace tumble
