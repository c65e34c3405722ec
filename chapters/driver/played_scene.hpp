/// \file
/// \brief Simulations of built-in scenes for experiments.
#pragma once

#include "tumble/base/index.hpp"
#include "tumble/scenes/library.hpp"
#include "tumble/scenes/simulation.hpp"

#include "driver/common_numbers.hpp"
#include "driver/csv.hpp"
#include "driver/finished.hpp"
#include "driver/settings.hpp"

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
  StepReport step() {
    const StepReport report = finished(Simulation::step(kStep));
    update_boxes();
    return report;
  }

  // Steps until a time.
  // time: [s] the end, to half a step
  void advance(double time, const std::function<void(const StepReport&)>& after = {}) {
    while (world().time() < time - 0.5 * kStep) {
      const StepReport report = step();
      if (after) after(report);
    }
  }

  // The place of a body in the world's arrays.
  [[nodiscard]] std::size_t index(std::string_view name) const {
    return idx(world().index_of(name));
  }

  // Its speed along x [m/s].
  [[nodiscard]] double speed(std::string_view name) const { return body(name).velocity_w().x(); }
};

// A setting in the form of the command line.
inline std::string setting(std::string_view key, double value) {
  return std::string(key) + '=' + full_text(value);
}

}  // namespace tumble::chapters
