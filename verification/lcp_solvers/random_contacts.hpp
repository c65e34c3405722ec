/// \file
/// \brief Random contact problems for tests of solvers.
#pragma once

#include "tumble/base/random.hpp"

#include "lcp_solvers/lcp_cases.hpp"
#include "lcp_solvers/redundant_contacts.hpp"

#include <cmath>
#include <vector>

namespace tumble::test {

// Boxes that touch each other and scenery anywhere, in any direction, loaded in any way; a third
// of the contacts are given twice. Unless independent, normals, places and masses are multiples of 1/8, so
// that dependent contacts depend exactly and conditions tie.
inline LcpProblem random_contacts(Random& random, int most_bodies, int most_rows,
                                  bool independent) {
  const auto grid = [&](double value) {
    return independent ? value : std::floor(8.0 * value + 0.5) / 8.0;
  };
  const auto grid3 = [&](const Vec3& v) { return Vec3(grid(v.x()), grid(v.y()), grid(v.z())); };
  LcpProblem problem;
  const int bodies = 1 + static_cast<int>(random.below(static_cast<std::uint32_t>(most_bodies)));
  const int n = 1 + static_cast<int>(random.below(static_cast<std::uint32_t>(most_rows)));
  std::vector<chapters::Load> loads;
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
    const Vec3 linear_w = grid3(random.in_cube(10.0));
    loads.push_back({linear_w, grid3(random.in_cube(10.0))});
  }
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
  }
  problem.b = chapters::constant_part(problem.factors, loads);
  multiply_out(problem.factors, problem.A);
  return problem;
}

}  // namespace tumble::test
