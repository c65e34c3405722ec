/// \file
/// \brief Simulations of built-in scenes for experiments.
#pragma once

#include "tumble/scenes/simulation.hpp"

#include "driver/common_numbers.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tumble::chapters {

/// A technique and changes of its options.
struct PlayedTechnique {
  std::string name;                        ///< in the library, for example "damped"
  std::vector<std::string> settings = {};  ///< each as key=value
};

/// A simulation at 60 steps a second in which every step has to succeed.
class PlayedScene : public Simulation {
 public:
  /// Begins at time 0.
  /// \param start   the scene
  /// \param played  the technique
  /// \param seed    random seed of the technique
  /// \throws std::invalid_argument for a name, a key or a value that does not exist
  PlayedScene(Scene start, const PlayedTechnique& played, std::uint64_t seed = 1)
      : Simulation(std::move(start), played.name, played.settings, seed) {}

  /// Begins at time 0.
  /// \param start      the scene
  /// \param technique  no step done yet
  PlayedScene(Scene start, std::unique_ptr<Technique> technique)
      : Simulation(std::move(start), std::move(technique)) {}

  /// One step; boxes that are due then enter and leave after it.
  /// \return the technique's report
  /// \throws std::runtime_error if the step was not solved or a state is not finite
  StepReport step();

  /// Steps until a time.
  /// \param time   [s] the end, to half a step
  /// \param after  called after each step with its report
  void advance(double time, const std::function<void(const StepReport&)>& after = {});

  /// The place of a body in the world's arrays.
  /// \param name  in the scene
  /// \return its index
  /// \throws std::invalid_argument if there is none of this name by now
  [[nodiscard]] std::size_t index(std::string_view name) const;

  /// Its speed along x.
  /// \param name  in the scene
  /// \return [m/s]
  [[nodiscard]] double speed(std::string_view name) const;
};

/// A scene of the library with some of its settings changed.
/// \param name      for example "fig5_2"
/// \param settings  each as key=value
/// \param seed      random seed of the scene
/// \return the scene
/// \throws std::invalid_argument for a name, a key or a value that does not exist
Scene scene_with(std::string_view name, const std::vector<std::string>& settings,
                 std::uint64_t seed = 1);

/// A setting in the form of the command line.
/// \param key    its name
/// \param value  any finite number
/// \return key=value with 17 significant digits
std::string setting(std::string_view key, double value);

}  // namespace tumble::chapters
