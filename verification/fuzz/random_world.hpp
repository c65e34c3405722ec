/// \file
/// \brief Random worlds of a few boxes, and a judge that knows nothing about how a technique works.
#pragma once

#include "tumble/dynamics/technique.hpp"
#include "tumble/scenes/scene.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace tumble::fuzz {

// The range from which a random world is drawn.
struct WorldRange {
  int least_boxes = 2;       // boxes, at least
  int most_boxes = 8;        // boxes, at most
  double mass_ratio = 1e6;   // [-] largest mass over smallest mass, at most
  double edge_ratio = 25.0;  // [-] longest edge over shortest edge, at most
  double most_turn = 0.3;    // [rad] turn of a body in a step at the start, at most
  double most_travel =
      0.3;  // [-] way of a body in a step at the start, as a share of its shortest edge
  double restitution = 1.0;  // [-] largest coefficient
};

// A scene and the step with which it is run.
struct RandomWorld {
  Scene scene;             // boxes that do not overlap
  double dt = 1.0 / 60.0;  // [s]
};

// Draws a world: boxes that are stacked or fly, with or without ground and gravity.
RandomWorld random_world(std::uint64_t seed, const WorldRange& range = {});

// The outcome of a run.
struct WorldVerdict {
  StepStatus status = StepStatus::done;  // of the worst step
  bool finite = true;                    // all states, after each step
  // [-] largest rise of the energy above the start, as a share of its scale: kinetic energy plus the sum of
  // m g L
  double energy_rise = 0.0;
  double unbooked_rise = 0.0;  // [-] the same of the energy less what the technique has booked
  double momentum_change =
      0.0;  // [-] of a world without ground or gravity, over the sum of |m v| at the start
  double overlap = 0.0;  // [-] deepest one of two boxes at the end, as a share of the shortest edge
  bool reported = false;    // a run would have ended with code 3
  std::string thrown = {};  // message of an exception; empty if there was none
};

// What is promised of random worlds beyond states that are finite and no exception, see promises.md.
struct WorldPromise {
  std::string_view technique;
  double momentum;  // [-] largest change without ground and gravity; infinite: none is promised
  double unbooked;  // [-] largest rise of the energy that is not booked, ditto
  double overlap;   // [-] deepest one at the end, ditto
};

// The promise of a technique; of one that there is not: none.
WorldPromise promise_of(std::string_view technique);

// Runs a world and judges every step.
WorldVerdict judge(const RandomWorld& world, std::string_view technique,
                   const std::vector<std::string>& settings = {}, int steps = 60);

}  // namespace tumble::fuzz
