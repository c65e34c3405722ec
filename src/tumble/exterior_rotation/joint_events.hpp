/// \file
/// \brief Joints without glue: when they open, come apart and close (footnote of thesis 6.2).
///
/// Uses the chapter on analytic forces.
#pragma once

#include "tumble/exterior_rotation/joint_forces.hpp"

#include <span>

namespace tumble {

/// What has to change about a joint.
struct JointChange {
  int joint = -1;                       ///< its place; -1: nothing has to change
  JointHold hold = JointHold::nothing;  ///< what will be held
  int side = 0;                         ///< of an edge: which side of the area
};

/// A moment of a joint that pushes only, as a number that is below 0 once it has passed.
///
/// With very high friction and no glue an area holds as long as its force could come from pressure on
/// it. The moment of the pressure about each side of the area, inwards, is not negative then:
/// \f$\bigl((p - c_k)\times F + T\bigr)\cdot e_k \ge 0\f$ for the force F and the torque T at the held point
/// p, and a side from corner c_k along e_k. If one becomes negative, the centre of pressure has left the
/// area across that side, and the joint turns about it. An edge holds as long as it is pressed, and its
/// area closes again when the bodies have turned back. No friction is ever too small here.
/// \param joints  what is held
/// \param world   the bodies
/// \param moving  how they move, by index
/// \param forces  found for them
/// \param change  gets what has to change, if the answer is negative
/// \return the smallest of all numbers: moments over m g L, forces over m g and widths over L of the
///         joint's lighter body (1 m/s² for a g below that); 1 if nothing can change
double joint_margin(std::span<const Joint> joints, const World& world,
                    std::span<const MovingBody> moving, const JointForces& forces,
                    JointChange& change);

}  // namespace tumble
