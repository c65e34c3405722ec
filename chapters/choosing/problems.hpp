/// \file
/// \brief Three motions with closed forms, and how far a technique is off them.
#pragma once

#include "choosing/compared.hpp"
#include "driver/experiment.hpp"

namespace tumble::chapters {

// A motion whose path is known.
struct Problem {
  std::string name;                             // in a word
  Scene scene;                                  // start of the simulation
  int frames = 0;                               // how long, in frames of kComparedEvery
  double scale = 1.0;                           // errors are over it [as value]
  std::function<double(const World&)> value{};  // the compared value: a height, a way, an angle
  std::function<double(double)> exact{};        // the same at a time [s]
};

// [s] Paths are compared at multiples of it, which all steps reach.
inline constexpr double kComparedEvery = 1.0 / 30.0;

// A cube dropped flat that bounces three times.
//
// Height of its lower face. Between impacts it is \f$v t - g t^2/2\f$, and each leaves the share
// \f$e\f$ of the speed. Errors are over the height that it falls from.
Problem bounce_problem();

// A flat box that slides and stops.
//
// Its way is \f$v t - \mu g t^2/2\f$ until it has gone \f$v^2/(2 \mu g)\f$; errors are over that.
Problem slide_problem();

// A tall block that is released on its edge, until just before it is upright.
//
// It is a pendulum about its edge, and its tilt an elliptic function of time; errors are over the tilt
// at the start.
Problem rock_problem();

// All three.
std::array<Problem, 3> closed_problems();

// What came of one run of a problem.
struct Attempt {
  double error = kNoNumber;  // [-] largest over frames; none if the run did not reach its end
  StepReport totals;         // what it took
};

// Runs a problem.
Attempt attempt(const Problem& problem, const PlayedTechnique& played, int per_frame);

}  // namespace tumble::chapters
