/// \file
/// \brief Structures at rest, and the verdicts of tests of their balance (thesis 5.4, 6.3.1).
#pragma once

#include "tumble/geometric_stability/static_equilibrium.hpp"

#include "driver/experiment.hpp"
#include "geometric_stability/resting_pile.hpp"

namespace tumble::chapters {

// The task of balancing the weights.
BalanceTask weights_of(const RestingPile& structure, int friction_edges = 0);

// Whether contact forces can hold a structure under its weight, by StaticEquilibrium.
bool balanced(const RestingPile& structure, int friction_edges = 0);

// The same without friction, as a test beside the next ones.
bool whole_stands(const RestingPile& structure);

// Whether a structure is all towers, and none of them tips, by Towers.
bool towers_stand(const RestingPile& structure);

// The simplest rule: whether each body's own centre is above its supports, whatever lies on it.
bool own_centres_stand(const RestingPile& structure);

// The next simplest rule: from the top down each body hands its load on at the middle of the area in which
// it touches the body below, or by the law of the lever at the middles of two areas. The centre of a body
// with its load has to be above its supports.
bool middles_stand(const RestingPile& structure);

// Where a verdict changes, by bisection until the two sides are neighbouring numbers.
// falls: [any] a value for which it is false
// holds: [any] a value for which it is true; above or below `falls`
// Returns [any] the last value found for which it is true; NaN if one of the two ends is not as said
double threshold(const std::function<bool(double)>& stands, double falls, double holds);

// Work of the same question asked in two ways: do the bodies accelerate?
struct BalanceWork {
  BalanceReport equilibrium;         // the test
  int pivots = 0;                    // of Baraff's method for the problem of contact forces
  std::int64_t multiplications = 0;  // of it; setting up its matrix is not counted
  double fastest = 0.0;              // [m/s²] largest acceleration of a centre by that problem
};

// Asks in both ways.
BalanceWork work_of(const RestingPile& structure);

// Whether a scene stays as it is when it runs.
// seconds: [s] for how long, in steps of 1/60 s; ends early if something has moved
bool stays(const RestingPile& scene, std::string_view technique,
           const std::vector<std::string>& settings, double seconds);

}  // namespace tumble::chapters
