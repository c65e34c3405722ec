/// \file
/// \brief Contact problems for the claims on solvers: stacks of cubes, and chains of boxes that touch in
///        many points (thesis 2.6.2, 3.3.1, 5.3).
#pragma once

#include "tumble/base/random.hpp"
#include "tumble/lcp_solvers/lcp.hpp"

#include <vector>

namespace tumble::chapters {

/// How bodies would accelerate without contact forces.
struct Load {
  Vec3 linear_w = Vec3::Zero();   ///< [m/s²] of the centre of mass
  Vec3 angular_w = Vec3::Zero();  ///< [rad/s²] of the body
};

/// The constant part of a problem that comes from loads: b = J times accelerations.
/// \param factors  the contacts
/// \param loads    one for each body
/// \return [m/s²] one for each contact; in the range of J, so that forces exist which hold it
VecX constant_part(const LcpFactors& factors, const std::vector<Load>& loads);

/// Unit cubes of 1 kg on top of each other, four corners to each joint. Three would do: of 4 rows 3 are
/// independent.
/// \param cubes  how many; the lowest stands on the ground
/// \return the contacts from below upwards: rows 4k to 4k + 3 are under cube k
LcpFactors stack_on_corners(int cubes);

/// A chain of boxes of 1 kg, each touched by the one before in points anywhere and in any direction, the
/// first by something fixed. No contact depends on fewer than seven others of its box.
/// \param random    places and directions
/// \param boxes     how many
/// \param contacts  on each, with the one before
/// \return a problem whose b comes from accelerations of up to 10 m/s² and 10 rad/s²
LcpProblem contact_chain(Random& random, int boxes, int contacts);

/// Boxes that touch each other and something fixed anywhere, every third contact given once more.
/// \param random  places and directions
/// \return a problem with 1 to 4 boxes and 1 to 24 contacts, b as above
LcpProblem repeated_contacts(Random& random);

}  // namespace tumble::chapters
