/// \file
/// \brief Featherstone's articulated bodies, as a second opinion on chains and trees in joints.
///
/// Written after Featherstone, "The calculation of robot dynamics using articulated-body inertias", Int. J. Robotics Research 2(1),
/// 1983. Spatial vectors have the angular part first and refer to the origin of the world.
#pragma once

#include "tumble/exterior_rotation/joint_forces.hpp"

#include "support/test.hpp"

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

// Boxes that hang on a wall in a chain or a tree, in motion, by balls and, if asked, every second one by a hinge.
struct HungBoxes {
  World world;
  std::vector<Joint> joints;
  std::vector<HungLink> links;  // without the wall

  // children: joints of each box but those at the ends
  HungBoxes(std::uint64_t seed, int count, int children, bool hinges) {
    Random chance(seed);
    const BodyProperties wall = fixed_box_properties(Vec3::Ones());
    world.add(wall, Vec3::Zero());
    std::vector<Vec3> spin_w{Vec3::Zero()}, speed_w{Vec3::Zero()};
    for (int k = 1; k <= count; ++k) {
      const int parent = k == 1 ? 0 : 1 + (k - 2) / children;
      const auto p = idx(parent);
      const BodyState& on = world.states()[p];
      const Vec3 anchor_w = on.position_w + on.orientation_wb * chance.in_cube(0.5);
      const Quat turn = chance.orientation();
      const Vec3 arm_w = chance.in_cube(0.6);
      const Vec3 turning_w = chance.in_cube(2.0);
      const bool hinge = hinges && k % 2 == 0;
      spin_w.push_back(hinge ? Vec3(spin_w[p] + turning_w) : turning_w);
      const Vec3 at_anchor_w = speed_w[p] + spin_w[p].cross(anchor_w - on.position_w);
      speed_w.push_back(at_anchor_w + spin_w.back().cross(arm_w));
      const BodyProperties box = box_properties(Vec3(1.0, 0.4, 0.7), chance.uniform(0.5, 2.0));
      const BodyId id = world.add(box, anchor_w + arm_w, turn, speed_w.back(), spin_w.back());
      world.join(hinge ? JointKind::hinge : JointKind::ball, world.ids()[p], id, anchor_w,
                 hinge ? turning_w : Vec3(Vec3::Zero()));
      joints.push_back(joint_of(world, world.joints().back()));
      links.push_back({parent - 1, anchor_w, {Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()}});
      if (hinge) links.back().axes_w = {turning_w.normalized()};
    }
  }
};

// How far the accelerations of JointForces are off Featherstone's [-], over the largest of those.
inline double off_featherstone(const HungBoxes& hung) {
  std::vector<MovingBody> moving = moving_bodies(hung.world);
  const std::vector<Spatial> exact = articulated_accelerations(
      hung.links, {moving.begin() + 1, moving.end()}, hung.world.gravity_w);
  JointForces forces;
  std::vector<Wrench> rates;
  forces.hold(hung.world, moving, hung.joints, rates);
  double scale = 0.0, off = 0.0;
  for (std::size_t k = 1; k < moving.size(); ++k) {
    const MovingBody& m = moving[k];
    const Vec3& momentum_w = hung.world.states()[k].angular_momentum_w;
    const Vec3 linear_w = m.inverse_mass.cwiseProduct(rates[k].force_w);
    const Vec3 angular_w =
        m.inverse_inertia_w * (rates[k].torque_w - m.angular_velocity_w.cross(momentum_w));
    scale = std::max(scale, exact[k - 1].cwiseAbs().maxCoeff());
    off = std::max({off, (linear_w - exact[k - 1].tail<3>()).norm(),
                    (angular_w - exact[k - 1].head<3>()).norm()});
  }
  return off / scale;
}

}  // namespace tumble::test
