/// \file
/// \brief The single rotation that keeps the nested boxes of figure 6.3 together best (claim 6.2c).
#pragma once

#include "tumble/contact/pivot_update.hpp"
#include "tumble/dynamics/advance_pose.hpp"
#include "tumble/exterior_rotation/joint.hpp"

#include "driver/experiment.hpp"

namespace tumble::chapters {

// A frame of reference for a whole group, turning about a point.
struct GroupFrame {
  Vec3 centre_w = Vec3::Zero();            // [m] c
  Vec3 angular_velocity_w = Vec3::Zero();  // [rad/s] Omega
};

// All states after the step, given where the centre of a movable body goes.
template <class Centre>
std::vector<BodyState> moved(const World& world, double dt, const Centre& centre) {
  std::vector<BodyState> states(world.states().begin(), world.states().end());
  for (std::size_t k = 0; k < states.size(); ++k) {
    const BodyProperties& body = world.bodies()[k];
    if (!body.movable()) continue;
    const Vec3 v_w = velocity(body, states[k]);
    const Vec3 omega_w = angular_velocity(body, states[k]);
    states[k].position_w = centre(states[k].position_w, v_w, omega_w);
    states[k].orientation_wb = tumble::turned(states[k].orientation_wb, omega_w, dt);
  }
  return states;
}

// One rotation for the group: each centre goes on the arc that the frame's turning makes of its straight
// way, \f$x^+ = x + h\,(v - \Omega\times(x-c)) + (\exp(h\Omega) - 1)(x - c)\f$; each orientation turns at
// the body's own rate.
// dt: [s] h
inline std::vector<BodyState> moved_in_frame(const World& world, const GroupFrame& frame,
                                             double dt) {
  const Vec3& turning_w = frame.angular_velocity_w;
  return moved(world, dt, [&](const Vec3& x_w, const Vec3& v_w, const Vec3&) -> Vec3 {
    const Vec3 lever_w = x_w - frame.centre_w;
    return x_w + dt * (v_w - turning_w.cross(lever_w)) +
           (rotation_from_vector(dt * turning_w) * lever_w - lever_w);
  });
}

// One rotation for each body: each by the exponential of its own twist, about what of it is at rest.
// dt: [s] h
inline std::vector<BodyState> moved_by_own_twist(const World& world, double dt) {
  return moved(world, dt, [dt](const Vec3& x_w, const Vec3& v_w, const Vec3& omega_w) -> Vec3 {
    return x_w + along_arc(dt * omega_w, dt * v_w);
  });
}

// A tree of pivots, as techniques move bodies with `pose=exponential` (PivotUpdate): each body turns
// about the point on which it stands, and that point is carried along by the body below.
// dt: [s] h
inline std::vector<BodyState> moved_in_tree(const World& world, std::span<const Joint> joints,
                                            double dt) {
  std::vector<PushedPair> pairs;
  for (const Joint& joint : joints)
    if (joint.hold != JointHold::nothing)
      pairs.push_back(
          {joint.first, joint.second, held_point(joint, world.states()).first_w, Vec3::UnitY()});
  std::vector<MovingBody> moving;
  load_moving_bodies(world, moving);
  PivotUpdate carried;
  carried.find(world.bodies(), moving, pairs);

  World after = world;
  for (int body = 0; body < world.count(); ++body) {
    if (carried.carries(body))
      carried.move(body, dt, after);
    else
      advance_pose(world.bodies()[idx(body)], after.states()[idx(body)], dt, RotationRule::frozen);
  }
  return {after.states().begin(), after.states().end()};
}

// By how far the material points of joints are from each other.
// Returns [m] the largest over joints of the distance between the two sides of the held point
inline double mismatch(std::span<const Joint> joints, std::span<const BodyState> states) {
  double largest = 0.0;
  for (const Joint& joint : joints) {
    const JointPoint point = held_point(joint, states);
    largest = std::max(largest, (point.second_w - point.first_w).norm());
  }
  return largest;
}

// A frame and what it leaves.
struct BestFrame {
  GroupFrame frame;   // the one with the smallest largest mismatch
  double left = 0.0;  // [m] that mismatch, after one step
};

// The best single rotation in the plane z = 0 for a box that stands on a box that stands on something
// immovable.
//
// Where the centre c is matters to the lower joint only: the two boxes' places differ by an amount in
// which c cancels. For any rate Omega but 0 there is one c that closes the lower joint. So the best frame
// closes it, and the rest is the upper joint's mismatch, a function of Omega alone. Its smallest value
// is looked for on a grid and between its points by Brent's method.
// widest: [rad/s] rates of the frame up to this one are tried, both ways round
BestFrame best_frame(const World& world, std::span<const Joint> joints, double dt, double widest);

}  // namespace tumble::chapters
