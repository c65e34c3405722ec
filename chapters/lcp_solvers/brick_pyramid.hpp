/// \file
/// \brief A flat pyramid of bricks as a problem of contact forces (thesis 2.6).
#pragma once

#include "tumble/analytic_lcp/assembly.hpp"

#include "driver/experiment.hpp"

namespace tumble::chapters {

// The support of a brick.
enum class Stand : std::uint8_t {
  feet,  // on two feet, a quarter of the spacing to the left and right of its middle
  faces  // flat: on the four corners of each area in which it touches
};

// A pyramid at rest: each brick lies over the gap between two of the row below.
struct BrickPyramid {
  World world;                     // the ground, then the bricks of 1 kg, row by row from below
  std::vector<MovingBody> bodies;  // how they are moved
  ContactList contacts;            // one for each pair of faces, sorted by the bodies' indices
  ContactProblem problem;          // of the forces at their points
};

// The sum of the forces between two faces.
struct Resultant {
  double force = 0.0;  // [N] their sum
  double place = 0.0;  // [m] where it acts, x in the world frame; 0 if there is no force
};

// A pyramid of bricks 1 m wide and 0.8 m high; spacing [m] from brick to brick in a row.
BrickPyramid make_brick_pyramid(int rows, double spacing, Stand stand);

// [N] The weight of one brick.
double weight_of_brick(const BrickPyramid& pyramid);

// One for each contact, from the forces f [N] of all rows.
std::vector<Resultant> resultants(const BrickPyramid& pyramid, std::span<const double> f);

}  // namespace tumble::chapters
