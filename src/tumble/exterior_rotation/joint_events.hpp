/// \file
/// \brief Events of joints without glue: opening, separation and closing (footnote of thesis 6.2).
///
/// Uses the chapter on analytic forces.
#pragma once

#include "tumble/exterior_rotation/joint_forces.hpp"

#include <span>

namespace tumble {

/// A change of a joint.
struct JointChange {
  int joint = -1;                       ///< index of the joint; -1: no change
  JointHold hold = JointHold::nothing;  ///< degrees of freedom held from now on
  int side = 0;                         ///< of an edge: side of the area
};

/// Event function of joints that only push: negative once a joint must change.
///
/// With unlimited friction and no glue an area holds as long as pressure on it can produce the joint's force.
/// The moment of the pressure about each side of the area, inwards, is then not negative:
/// \f$\bigl((p - c_k)\times F + T\bigr)\cdot e_k \ge 0\f$ for the force F and the torque T at the held point
/// p, and a side from corner c_k along e_k. If one becomes negative, the centre of pressure has left the
/// area across that side, and the joint turns about it. An edge holds as long as it is under pressure, and
/// its area closes when the bodies have turned back. Friction is never exceeded.
/// \param moving  their motion, by index
/// \param forces  joint forces for that motion
/// \param change  receives the change, if the result is negative
/// \return the smallest of all values: moments over m g L, forces over m g and openings over L of the
///         joint's lighter body (1 m/s² for a g below that); 1 if nothing can change
double joint_margin(std::span<const Joint> joints, const World& world,
                    std::span<const MovingBody> moving, const JointForces& forces,
                    JointChange& change);

}  // namespace tumble
