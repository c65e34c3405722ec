/// \file
/// \brief Contact problems for the claims on solvers: stacks of cubes, and chains of boxes that touch in
///        many points (thesis 2.6.2, 3.3.1, 5.3).
#pragma once

#include "tumble/base/random.hpp"
#include "tumble/lcp_solvers/lcp.hpp"

#include <vector>

namespace tumble::chapters {

// How bodies would accelerate without contact forces.
struct Load {
  Vec3 linear_w = Vec3::Zero();   // [m/s²] of the centre of mass
  Vec3 angular_w = Vec3::Zero();  // [rad/s²] of the body
};

// b = J times accelerations; it is in the range of J, so forces exist.
VecX constant_part(const LcpFactors& factors, const std::vector<Load>& loads);

// Unit cubes of 1 kg on top of each other, four corners to each joint. Three would do: of 4 rows 3 are
// independent. Rows 4k to 4k + 3 are under cube k.
LcpFactors stack_on_corners(int cubes);

// Variants of a chain of boxes.
struct ChainOptions {
  double heavy = 1.0;   // [-] mass of every second body over that of the others
  double needle = 1.0;  // [-] factor of inverse inertias about z
  bool repeat = false;  // whether every fifth contact is the one before once more
};

// A chain of boxes of 1 kg, each touched by the one before in points anywhere and in any direction, the
// first by something fixed. No contact depends on fewer than seven others of its box.
LcpProblem contact_chain(Random& random, int boxes, int contacts, const ChainOptions& options = {});

// Boxes that touch each other and something fixed anywhere, every third contact given once more.
LcpProblem repeated_contacts(Random& random);

}  // namespace tumble::chapters
