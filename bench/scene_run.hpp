/// \file
/// \brief One engine on one scene: its steps, their times, and what came of it.
#pragma once

#include "tumble/dynamics/world.hpp"
#include "tumble/record/chatter.hpp"

#include "scene_engines.hpp"
#include "scene_list.hpp"

#include <deque>
#include <memory>
#include <string>
#include <vector>

namespace scene_bench {

// What the last second of a run looks like.
struct Quality {
  double overlap = 0.0;     // [m] deepest, over all pairs, the ground too, and all steps
  double speed = 0.0;       // [m/s] root mean square over bodies and steps, from pose to pose
  double drift = 0.0;       // [m] largest distance of a centre from its start, at the end
  double sag = 0.0;         // [m] how far the highest bodies of the start sank at most, at the end
  tumble::Chatter chatter;  // over the last half second
  bool stands = true;       // no box is further than half its shortest edge from its start
};

// Keeps the poses of the last second of a run, to be measured after it.
class Recording {
 public:
  // Takes in new bodies: where they are now is their start.
  void take_in(const tumble::World& world);

  // Keeps a copy of the poses after a step.
  // dt: [s] the step
  void add(const tumble::World& world, double dt);

  // Measures what was kept.
  //
  // Overlap and chatter are those of record/metrics.hpp: the least translation over the 15 axes
  // that parts two boxes, the depth of the lowest corner under the ground, and the way of the
  // corners of bodies that rest.
  [[nodiscard]] Quality measure(const tumble::World& world) const;

 private:
  struct Frame {
    double dt = 0.0;  // [s] since the frame before
    std::vector<tumble::BodyState> states;
  };
  std::vector<tumble::Vec3> start_w_;  // [m] centres, by index
  std::deque<Frame> frames_;           // ascending in time
  double kept_ = 0.0;                  // [s] from the first frame to the last
};

// [s] The step of all scenes.
inline constexpr double kStep = 1.0 / 60.0;

// What a table says about a run.
struct Outcome {
  std::string engine;           // its name
  int steps = 0;                // of 1/60 s, that were made
  int wanted = 0;               // steps of the whole scene
  int boxes = 0;                // at the end
  double median_ms = 0.0;       // [ms] of the steps after the first 10
  double p99_ms = 0.0;          // [ms] of the same, 99 % are faster
  double total_s = 0.0;         // [s] of all steps
  double awake_ms = 0.0;        // [ms] median of the same while no body sleeps; 0: there was none
  double last_second_ms = 0.0;  // [ms] median over the last second
  int asleep = 0;               // bodies that sleep at the end
  bool finite = true;           // whether there is something to measure
  Quality quality;              // of the last second
  std::string note;             // what a reader must know; may be empty
};

// A run that is made piece by piece, so that engines can take turns.
class Run {
 public:
  // Puts the start of a scene before an engine.
  // budget: [s] of step time after which the run is cut
  Run(const EngineChoice& choice, const SceneChoice& scene, double budget);

  // Whether the engine can do what the scene asks for.
  [[nodiscard]] bool possible() const { return engine_ != nullptr; }

  // Goes on.
  bool advance(int steps);

  // Sums up.
  [[nodiscard]] Outcome outcome() const;

 private:
  void step();

  std::string name_;
  int substeps_;
  const SceneChoice& scene_;
  double budget_;
  tumble::World world_;
  std::unique_ptr<Engine> engine_;
  Recording recording_;
  std::vector<double> ms_;   // of each step
  std::vector<char> awake_;  // of each step: whether no body slept after it
  int wanted_;
  double entered_ = 0.0;  // [s] boxes that appear up to this time are in the world
  double total_ = 0.0;    // [s]
  bool finite_ = true;
  std::string end_;  // why the run ended before its time
};

}  // namespace scene_bench
