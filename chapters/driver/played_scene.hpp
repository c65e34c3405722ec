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

// A technique and changes of its options.
struct PlayedTechnique {
  std::string name;                        // in the library, for example "damped"
  std::vector<std::string> settings = {};  // each as key=value
};

// A simulation at 60 steps a second in which every step has to succeed.
class PlayedScene : public Simulation {
 public:
  // Begins at time 0.
  PlayedScene(Scene start, const PlayedTechnique& played, std::uint64_t seed = 1)
      : Simulation(std::move(start), played.name, played.settings, seed) {}

  // Begins at time 0.
  PlayedScene(Scene start, std::unique_ptr<Technique> technique)
      : Simulation(std::move(start), std::move(technique)) {}

  // One step; boxes that are due then enter and leave after it.
  StepReport step();

  // Steps until a time.
  // time: [s] the end, to half a step
  void advance(double time, const std::function<void(const StepReport&)>& after = {});

  // The place of a body in the world's arrays.
  [[nodiscard]] std::size_t index(std::string_view name) const;

  // Its speed along x.
  // Returns [m/s]
  [[nodiscard]] double speed(std::string_view name) const;
};

// A scene of the library with some of its settings changed.
Scene scene_with(std::string_view name, const std::vector<std::string>& settings,
                 std::uint64_t seed = 1);

// A setting in the form of the command line.
std::string setting(std::string_view key, double value);

}  // namespace tumble::chapters
