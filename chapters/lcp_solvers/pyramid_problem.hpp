/// \file
/// \brief The contact problems that solvers are measured with: pyramids of cubes without friction.
#pragma once

#include "tumble/lcp_solvers/lcp.hpp"

#include <cstdint>

namespace tumble::chapters {

// A pyramid in one plane: unit cubes of 1 kg, 1.05 m from one to the next, each on two of the row
// below, with four contact points for each pair of faces and no friction.
//
// It is the smallest pyramid with that many contacts, k cubes in the lowest row for n = 4k². Pairs of
// faces are counted from the ground up and from left to right, and only the first n/4 of them are kept. With
// four points where three decide, A is singular: of n = 1024 rows 408 are independent, three for each cube.
struct PyramidProblem {
  LcpProblem problem;           // with factors; b = J (v + g dt)
  std::vector<Vec3> linear_w;   // [m/s] (cubes) v
  std::vector<Vec3> angular_w;  // [rad/s] (cubes) v, the turning
};

// The problem of n contacts, a multiple of 4, in a time step of 1/60 s; its b are velocities [m/s], f impulses
// [N s]. Each component of v and of the turning is drawn from [-noise, noise).
PyramidProblem pyramid_problem(int n, double noise, std::uint64_t seed);

// The problem of the next step: the cubes have been pushed, and gravity has worked again. They are taken
// to be where they were.
PyramidProblem next_step(const PyramidProblem& before, std::span<const double> f);

}  // namespace tumble::chapters
