/// \file
/// \brief A scene that is being simulated: step by step, with boxes thrown in and taken away.
#pragma once

#include "tumble/dynamics/technique.hpp"
#include "tumble/record/metrics.hpp"
#include "tumble/scenes/scene.hpp"

#include <string>
#include <string_view>

namespace tumble {

/// What run_scene() does at each step, for whoever wants to decide something between two steps.
///
/// Whatever is thrown or taken away is written into the scene as well, with its time. A run of that scene
/// with the same technique and the same steps goes through the same bits.
/// \verified{What was thrown and taken away is repeated by a run of the scene that is left}
class SceneRun {
 public:
  /// Begins at time 0.
  /// \param scene      what to start from
  /// \param technique  how to step, and no step done yet; not owned, it has to live as long as this
  /// \throws SceneMistake as checked() does
  SceneRun(Scene scene, Technique& technique);

  /// Lets boxes come and go that are due now. Whatever is done next begins with it anyway: for who wants
  /// to see them before it.
  void settle();

  /// Simulates a step: lets boxes come and go that are due, steps, and measures.
  /// \param dt [s] above 0
  /// \return what the technique did; StepStatus::not_finite as well if a state is not finite after it
  /// \throws std::invalid_argument if the technique refuses; it can have moved bodies before it does
  StepReport step(double dt);

  /// Adds a box now. Before the first step it is part of the start, and may not overlap others.
  /// \param box  `appears` is set, and a name is given to it if it has none
  /// \return its name
  /// \throws SceneMistake naming the value that is wrong; nothing is changed then
  std::string throw_in(SceneBox box);

  /// Takes a box away now.
  /// \param asked the name of a box that is there
  /// \throws std::invalid_argument if there is no such box, if it came in at this very time, or if it is
  ///         the last one of the start; nothing is done then but settle()
  void take_away(std::string_view asked);

  /// What a run would have to start from to get here.
  /// \return the scene with all that was thrown and taken away
  [[nodiscard]] const Scene& scene() const { return scene_; }
  /// All bodies.
  /// \return as of the last step, and what was thrown and taken away since
  [[nodiscard]] const World& world() const { return world_; }
  /// What the run has come to.
  /// \return after the last step
  [[nodiscard]] const Metrics& metrics() const { return metrics_; }

 private:
  void begin(Scene scene);

  Scene scene_;
  Technique& technique_;
  World world_;
  MetricsMeter meter_;
  Metrics metrics_;
  double settled_ = 0.0;  // [s] whoever comes or goes up to this time has done so
  double before_ = 0.0;   // [s] the same when it was last done at another time
};

}  // namespace tumble
