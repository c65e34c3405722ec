/// \file
/// \brief Contact problems made by hand, for tests of solvers, and how their answers are compared.
#pragma once

#include "tumble/base/index.hpp"
#include "tumble/lcp_solvers/lcp.hpp"

#include "support/dense_solve.hpp"

#include <cmath>
#include <initializer_list>
#include <vector>

namespace tumble::test {

// A problem from the rows of A and b, without equalities and factors.
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

// Whether lengths agree and each entry does within the tolerance.
inline bool near(const std::vector<double>& got, const std::vector<double>& want,
                 double tolerance) {
  if (got.size() != want.size()) return false;
  for (std::size_t i = 0; i < got.size(); ++i)
    if (!(std::abs(got[i] - want[i]) <= tolerance)) return false;
  return true;
}

// Corners of the cube below in x, in the order of its contacts.
inline constexpr double cube_x[4] = {-0.5, 0.5, 0.5, -0.5};
// The same in z.
inline constexpr double cube_z[4] = {-0.5, -0.5, 0.5, 0.5};

// A unit cube of 1 kg on its four corners, its load [N] at (x, z) from the middle; A has the rank 3.
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

// A stack of boxes of 1 kg that touch in one point each.
inline LcpProblem stack(int n) {
  LcpProblem problem{.b = VecX::Zero(n)};
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

// A body of 1 kg with two contacts: on the same side (second = 1) or opposite each other (-1).
inline LcpProblem two_contacts(double second, double b_0, double b_1) {
  LcpProblem problem = stack(1);
  problem.factors.rows.push_back(problem.factors.rows[0]);
  problem.factors.rows[1].linear_second_w *= second;
  multiply_out(problem.factors, problem.A);
  problem.b = Eigen::Vector2d(b_0, b_1);
  return problem;
}

// A box on another one that cannot move, which stands on the ground.
inline LcpProblem on_fixed_box(double b_0, double b_1) {
  LcpProblem problem = stack(2);
  problem.factors.bodies[0] = {};
  multiply_out(problem.factors, problem.A);
  problem.b = Eigen::Vector2d(b_0, b_1);
  return problem;
}

// A cube that flies up from its four corners and may not turn.
inline LcpProblem rising_cube(bool glued) {
  LcpProblem problem = cube_on_ground(-9.81, 0, 0);
  problem.factors.bodies[0].inverse_inertia_w.setZero();
  multiply_out(problem.factors, problem.A);
  if (glued) problem.equality = {0, 0, 1, 0};
  return problem;
}

// The same problem, known by its matrix alone.
inline LcpProblem without_factors(LcpProblem problem) {
  problem.factors = {};
  return problem;
}

// The same problem with bodies: A = L Lᵀ, and two bodies with unit inverse mass take six columns
// of L each. A row can only name two bodies, so n is at most 12.
inline LcpProblem with_factors(LcpProblem problem) {
  const int n = problem.size();
  if (!problem.factors.rows.empty() || n == 0) return problem;
  MatX L = MatX::Zero(n, 12);
  L.leftCols(n) = cholesky(problem.A);
  problem.factors.bodies.assign(2, {Vec3::Ones(), Mat3::Identity()});
  for (int i = 0; i < n; ++i) {
    LcpFactors::Row row;
    row.first = 0;
    row.second = 1;
    row.linear_first_w = L.row(i).segment<3>(0);
    row.angular_first_w = L.row(i).segment<3>(3);
    row.linear_second_w = L.row(i).segment<3>(6);
    row.angular_second_w = L.row(i).segment<3>(9);
    problem.factors.rows.push_back(row);
  }
  return problem;
}

// The accelerations of the bodies by forces, W Jᵀ f, 6 numbers a body. Unlike f they are unique.
inline std::vector<double> added_accelerations(const LcpFactors& factors,
                                               const std::vector<double>& f) {
  std::vector<Vec3> pushed(2 * factors.bodies.size(), Vec3::Zero());
  for (std::size_t i = 0; i < f.size(); ++i) {
    const LcpFactors::Row& row = factors.rows[i];
    const auto push = [&](int body, const Vec3& linear_w, const Vec3& angular_w) {
      if (body < 0) return;
      pushed[2 * idx(body)] += f[i] * linear_w;
      pushed[2 * idx(body) + 1] += f[i] * angular_w;
    };
    push(row.first, row.linear_first_w, row.angular_first_w);
    push(row.second, row.linear_second_w, row.angular_second_w);
  }
  std::vector<double> out;
  for (std::size_t k = 0; k < factors.bodies.size(); ++k) {
    const Vec3 linear = factors.bodies[k].inverse_mass.cwiseProduct(pushed[2 * k]);
    const Vec3 angular = factors.bodies[k].inverse_inertia_w * pushed[2 * k + 1];
    for (const Vec3& v : {linear, angular}) out.insert(out.end(), v.data(), v.data() + 3);
  }
  return out;
}

// Solves a problem by a new solver.
template <class Solver, class... Options>
LcpResult solved_with(const LcpProblem& problem, const Options&... options) {
  Solver solver(options...);
  LcpResult result;
  solver.solve(problem, result);
  return result;
}

// The largest |b|, the scale of accelerations. [m/s²] 1 if all are 0 or there are none
inline double scale_of(const LcpProblem& problem) {
  const double largest = problem.size() > 0 ? problem.b.cwiseAbs().maxCoeff() : 0.0;
  return largest > 0.0 ? largest : 1.0;
}

// How far two lists of accelerations are apart.
inline double distance(const std::vector<double>& got, const std::vector<double>& want) {
  double worst = 0.0;
  for (std::size_t i = 0; i < got.size(); ++i) {
    const double error = std::abs(got[i] - want[i]);
    if (!(error <= worst)) worst = error;
  }
  return worst;
}

}  // namespace tumble::test
