/// \file
/// \brief Featherstone's articulated bodies, as a second opinion on chains and trees in joints.
///
/// Written after Featherstone, "The calculation of robot dynamics using articulated-body inertias", Int. J. Robotics Research 2(1),
/// 1983. Spatial vectors have the angular part first and refer to the origin of the world.
#pragma once

#include "tumble/contact/moving_body.hpp"

#include <vector>

namespace tumble::test {

using Spatial = Eigen::Matrix<double, 6, 1>;
using SpatialMatrix = Eigen::Matrix<double, 6, 6>;

// A link that hangs on its parent by a joint that turns about axes through a point.
struct HungLink {
  int parent = -1;  // an earlier one; -1: the world
  Vec3 joint_w = Vec3::Zero();
  std::vector<Vec3> axes_w;  // those about which it turns: three for a ball joint, one for a hinge
};

inline Spatial spatial(const Vec3& angular, const Vec3& linear) {
  Spatial both;
  both << angular, linear;
  return both;
}

// The motion of a point at the origin that turns about an axis through another one.
inline Spatial turning_about(const Vec3& axis_w, const Vec3& through_w) {
  return spatial(axis_w, through_w.cross(axis_w));
}

inline Mat3 cross_matrix(const Vec3& a) {
  Mat3 m;
  m << 0.0, -a.z(), a.y(), a.z(), 0.0, -a.x(), -a.y(), a.x(), 0.0;
  return m;
}

// Accelerations of all links.
// bodies: masses, inertia, velocities that the joints permit; one for each link
// Returns angular and, at the centres, linear accelerations
inline std::vector<Spatial> articulated_accelerations(const std::vector<HungLink>& links,
                                                      const std::vector<MovingBody>& bodies,
                                                      const Vec3& gravity_w) {
  const std::size_t n = links.size();
  std::vector<Spatial> velocity(n), bias(n), coriolis(n, Spatial::Zero()), result(n);
  std::vector<SpatialMatrix> inertia(n);
  std::vector<Eigen::Matrix<double, 6, 3>> axes(n, Eigen::Matrix<double, 6, 3>::Zero());
  std::vector<Mat3> yield(n);
  for (std::size_t i = 0; i < n; ++i) {
    const MovingBody& b = bodies[i];
    const double mass = 1.0 / b.inverse_mass.x();
    const Mat3 arm = cross_matrix(b.position_w);
    const Mat3 own = b.inverse_inertia_w.inverse();
    velocity[i] =
        spatial(b.angular_velocity_w, b.velocity_w - b.angular_velocity_w.cross(b.position_w));
    inertia[i] << own + mass * arm * arm.transpose(), mass * arm, mass * arm.transpose(),
        mass * Mat3::Identity();
    // v ×* (I v), less the weight at the centre.
    const Spatial momentum = inertia[i] * velocity[i];
    const Vec3 w = velocity[i].head<3>(), u = velocity[i].tail<3>();
    bias[i] = spatial(w.cross(momentum.head<3>()) + u.cross(momentum.tail<3>()),
                      w.cross(momentum.tail<3>()));
    bias[i] -= spatial(b.position_w.cross(mass * gravity_w), mass * gravity_w);
    for (std::size_t k = 0; k < links[i].axes_w.size(); ++k)
      axes[i].col(static_cast<Eigen::Index>(k)) =
          turning_about(links[i].axes_w[k], links[i].joint_w);
    // The axes move with the link: v × (v - v of the parent).
    const Spatial before = links[i].parent < 0
                               ? Spatial(Spatial::Zero())
                               : velocity[static_cast<std::size_t>(links[i].parent)];
    const Spatial turns = velocity[i] - before;
    coriolis[i] =
        spatial(w.cross(turns.head<3>()), w.cross(turns.tail<3>()) + u.cross(turns.head<3>()));
  }
  for (std::size_t i = n; i-- > 0;) {
    const Eigen::Matrix<double, 6, 3> pushed = inertia[i] * axes[i];
    Mat3 resists = axes[i].transpose() * pushed;
    for (auto k = static_cast<Eigen::Index>(links[i].axes_w.size()); k < 3; ++k)
      resists(k, k) = 1.0;  // no axis, and so without effect
    yield[i] = resists.inverse();
    if (links[i].parent < 0) continue;
    const auto p = static_cast<std::size_t>(links[i].parent);
    const SpatialMatrix left = inertia[i] - pushed * yield[i] * pushed.transpose();
    bias[p] += bias[i] + left * coriolis[i] - pushed * (yield[i] * (axes[i].transpose() * bias[i]));
    inertia[p] += 0.5 * (left + left.transpose());  // else rounding grows from link to link
  }
  for (std::size_t i = 0; i < n; ++i) {
    const Spatial before = links[i].parent < 0 ? Spatial(Spatial::Zero())
                                               : result[static_cast<std::size_t>(links[i].parent)];
    const Spatial carried = before + coriolis[i];
    const Vec3 along = -(yield[i] * (axes[i].transpose() * (inertia[i] * carried + bias[i])));
    result[i] = carried + axes[i] * along;
  }
  for (std::size_t i = 0; i < n; ++i) {  // from spatial accelerations to those of the centres
    const Vec3 turn = result[i].head<3>();
    result[i].tail<3>() +=
        turn.cross(bodies[i].position_w) + bodies[i].angular_velocity_w.cross(bodies[i].velocity_w);
  }
  return result;
}

}  // namespace tumble::test
