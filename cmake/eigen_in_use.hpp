/// \file
/// \brief Eigen, and what nearly every source makes of it: precompiled where each source is compiled alone.
///
/// A source needs a third less time where the compiler has read Eigen and made these types and sums before. No
/// source includes this file, so each still brings the headers that it needs.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace tumble {

struct EigenInUse {
  Eigen::Vector3d a, b;
  Eigen::Matrix3d m, n;
  Eigen::Quaterniond p, q;
  Eigen::Matrix<double, 6, 1> x;
  Eigen::Matrix<double, 6, 6> k;
};

// Never called; what it uses is made once.
[[maybe_unused]] static inline double use_eigen(EigenInUse& u) {
  u.a = u.a + 2.0 * u.b - u.a / 3.0;
  u.a += u.b.cross(u.a) + u.m * u.b - u.n.transpose() * u.a;
  u.a -= 2.0 * u.b;
  u.a *= 2.0;
  u.b = (u.m * u.a).normalized() + u.q * u.a + u.m.col(0) + Eigen::Vector3d(u.a - u.b);
  u.b = u.a.cwiseProduct(u.b).cwiseAbs() + Eigen::Vector3d::Constant(1.0) +
        Eigen::Vector3d::Zero() + Eigen::Vector3d::UnitY();
  u.m = u.m * u.n + u.m.transpose() + Eigen::Matrix3d::Identity();
  u.m = u.n * u.a.asDiagonal() * u.n.transpose();
  u.n = u.q.toRotationMatrix();
  u.q = u.p * u.q.conjugate();
  u.x += u.k * u.x;
  return u.a.dot(u.b) + u.a.norm() + u.a.minCoeff() + u.a.maxCoeff() + u.x.squaredNorm();
}

}  // namespace tumble
