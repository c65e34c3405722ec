/// \file
/// \brief The contact problems that solvers are measured with: pyramids of cubes without friction.
#include "lcp_solvers/pyramid_problem.hpp"

#include "tumble/base/error.hpp"
#include "tumble/base/index.hpp"
#include "tumble/base/random.hpp"

#include "driver/played_scene.hpp"

#include <algorithm>
#include <string>

namespace tumble::chapters {
namespace {

using Row = LcpFactors::Row;

constexpr double spacing = 1.05;  // [m]

// Where the cubes of a row of the pyramid begin: rows have k, k - 1, ... cubes.
int first_of_row(int k, int row) { return row * k - row * (row - 1) / 2; }

Vec3 center(int k, int cube) {
  int row = 0;
  while (cube >= first_of_row(k, row + 1)) ++row;
  const int place = cube - first_of_row(k, row);
  return {spacing * (place + 0.5 * row), row + 0.5, 0.0};
}

// The four corners of the area in which the cube stands on the one below, or on the ground.
void add_face_pair(LcpProblem& problem, int k, int below, int cube) {
  const Vec3 upper_w = center(k, cube);
  const Vec3 lower_w = below < 0 ? Vec3(upper_w - Vec3::UnitY()) : center(k, below);
  const double left = std::max(upper_w.x(), lower_w.x()) - 0.5;
  const double right = std::min(upper_w.x(), lower_w.x()) + 0.5;
  for (const double x : {left, right})
    for (const double z : {-0.5, 0.5}) {
      const Vec3 point_w(x, upper_w.y() - 0.5, z);
      Row row;
      row.first = below;
      row.second = cube;
      row.linear_second_w = Vec3::UnitY();
      row.angular_second_w = Vec3(point_w - upper_w).cross(Vec3::UnitY());
      if (below >= 0) {
        row.linear_first_w = -Vec3::UnitY();
        row.angular_first_w = -Vec3(point_w - lower_w).cross(Vec3::UnitY());
      }
      problem.factors.rows.push_back(row);
    }
}

// b = J (v + g dt)
void set_b(PyramidProblem& pyramid) {
  LcpProblem& problem = pyramid.problem;
  const Vec3 fall(0.0, -kGravity * kStep, 0.0);
  problem.b.setZero(static_cast<Eigen::Index>(problem.factors.rows.size()));
  for (int i = 0; i < problem.size(); ++i) {
    const Row& row = problem.factors.rows[idx(i)];
    const auto add = [&](int body, const Vec3& linear, const Vec3& angular) {
      if (body < 0) return;
      problem.b[i] += linear.dot(pyramid.linear_w[idx(body)] + fall);
      problem.b[i] += angular.dot(pyramid.angular_w[idx(body)]);
    };
    add(row.first, row.linear_first_w, row.angular_first_w);
    add(row.second, row.linear_second_w, row.angular_second_w);
  }
}

}  // namespace

PyramidProblem pyramid_problem(int n, double noise, std::uint64_t seed) {
  require::that(n > 0 && n % 4 == 0, "n = " + std::to_string(n) + ": give a multiple of 4");
  int k = 1;
  while (4 * k * k < n) ++k;
  PyramidProblem pyramid;
  LcpProblem& problem = pyramid.problem;
  int pairs = 0;
  int cubes = 0;
  for (int row = 0; row < k && 4 * pairs < n; ++row)
    for (int place = 0; place < k - row && 4 * pairs < n; ++place) {
      const int cube = first_of_row(k, row) + place;
      const int left_below = row == 0 ? -1 : first_of_row(k, row - 1) + place;
      add_face_pair(problem, k, left_below, cube);
      ++pairs;
      if (row > 0 && 4 * pairs < n) {
        add_face_pair(problem, k, left_below + 1, cube);
        ++pairs;
      }
      cubes = cube + 1;
    }
  const LcpFactors::Body unit_cube{Vec3::Ones(), Mat3(Vec3::Constant(6.0).asDiagonal())};
  problem.factors.bodies.assign(idx(cubes), unit_cube);
  Random random(seed);
  for (int cube = 0; cube < cubes; ++cube) {
    pyramid.linear_w.push_back(random.in_cube(noise));
    pyramid.angular_w.push_back(random.in_cube(noise));
  }
  multiply_out(problem.factors, problem.A);
  set_b(pyramid);
  return pyramid;
}

PyramidProblem next_step(const PyramidProblem& before, std::span<const double> f) {
  PyramidProblem pyramid = before;
  const LcpFactors& factors = before.problem.factors;
  require::that(f.size() == factors.rows.size(), "f: give a force for each contact");
  for (Vec3& v : pyramid.linear_w) v.y() -= kGravity * kStep;
  for (std::size_t i = 0; i < f.size(); ++i) {
    const Row& row = factors.rows[i];
    const auto push = [&](int body, const Vec3& linear, const Vec3& angular) {
      if (body < 0) return;
      const LcpFactors::Body& yields = factors.bodies[idx(body)];
      pyramid.linear_w[idx(body)] += f[i] * yields.inverse_mass.cwiseProduct(linear);
      pyramid.angular_w[idx(body)] += f[i] * (yields.inverse_inertia_w * angular);
    };
    push(row.first, row.linear_first_w, row.angular_first_w);
    push(row.second, row.linear_second_w, row.angular_second_w);
  }
  set_b(pyramid);
  return pyramid;
}

}  // namespace tumble::chapters
