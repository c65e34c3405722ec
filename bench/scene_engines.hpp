/// \file
/// \brief Interface of an engine for scenes.cpp, and the list of engines that can be measured.
#pragma once

#include "tumble/dynamics/technique.hpp"
#include "tumble/dynamics/world.hpp"

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

// Whole scenes, measured.
namespace scene_bench {

// Something that moves the bodies of a world: a technique of ours, or another engine.
//
// The world is the common ground: all engines start from it, and their poses are written back
// into it, so that one routine can measure all of them.
class Engine {
 public:
  virtual ~Engine() = default;

  // Takes in the bodies that have been added to the world since the last call. Not timed.
  virtual void take_in(const tumble::World& world) = 0;

  // Moves its bodies. This alone is timed: collision detection and all.
  // dt: [s] the step
  virtual void advance(tumble::World& world, double dt) = 0;

  // Writes poses and velocities into the world and counts the step. Not timed.
  // dt: [s] the step that was made
  virtual bool write_back(tumble::World& world, double dt) = 0;

  // How many bodies sleep.
  [[nodiscard]] virtual int asleep(const tumble::World& world) const = 0;

  // What a reader must know about the run.
  [[nodiscard]] virtual std::string note() const { return {}; }

  // Whether the last step cannot be followed by another one.
  [[nodiscard]] virtual bool failed() const { return false; }

 protected:
  Engine() = default;
  Engine(const Engine&) = default;
  Engine& operator=(const Engine&) = default;
};

// An engine that can be asked for.
struct EngineChoice {
  std::string name;        // as a user writes it and as it is printed
  int substeps = 1;        // its steps in one step of the scene
  int most_boxes = 0;      // not run on larger scenes unless asked for; 0: on all
  bool standard = false;   // whether it runs when none is asked for
  bool reference = false;  // whether ratios are to this one
  // Makes it. `sleeping`: whether bodies may fall asleep. nullptr: it has no such setting.
  std::function<std::unique_ptr<Engine>(const tumble::World& world, bool sleeping)> make;
};

// A technique of ours.
EngineChoice technique_choice(std::string_view text);

// Our techniques that run when none is asked for: the fast ones, or else all that move boxes.
std::vector<EngineChoice> standard_techniques();

// The engines that were found at build time, in their settings (scene_peers.cpp).
std::vector<EngineChoice> peer_choices();

// Which engines were found, in what version and precision.
std::string peer_versions();

}  // namespace scene_bench
