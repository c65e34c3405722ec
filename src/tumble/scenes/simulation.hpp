/// \file
/// \brief A scene that is being simulated: the one player of scenes.
#pragma once

#include "tumble/dynamics/technique.hpp"
#include "tumble/scenes/scene.hpp"
#include "tumble/techniques.hpp"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace tumble {

/// [s] The time step of scenes unless another one is given.
inline constexpr double kTimeStep = 1.0 / 60.0;

/// Checks the length of a step.
/// \param dt [s] above 0, at most tolerance::largest_value
/// \throws std::invalid_argument naming the value, for another one
void require_time_step(double dt);

/// A scene and the technique that steps it.
///
/// Boxes that appear later come in, and boxes that disappear go, before the first step that begins at their
/// time or after it. Boxes can be thrown in and taken away by hand as well; that is written into the scene,
/// with its time, so that a run of scene() with the same technique and the same steps goes through the same bits.
/// \verified{What was thrown and taken away is repeated by a run of the scene that is left}
class Simulation {
 public:
  /// Begins at time 0 with a technique that the simulation keeps.
  /// \param scene      the start
  /// \param technique  not null, and no step done yet
  /// \throws SceneMistake as checked() does
  Simulation(Scene scene, std::unique_ptr<Technique> technique);

  /// Begins at time 0 with a technique of the library.
  /// \param scene      the start
  /// \param technique  its name (`tumble techniques`)
  /// \param settings   changes of its options, each as key=value
  /// \param seed       random seed of the technique
  /// \throws std::invalid_argument for a name, a key or a value that does not exist
  /// \throws SceneMistake as checked() does
  explicit Simulation(Scene scene, std::string_view technique = kDefaultTechnique,
                      const std::vector<std::string>& settings = {}, std::uint64_t seed = 1);

  /// Begins at time 0 with a technique that belongs to the caller.
  /// \param scene      the start
  /// \param technique  no step done yet; has to live as long as the simulation
  /// \throws SceneMistake as checked() does
  Simulation(Scene scene, Technique& technique);

  /// Adds an observer. It gets on_begin() at once, and from then on events, changes and steps.
  /// \param observer  has to live as long as the simulation; called in the order in which they were added
  void observe(Observer& observer);
  /// Removes an observer.
  /// \param observer  nothing is done if it is none
  void stop_observing(const Observer& observer);

  /// Lets boxes enter and leave that are due now. Every step begins with it; call it to see them before.
  void settle();

  /// Simulates a step: lets boxes enter and leave that are due, then steps.
  /// \param dt [s] as require_time_step() takes it
  /// \return what the technique did; StepStatus::not_finite as well if a state is not finite after it
  /// \throws std::invalid_argument for another dt, or joints that the technique does not hold
  /// \throws StepRefused if the technique refuses the world or the step
  /// \throws StepFault if a part of the step fails, for example because a state has become infinite; it may have moved
  ///         bodies before
  StepReport step(double dt = kTimeStep);

  /// Simulates for a while; ends early after a step that was not solved or is not finite.
  /// \param seconds  [s] how long, to half a step
  /// \param dt       [s] as require_time_step() takes it
  /// \return the worst status of a step
  /// \throws std::invalid_argument as step()
  StepStatus run_for(double seconds, double dt = kTimeStep);

  /// Adds a box now. Before the first step it becomes part of the start, and may not overlap others.
  /// \param box  `appears` is set, and a name is given to it if it has none
  /// \return its name
  /// \throws SceneMistake naming the value that is wrong; nothing is changed then
  std::string throw_in(SceneBox box);

  /// Removes a box now. Before the first step the wishes about it go with it.
  /// \param name of a box that is there
  /// \throws std::invalid_argument if there is no such box, if it came in at this very time, or if it is
  ///         the last one of the start; nothing is done then but settle()
  void take_away(std::string_view name);

  /// A body, to be read.
  /// \param name its name
  /// \return its pose, velocities and energy; valid until bodies are added or removed
  /// \throws std::invalid_argument if there is no such body, with the closest name
  [[nodiscard]] BodyView body(std::string_view name) const { return world_.body(name); }

  /// The start that a run needs to get here.
  /// \return the scene with all that was thrown in and taken away
  [[nodiscard]] const Scene& scene() const { return scene_; }
  /// All bodies.
  /// \return as of the last step, and with what entered and left since
  [[nodiscard]] const World& world() const { return world_; }
  /// All bodies, to be pushed between steps. The scene does not record that.
  /// \return in and out
  [[nodiscard]] World& world() { return world_; }
  /// The technique.
  /// \return with its memory
  [[nodiscard]] const Technique& technique() const { return *technique_; }
  /// The technique.
  /// \return with its memory
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
  double settled_ = 0.0;  // [s] boxes that enter or leave up to this time have done so
  double before_ = 0.0;   // [s] the same when it was last done at another time
};

}  // namespace tumble
