/// \file
/// \brief A run: a scene, a technique, time steps, and files that say what happened.
#pragma once

#include "tumble/base/parameters.hpp"
#include "tumble/dynamics/technique.hpp"
#include "tumble/record/metrics.hpp"
#include "tumble/scenes/scene.hpp"

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

namespace tumble {

/// What a user asks a run to do.
struct RunSettings {
  double dt = 1.0 / 60.0;  ///< [s] time step; the last one is cut to end at the duration
  double duration = 10.0;  ///< [s] simulated time
  std::uint64_t seed = 1;  ///< of everything random
  int every = 1;           ///< record the trajectory at every so many steps
};

/// Checks settings before anything is made of them.
/// \param settings  what a user asks for
/// \throws std::invalid_argument naming the value: dt not above 0, duration below 0, every below 1,
///         10^12 steps or more
void require_valid(const RunSettings& settings);

/// How a run ended.
enum class RunEnd : std::uint8_t {
  complete,     ///< the whole duration was simulated
  interrupted,  ///< it was asked to stop
  failed        ///< a step ended with a status after which going on makes no sense
};

/// What a run came to.
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
  /// Why a later step than the first refused the world, for example because a state overflowed; empty
  /// if none did. The numbers above are of the step before, the hash of where that step stopped.
  std::string refusal;
};

/// Somebody who is told about a run as it goes: files, progress lines, experiments.
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
  /// \param metrics    what it came to
  virtual void on_step(const World& world, const Technique& technique, const StepReport& report,
                       const Metrics& metrics) {
    (void)world;
    (void)technique;
    (void)report;
    (void)metrics;
  }
  /// A collision was resolved.
  /// \param world  the bodies during the step, for their names
  /// \param event  what happened
  virtual void on_event(const World& world, const Event& event) {
    (void)world;
    (void)event;
  }
};

/// Runs a scene.
///
/// Boxes that appear later come in, and boxes that disappear go, before the first step that begins at
/// their time or after it. A step that leaves something unsolved or not finite is the last one, and so is
/// one, after the first, that the technique refuses: what was simulated before it is kept.
/// \param scene      what to start from
/// \param technique  how to step
/// \param settings   step, duration
/// \param observers  told in this order
/// \param stop       asked before every step; true ends the run as interrupted
/// \return how it ended and what it came to
/// \throws std::invalid_argument for settings out of range or a scene that the technique cannot
///         simulate, from its first step
/// \throws CannotWrite from an observer that writes; the technique is then watched by nobody, as
///         after every run
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
