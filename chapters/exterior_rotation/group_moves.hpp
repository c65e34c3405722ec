/// \file
/// \brief Ways to move bodies over a step with given velocities, written out (thesis 6.2).
#pragma once

#include "tumble/exterior_rotation/joint.hpp"

#include "driver/experiment.hpp"

namespace tumble::chapters {

// A body's centre after a step in which the body turns about one of its points, which goes straight:
// \f$x^+ = c + h v_c + \exp(h\omega)(x - c)\f$ with \f$v_c = v + \omega\times(c - x)\f$.
//
// With c = x the centre goes straight; with c the pivot the body goes round it; with c at rest it is the
// exponential of the body's twist in the plane.
// x_w: [m] centre
// v_w: [m/s] its velocity
// omega_w: [rad/s] of the body
// c_w: [m] the point
// dt: [s] h
// Returns [m] the centre
Vec3 moved_about(const Vec3& x_w, const Vec3& v_w, const Vec3& omega_w, const Vec3& c_w, double dt);

// The point of a body in plane motion that is at rest just now: \f$x + \omega\times v/\omega^2\f$.
// x_w: [m] centre
// v_w: [m/s] its velocity, at right angles to omega
// omega_w: [rad/s] not 0
// Returns [m] c
Vec3 resting_point(const Vec3& x_w, const Vec3& v_w, const Vec3& omega_w);

// A frame of reference for a whole group, turning about a point.
struct GroupFrame {
  Vec3 centre_w = Vec3::Zero();            // [m] c
  Vec3 angular_velocity_w = Vec3::Zero();  // [rad/s] Omega
};

// One rotation for the group: each centre goes on the arc that the frame's turning makes of its straight
// way, \f$x^+ = x + h\,(v - \Omega\times(x-c)) + (\exp(h\Omega) - 1)(x - c)\f$; each orientation turns at
// the body's own rate.
// dt: [s] h
std::vector<BodyState> moved_in_frame(const World& world, const GroupFrame& frame, double dt);

// One rotation for each body: each by the exponential of its own twist, about what of it is at rest.
// dt: [s] h
std::vector<BodyState> moved_by_own_twist(const World& world, double dt);

// A tree of pivots, as techniques move bodies with `pose=exponential` (PivotUpdate): each body turns
// about the point on which it stands, and that point is carried along by the body below.
// dt: [s] h
std::vector<BodyState> moved_in_tree(const World& world, std::span<const Joint> joints, double dt);

// By how far the material points of joints are from each other.
// Returns [m] the largest over joints of the distance between the two sides of the held point
double mismatch(std::span<const Joint> joints, std::span<const BodyState> states);

}  // namespace tumble::chapters
