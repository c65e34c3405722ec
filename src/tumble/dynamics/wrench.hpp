/// \file
/// \brief Force and moment on a body, and their effect on its motion.
#pragma once

#include "tumble/base/types.hpp"

namespace tumble {

/// What acts on a body.
struct Wrench {
  Vec3 force_w = Vec3::Zero();   ///< [N] world frame
  Vec3 torque_w = Vec3::Zero();  ///< [N m] about the centre of mass, world frame
};

/// How the motion of a body changes.
struct Acceleration {
  Vec3 linear_w = Vec3::Zero();   ///< [m/s²] of the centre of mass, world frame
  Vec3 angular_w = Vec3::Zero();  ///< [rad/s²] world frame
};

}  // namespace tumble
