/// \file
/// \brief Contact problems for tests of solvers: made by hand, and at random.
#pragma once

#include "tumble/base/random.hpp"
#include "tumble/lcp_solvers/lcp.hpp"

#include <cmath>
#include <initializer_list>
#include <vector>

namespace tumble::test {

/// Writes a problem down.
/// \param rows  A, row by row
/// \param b     the constant part
/// \return a problem without equalities and factors
inline LcpProblem lcp(std::initializer_list<double> rows, std::initializer_list<double> b) {
  const auto n = static_cast<Eigen::Index>(b.size());
  LcpProblem problem{MatX(n, n), VecX(n), {}};
  Eigen::Index k = 0;
  for (const double value : rows) {
    problem.A(k / n, k % n) = value;
    ++k;
  }
  k = 0;
  for (const double value : b) problem.b[k++] = value;
  return problem;
}

/// Compares numbers.
/// \param got        what came out
/// \param want       what should have
/// \param tolerance  how far each may be off
/// \return whether the lengths agree and each entry is as close
inline bool near(const std::vector<double>& got, const std::vector<double>& want,
                 double tolerance) {
  if (got.size() != want.size()) return false;
  for (std::size_t i = 0; i < got.size(); ++i)
    if (!(std::abs(got[i] - want[i]) <= tolerance)) return false;
  return true;
}

/// Corners of the cube below in x, in the order of its contacts.
inline constexpr double cube_x[4] = {-0.5, 0.5, 0.5, -0.5};
/// The same in z.
inline constexpr double cube_z[4] = {-0.5, -0.5, 0.5, 0.5};

/// A unit cube of 1 kg on its four corners; A has the rank 3.
/// \param weight  [N] its load
/// \param x       [m] where the load acts, from the middle
/// \param z       [m] the same
/// \return with factors. Corners sink with weight (1 + 6 (x x_k + z z_k)), since I = 1/6
inline LcpProblem cube_on_ground(double weight, double x, double z) {
  LcpProblem problem = lcp({4, 1, -2, 1, 1, 4, 1, -2, -2, 1, 4, 1, 1, -2, 1, 4}, {0, 0, 0, 0});
  problem.factors.bodies.push_back({Vec3::Ones(), Vec3::Constant(6.0).asDiagonal()});
  for (int k = 0; k < 4; ++k) {
    problem.b[k] = -weight * (1.0 + 6.0 * (cube_x[k] * x + cube_z[k] * z));
    LcpFactors::Row row;
    row.second = 0;
    row.linear_second_w = Vec3::UnitY();
    row.angular_second_w = Vec3(cube_x[k], -0.5, cube_z[k]).cross(Vec3::UnitY());
    problem.factors.rows.push_back(row);
  }
  return problem;
}

/// A stack of boxes of 1 kg that touch in one point each.
/// \param n  how many
/// \return with factors; level k carries (n - k) 9.81 N
inline LcpProblem stack(int n) {
  LcpProblem problem;
  problem.b = VecX::Zero(n);
  problem.b[0] = -9.81;
  for (int k = 0; k < n; ++k) {
    problem.factors.bodies.push_back({Vec3::Ones(), Mat3::Identity()});
    LcpFactors::Row row;
    row.first = k - 1;
    row.second = k;
    row.linear_first_w = -Vec3::UnitY();
    row.linear_second_w = Vec3::UnitY();
    problem.factors.rows.push_back(row);
  }
  multiply_out(problem.factors, problem.A);
  return problem;
}

/// Boxes that touch each other and scenery anywhere, in any direction, loaded in any way; a third
/// of the contacts are given twice.
/// \param random        where the numbers come from
/// \param most_bodies   at most so many boxes
/// \param most_rows     at most so many contacts
/// \param independent   normals, places and masses are multiples of 1/8 if not set, so that
///                      dependent contacts depend exactly and conditions tie
/// \return with factors; b = J times accelerations, so that a solution exists
inline LcpProblem random_contacts(Random& random, int most_bodies, int most_rows,
                                  bool independent) {
  const auto grid = [&](double value) {
    return independent ? value : std::floor(8.0 * value + 0.5) / 8.0;
  };
  const auto grid3 = [&](const Vec3& v) { return Vec3(grid(v.x()), grid(v.y()), grid(v.z())); };
  LcpProblem problem;
  const int bodies = 1 + static_cast<int>(random.below(static_cast<std::uint32_t>(most_bodies)));
  const int n = 1 + static_cast<int>(random.below(static_cast<std::uint32_t>(most_rows)));
  std::vector<Vec3> linear;
  std::vector<Vec3> angular;
  for (int k = 0; k < bodies; ++k) {
    LcpFactors::Body body;
    body.inverse_mass.setConstant(grid(random.uniform(0.2, 5.0)));
    const Mat3 turned = random.orientation().toRotationMatrix();
    const Mat3 axes = independent ? turned : Mat3::Identity();
    const Vec3 yields = 6.0 * body.inverse_mass + grid3(random.in_cube(1.0));
    body.inverse_inertia_w = axes * yields.asDiagonal() * axes.transpose();
    body.inverse_inertia_w =
        (0.5 * (body.inverse_inertia_w + body.inverse_inertia_w.transpose())).eval();
    problem.factors.bodies.push_back(body);
    linear.push_back(grid3(random.in_cube(10.0)));
    angular.push_back(grid3(random.in_cube(10.0)));
  }
  problem.b.resize(n);
  for (int i = 0; i < n; ++i) {
    LcpFactors::Row row;
    row.first = static_cast<int>(random.below(static_cast<std::uint32_t>(bodies) + 1)) - 1;
    row.second = static_cast<int>(random.below(static_cast<std::uint32_t>(bodies)));
    if (row.first == row.second) row.first = -1;
    const Vec3 direction = random.direction();
    Vec3 normal = grid3(direction);
    if (normal.isZero(0.0)) normal = Vec3::UnitY();
    row.linear_first_w = -normal;
    row.linear_second_w = normal;
    row.angular_first_w = -grid3(random.in_cube(0.5)).cross(normal);
    row.angular_second_w = grid3(random.in_cube(0.5)).cross(normal);
    if (i > 0 && random.below(3) == 0) row = problem.factors.rows.back();
    problem.factors.rows.push_back(row);
    problem.b[i] = row.linear_second_w.dot(linear[static_cast<std::size_t>(row.second)]) +
                   row.angular_second_w.dot(angular[static_cast<std::size_t>(row.second)]);
    if (row.first >= 0)
      problem.b[i] += row.linear_first_w.dot(linear[static_cast<std::size_t>(row.first)]) +
                      row.angular_first_w.dot(angular[static_cast<std::size_t>(row.first)]);
  }
  multiply_out(problem.factors, problem.A);
  return problem;
}

/// The largest |b|, the scale of accelerations.
/// \param problem the problem
/// \return [m/s²] 1 if all are 0 or there are none
inline double scale_of(const LcpProblem& problem) {
  const double largest = problem.size() > 0 ? problem.b.cwiseAbs().maxCoeff() : 0.0;
  return largest > 0.0 ? largest : 1.0;
}

/// How far two lists of accelerations are apart.
/// \param got   one
/// \param want  the other
/// \return the largest difference
inline double distance(const std::vector<double>& got, const std::vector<double>& want) {
  double worst = 0.0;
  for (std::size_t i = 0; i < got.size(); ++i) {
    const double error = std::abs(got[i] - want[i]);
    if (!(error <= worst)) worst = error;
  }
  return worst;
}

}  // namespace tumble::test
