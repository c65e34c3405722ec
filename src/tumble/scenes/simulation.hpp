/// \file
/// \brief The simulation of a scene by a technique.
#pragma once

#include "tumble/dynamics/technique.hpp"
#include "tumble/scenes/scene.hpp"
#include "tumble/techniques.hpp"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace tumble {

/// [s] The default time step.
inline constexpr double kTimeStep = 1.0 / 60.0;

/// Checks the length of a step.
/// \param dt [s] from tolerance::shortest_step to longest_step
/// \throws std::invalid_argument naming the value, for another one
void require_time_step(double dt);

/// The world of a scene and the technique that steps it.
///
/// A box that appears or disappears later does so before the first step that begins at its time or after it, up to
/// due_until(). A program can add and remove boxes as well, by throw_in() and take_away(): these are written into the
/// scene with their time, so that simulating scene() again with the same technique and the same steps gives the
/// same bits, as long as no step is a thousand times shorter than the one before.
/// \verified{What was thrown and taken away is repeated by a run of the scene that is left}
class Simulation {
 public:
  /// Begins at time 0 with a technique of its own.
  /// \param technique  not null, and no step done yet
  /// \throws SceneMistake as checked() does
  Simulation(Scene scene, std::unique_ptr<Technique> technique);

  /// Begins at time 0 with a technique of the library.
  /// \param settings   its options that differ from their defaults, each as key=value
  /// \throws std::invalid_argument for a name, a key or a value that does not exist
  /// \throws SceneMistake as checked() does
  explicit Simulation(Scene scene, std::string_view technique = kDefaultTechnique,
                      const std::vector<std::string>& settings = {}, std::uint64_t seed = 1);

  /// Begins at time 0 with a technique that the caller owns.
  /// \param technique  no step done yet; has to live as long as the simulation
  /// \throws SceneMistake as checked() does
  Simulation(Scene scene, Technique& technique);

  /// Adds an observer. It gets on_begin() at once, and from then on events, changes and steps.
  /// \param observer  has to live until stop_observing() or the end of the simulation; called in the order of adding
  void observe(Observer& observer);
  /// Removes an observer.
  /// \param observer  if it was not added, nothing is done
  void stop_observing(const Observer& observer);

  /// Adds and removes the boxes that appear or disappear by now. step() begins with it; call it to see them before.
  void update_boxes();

  /// Simulates one step: update_boxes(), then the technique's step.
  /// \param dt [s] as require_time_step() takes it
  /// \return the technique's report, with StepStatus::not_finite if a state is not finite after it
  /// \throws std::invalid_argument for another dt, also if require_step_limits() does not take it at this time, or for
  ///         joints that the technique does not support
  /// \throws StepRefused if the technique refuses the world or the step
  /// \throws StepFault if a part of the step fails, for example because a state has become infinite; bodies may have
  ///         moved by then
  StepReport step(double dt = kTimeStep);

  /// Simulates several steps; ends early after one with StepStatus::unsolved or not_finite.
  /// \param seconds  [s] how long, rounded to whole steps
  /// \param dt       [s] as require_time_step() takes it
  /// \return the worst status of a step
  /// \throws std::invalid_argument as step()
  StepStatus run_for(double seconds, double dt = kTimeStep);

  /// Adds a box now. Before the first step it becomes part of the start, where it may not overlap others.
  /// \param box  its `appears` becomes the time now; if it has no name, it gets one
  /// \throws SceneMistake naming the value that is wrong; nothing is changed then
  std::string throw_in(SceneBox box);

  /// Removes a box now. Before the first step its wishes and joints are removed as well.
  /// \param name of a box in the world
  /// \throws std::invalid_argument if there is no such box, if it was added at this very time, or if it is
  ///         the last one of the start; nothing is done then but update_boxes()
  void take_away(std::string_view name);

  /// A body, to be read.
  /// \return its pose, velocities and energy; valid until bodies are added or removed
  /// \throws std::invalid_argument if there is no such body, with the closest name
  [[nodiscard]] BodyView body(std::string_view name) const { return world_.body(name); }

  /// The scene which, simulated from its start, leads to the present state.
  /// \return the start, with the boxes that were added and removed since
  [[nodiscard]] const Scene& scene() const { return scene_; }
  /// \return all bodies as they are now
  [[nodiscard]] const World& world() const { return world_; }
  /// All bodies, to be changed between steps. The scene does not record such changes.
  /// \return in and out
  [[nodiscard]] World& world() { return world_; }
  /// \return the technique, with its memory
  [[nodiscard]] const Technique& technique() const { return *technique_; }
  /// \return the technique, with its memory
  [[nodiscard]] Technique& technique() { return *technique_; }

 private:
  void begin(Scene scene);
  template <class Change>
  void change_bodies(const Change& change);

  Scene scene_;
  std::unique_ptr<Technique> owned_;
  Technique* technique_;
  World world_;
  std::vector<Observer*> observers_;
  double last_dt_ = 0.0;  // [s] length of the last step
  double updated_ = 0.0;  // [s] up to when the last update_boxes() went
  double earlier_ = 0.0;  // [s] the same for the last one before that time
};

}  // namespace tumble
