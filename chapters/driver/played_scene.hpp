/// \file
/// \brief Simulations of built-in scenes for experiments: numbers that they share, settings, steps that have to finish.
#pragma once

#include "tumble/base/index.hpp"
#include "tumble/base/parameters.hpp"
#include "tumble/record/run.hpp"
#include "tumble/scenes/library.hpp"
#include "tumble/scenes/simulation.hpp"

#include "driver/csv.hpp"
#include "driver/statistics.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tumble::chapters {

inline constexpr double kGravity = 9.81;       // [m/s²] of the built-in scenes
inline constexpr double kStep = 1.0 / 60.0;    // [s] the thesis's: 60 frames a second
inline constexpr double kNearNothing = 1e-17;  // errors of 0 are drawn here on a logarithmic axis

// The report of a step of an experiment, which has to be done: the rest is no measurement.
// Throws std::runtime_error naming the status.
inline const StepReport& finished(const StepReport& report) {
  if (report.status != StepStatus::done)
    throw std::runtime_error("a step of this experiment ended as " +
                             std::string(name_of(report.status)));
  return report;
}

// The same where a step may end at its cap on events, and the experiment counts and shows those that do.
// Returns whether this one did.
inline bool ended_at_cap(const StepReport& report) {
  if (report.status == StepStatus::event_cap) return true;
  finished(report);
  return false;
}

// Changes several parameters.
inline void set_all(Parameters& parameters, const std::vector<std::string>& settings) {
  for (const std::string& setting : settings) parameters.assign(setting);
}

// How far the body has moved that has moved farthest [m].
inline double farthest_moved(std::span<const BodyState> from, std::span<const BodyState> to) {
  return largest_of(from, to, [](const BodyState& a, const BodyState& b) {
    return (b.position_w - a.position_w).norm();
  });
}

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
