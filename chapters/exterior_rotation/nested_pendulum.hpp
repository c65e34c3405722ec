/// \file
/// \brief The independent judge of figure 6.3: two hinged boxes with two angles, by GSL (thesis 6.2).
#pragma once

#include "tumble/dynamics/world.hpp"

namespace tumble::chapters {

// Two angles.
struct NestedAngles {
  double lower = 0.0;  // [rad] of the lower box, anticlockwise
  double upper = 0.0;  // [rad] of the upper box, anticlockwise
};

// The angles of a world.
NestedAngles nested_angles(const World& world);

// The motion of the boxes as a double pendulum.
//
// With the lower box's inertia about its edge, A, the upper one's about its own, C, the lever l of the
// moving edge and c of the upper centre, and \f$D = m_2\,l\cdot c\f$:
// \f[ A\ddot a + D\ddot b + D_b\dot b^2 = -V_a, \qquad C\ddot b + D\ddot a + D_a\dot a^2 = -V_b . \f]
// Prince and Dormand's method of order 8, to 1e-14.
// time: [s] from 0
NestedAngles nested_pendulum(const World& start, double time);

}  // namespace tumble::chapters
