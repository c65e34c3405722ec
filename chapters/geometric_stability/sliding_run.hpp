/// \file
/// \brief The upper box of figure 5.4 slides off the lower one, step by step (thesis 5.4).
#pragma once

#include "driver/experiment.hpp"

namespace tumble::chapters {

// The technique under which it slides.
enum class Slider {
  damped,            // damped integration, stable boxes marked by their corners
  damped_unmarked,   // the same, no box is marked
  analytic_damping,  // `analytic`, damping in place of friction, stable boxes left out
  analytic_free      // `analytic` without friction, stable boxes left out
};

// One run.
struct SlideSetup {
  Slider slider = Slider::damped;  // see there
  double offset = 0.0;             // [m] of the upper box from the middle at the start, along x
  double speed = 0.0;              // [m/s] of the upper box at the start, along x
  double scale = 1.0;              // [-] of all lengths, the offset and the speed
  double k_scale = 1.0;            // [-] damped integration: all its factors are raised to it
  int steps = 60;                  // of 1/60 s
};

// A step of the upper box.
struct SlideStep {
  double speed = 0.0;     // [m/s] along x at its end
  double overhang = 0.0;  // [m] of the foremost lower corner beyond the edge at its end; below 0:
                          // before it
  bool counted_stable = false;  // whether it was taken for stable within the step
  bool slowed = false;          // whether it slid, and damping took some of its speed
};

// A run and its states.
struct SlideRun {
  std::vector<SlideStep> steps;  // all of them
  std::vector<World> worlds;     // the start, and after each step
  int leaves = -1;  // which step takes the foremost lower corner beyond the edge; -1: none

  // Number of steps until a corner leaves its support, that one included.
  [[nodiscard]] int until() const { return leaves + 1; }

  // Number of them in which the box is stable, slides, and is slowed down by damping.
  [[nodiscard]] int counted() const;
};

// The bodies that are stable by their corners, with the tolerances of damped integration.
std::vector<char> stable_by_corners(const World& world);

// The speed of the upper box [m/s], along x.
double speed_of_upper(const World& world);

// Simulates it.
SlideRun slide(const SlideSetup& setup);

// Largest distance beyond the edge at which damped integration still holds the centre of the upper box up,
// level, after some time.
// seconds: [s] how long it is looked at
// Returns [m] by bisection to a millimetre
double held_overhang(double seconds);

}  // namespace tumble::chapters
