/// \file
/// \brief Arithmetic of IslandSolver: motions, impulses, cones and springs of contact patches.
#pragma once

#include "tumble/contact_patches/contact_patch.hpp"
#include "tumble/contact_patches/point_friction.hpp"
#include "tumble/math/rotation.hpp"
#include "tumble/math/sparse_blocks.hpp"

#include <cmath>

/// Arithmetic of IslandSolver.
namespace tumble::island_math {

/// Velocity and angular velocity in one vector.
inline Vec6 velocities_of(const MovingBody& body) {
  Vec6 v;
  v << body.velocity_w, body.angular_velocity_w;
  return v;
}

/// Motion of a patch's middle as a point of one of its bodies.
/// \param arm_w    [m] from the body's centre to the middle
/// \param v        [m/s], [rad/s] of the body
/// \return in the patch's frame
inline Six motion_of(const Mat3& frame_w, const Vec3& arm_w, const Vec6& v) {
  const Vec3 turn = frame_w.transpose() * v.tail<3>();
  const Vec3 move = frame_w.transpose() * (v.head<3>() + v.tail<3>().cross(arm_w));
  return {move[0], move[1], move[2], turn[0], turn[1], turn[2]};
}

/// Linear and angular impulse at a body's centre from an impulse at a patch's middle.
/// \param arm_w    [m] from the body's centre to the middle
/// \param impulse  [N s], [N m s] in the patch's frame
/// \return [N s], [N m s] world frame
inline Vec6 wrench_of(const Mat3& frame_w, const Vec3& arm_w, const Six& impulse) {
  Vec6 w;
  w.head<3>() = frame_w * Vec3(impulse[0], impulse[1], impulse[2]);
  w.tail<3>() = frame_w * Vec3(impulse[3], impulse[4], impulse[5]) + arm_w.cross(Vec3(w.head<3>()));
  return w;
}

/// Raises a maximum. A NaN stays, so that it is not taken for converged.
/// \param most   in and out
inline void raise(double value, double& most) {
  if (value > most || std::isnan(value)) most = value;
}

/// All springs of a patch as one at its middle. The motion of the middle is v - [r] w for a body with the arm r.
struct Spring {
  Mat3 force_of_move = Mat3::Zero();   ///< [N s / (m/s)] world frame
  Mat3 force_of_turn = Mat3::Zero();   ///< [N s / (rad/s)]
  Mat3 moment_of_turn = Mat3::Zero();  ///< [N m s / (rad/s)]

  /// The 6×6 block between the centres of two bodies, or of a body with itself.
  /// \param first_arm_w   [m] from the centre of the body that the force acts on to the middle
  /// \param second_arm_w  [m] from the centre of the body that moves
  /// \return force and moment of a unit velocity
  [[nodiscard]] Mat6 between(const Vec3& first_arm_w, const Vec3& second_arm_w) const {
    const Mat3 a = skew(first_arm_w);
    const Mat3 b = skew(second_arm_w);
    const Mat3 turned = force_of_turn - force_of_move * b;
    Mat6 k;
    k.topLeftCorner<3, 3>() = force_of_move;
    k.topRightCorner<3, 3>() = turned;
    k.bottomLeftCorner<3, 3>() = force_of_turn.transpose() + a * force_of_move;
    k.bottomRightCorner<3, 3>() = moment_of_turn - force_of_turn.transpose() * b + a * turned;
    return k;
  }
};

}  // namespace tumble::island_math
