/// \file
/// \brief A built-in scene under a technique of the library, step by step.
#pragma once

#include "tumble/scenes/scene.hpp"
#include "tumble/techniques.hpp"

#include "driver/common_numbers.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace tumble::chapters {

/// A technique and what is changed of its options.
struct PlayedTechnique {
  std::string name;                        ///< in the library, for example "damped"
  std::vector<std::string> settings = {};  ///< each as key=value
};

/// A scene that is being simulated at 60 steps a second.
struct PlayedScene {
  Scene scene;                           ///< what it began with
  World world;                           ///< as it is now
  std::unique_ptr<Technique> technique;  ///< how it goes on

  /// Builds the world of a scene.
  /// \param start   the scene
  /// \param played  the technique
  /// \param seed    of chance in the technique
  /// \throws std::invalid_argument for a name, a key or a value that there is not
  PlayedScene(Scene start, const PlayedTechnique& played, std::uint64_t seed = 1);

  /// One step; boxes whose time has come enter after it.
  /// \return what the technique reports
  /// \throws std::runtime_error if the step was not solved or a state is not finite
  StepReport step();

  /// Steps until a time.
  /// \param time   [s] when to stop, to half a step
  /// \param after  called after each step with its report
  void advance(double time, const std::function<void(const StepReport&)>& after = {});

  /// A body that moves.
  /// \param name  as the scene calls it
  /// \return its index in the world
  /// \throws std::invalid_argument if there is none of this name by now
  [[nodiscard]] std::size_t index(std::string_view name) const;

  /// Its speed along x.
  /// \param name  as the scene calls it
  /// \return [m/s]
  [[nodiscard]] double speed(std::string_view name) const;
};

/// A scene of the library with some of its settings changed.
/// \param name      for example "fig5_2"
/// \param settings  each as key=value
/// \param seed      of chance in the scene
/// \return the scene
/// \throws std::invalid_argument for a name, a key or a value that there is not
Scene scene_with(std::string_view name, const std::vector<std::string>& settings,
                 std::uint64_t seed = 1);

/// A setting as a command line has it.
/// \param key    its name
/// \param value  any finite number
/// \return key=value with 17 significant digits
std::string setting(std::string_view key, double value);

}  // namespace tumble::chapters
