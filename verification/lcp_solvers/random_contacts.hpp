/// \file
/// \brief Random contact problems for tests of solvers.
#pragma once

#include "tumble/base/random.hpp"

#include "lcp_solvers/lcp_cases.hpp"

#include <cmath>
#include <vector>

namespace tumble::test {

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

/// What sets one chain of boxes apart from another.
struct ChainOptions {
  double heavy = 1.0;   ///< [-] mass of every second body over that of the others
  double needle = 1.0;  ///< [-] how much more easily bodies turn about z
  bool repeat = false;  ///< whether every fifth contact is given twice
};

/// A chain of boxes, each touched in points in any direction by the one before; the first by scenery.
/// With twice as many contacts as motions a body hardly fits in, and forces grow to a hundred
/// thousand times b.
/// \param random    where the numbers come from
/// \param bodies    how many
/// \param contacts  on each
/// \param options   see there
/// \return with factors; b = J times accelerations, so that a solution exists
inline LcpProblem chain(Random& random, int bodies, int contacts,
                        const ChainOptions& options = {}) {
  LcpProblem problem;
  std::vector<Vec3> linear_w;
  std::vector<Vec3> angular_w;
  for (int k = 0; k < bodies; ++k) {
    const double inverse_mass = k % 2 == 0 ? 1.0 : 1.0 / options.heavy;
    const Vec3 yields = inverse_mass * Vec3(6.0, 6.0, 6.0 * options.needle);
    problem.factors.bodies.push_back({Vec3::Constant(inverse_mass), Mat3(yields.asDiagonal())});
    linear_w.push_back(random.in_cube(10.0));
    angular_w.push_back(random.in_cube(10.0));
  }
  problem.b.setZero(bodies * contacts);
  for (int i = 0; i < bodies * contacts; ++i) {
    LcpFactors::Row row;
    row.second = i / contacts;
    row.first = row.second - 1;
    const Vec3 normal = random.direction();
    row.linear_first_w = -normal;
    row.linear_second_w = normal;
    row.angular_first_w = -random.in_cube(0.5).cross(normal);
    row.angular_second_w = random.in_cube(0.5).cross(normal);
    if (options.repeat && i % 5 == 4) row = problem.factors.rows.back();
    problem.factors.rows.push_back(row);
    problem.b[i] = row.linear_second_w.dot(linear_w[idx(row.second)]) +
                   row.angular_second_w.dot(angular_w[idx(row.second)]);
    if (row.first >= 0)
      problem.b[i] += row.linear_first_w.dot(linear_w[idx(row.first)]) +
                      row.angular_first_w.dot(angular_w[idx(row.first)]);
  }
  multiply_out(problem.factors, problem.A);
  return problem;
}

}  // namespace tumble::test
