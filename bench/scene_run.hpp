/// \file
/// \brief One engine on one scene: its steps, their times, and what came of it.
#pragma once

#include "scene_engines.hpp"
#include "scene_list.hpp"
#include "scene_quality.hpp"

#include <memory>
#include <string>
#include <vector>

namespace scene_bench {

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
