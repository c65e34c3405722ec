/// \file
/// \brief Runs with fixed and adaptive sub-steps, when their bodies come to rest, and cubes thrown at a
///        thin plank (thesis 6.3.1).
#pragma once

#include "tumble/filtering/adaptive_step.hpp"

#include "driver/experiment.hpp"
#include "filtering/settled_run.hpp"

namespace tumble::chapters {

// The settings of a figure on adaptive steps.
Parameters adaptive_parameters(int seeds, int per_edge, int halvings);

// A run at 60 frames a second whose steps were divided, and what it took.
struct SteppedRun {
  SettledRun run;             // in contact in a frame: in any sub-step since the frame before
  StepReport work;            // all steps added up
  std::vector<int> substeps;  // by step, one fewer than there are frames
};

// Lets a scene play with divided steps, and records its frames.
// settling: [s] before bodies should rest
// watched: [s] after that, a multiple of half a second
SteppedRun settle_in_steps(const Scene& scene, std::unique_ptr<Technique> technique,
                           const AdaptiveStepOptions& options, double settling, double watched);

// Every step divided alike.
AdaptiveStepOptions fixed_steps(int halvings);

// How the bodies of a run come to rest, and how those shake that do.
//
// A body has come to rest when no corner of it ends a half second farther than a hundredth of the
// shortest edge from where it began it: this is what resting means to ChatterMeter, so that chatter
// does not keep a body from resting and creeping does. Its time of rest is the end of the last half
// second in which that was not so; a body that never rests has the end of the run. The time to rest of a
// run is when nine tenths of its bodies have come to rest: the last few of a clump may roll for
// long, and half of one lies on the ground soon.
struct RestingMeasures {
  std::vector<double> times;       // [s] of rest, by movable body, ascending
  std::vector<double> amplitudes;  // [m] of the bodies that rest while watched, ascending

  // Chatter as the claim has it.
  // Returns [m] median amplitude of the bodies that rest; 0 if none does
  [[nodiscard]] double chatter() const;
  // Another mean of it.
  // Returns [m] mean amplitude of the bodies that rest; 0 if none does
  [[nodiscard]] double mean_chatter() const;
  // When a share of the bodies has come to rest.
  // share: [-] above 0, up to 1
  // Returns [s]
  [[nodiscard]] double time_to_rest(double share = 0.9) const;
};

// Measures a run.
RestingMeasures measure_resting(const SettledRun& run);

// The share of the bodies that still move: those whose time of rest is not yet over.
// time: [s] of the frame
// Returns [-] 0 to 1
double share_moving(const RestingMeasures& measured, double time);

// Throws cubes of 0.2 m at a fixed plank of 0.05 m, from distances that differ by less than the way
// in a step, under `damped` at 60 steps a second.
// speed: [m/s] of the cube, above 0
// Returns [-] share of them that end behind the plank
double share_through(double speed, int throws, const AdaptiveStepOptions& options);

}  // namespace tumble::chapters
