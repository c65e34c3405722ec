/// \file
/// \brief Contact problems made by hand, for tests of solvers, and how their answers are compared.
#pragma once

#include "tumble/base/index.hpp"
#include "tumble/lcp_solvers/lcp.hpp"

#include <Eigen/Cholesky>

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

/// A body of 1 kg with two contacts.
/// \param second  1: on the same side as the first one; -1: opposite it
/// \param b_0     [m/s²] how the first one parts without forces
/// \param b_1     [m/s²] ditto, the second one
/// \return with factors
inline LcpProblem two_contacts(double second, double b_0, double b_1) {
  LcpProblem problem = stack(1);
  problem.factors.rows.push_back(problem.factors.rows[0]);
  problem.factors.rows[1].linear_second_w *= second;
  multiply_out(problem.factors, problem.A);
  problem.b = Eigen::Vector2d(b_0, b_1);
  return problem;
}

/// A box on another one that cannot move, which stands on the ground.
/// \param b_0  [m/s²] how the lower contact parts, in which nothing can move
/// \param b_1  [m/s²] how the upper one parts without forces
/// \return with factors
inline LcpProblem on_fixed_box(double b_0, double b_1) {
  LcpProblem problem = stack(2);
  problem.factors.bodies[0] = {};
  multiply_out(problem.factors, problem.A);
  problem.b = Eigen::Vector2d(b_0, b_1);
  return problem;
}

/// A cube that flies up from its four corners and may not turn.
/// \param glued  whether its third corner is held back
/// \return with factors
inline LcpProblem rising_cube(bool glued) {
  LcpProblem problem = cube_on_ground(-9.81, 0, 0);
  problem.factors.bodies[0].inverse_inertia_w.setZero();
  multiply_out(problem.factors, problem.A);
  if (glued) problem.equality = {0, 0, 1, 0};
  return problem;
}

/// The same problem, known by its matrix alone.
/// \param problem a copy is changed
/// \return it
inline LcpProblem without_factors(LcpProblem problem) {
  problem.factors = {};
  return problem;
}

/// The same problem with bodies: A = L Lᵀ, and two bodies with unit inverse mass take six columns
/// of L each. A row can only name two bodies, so n is at most 12.
/// \param problem  its matrix is positive definite; one with factors, or without rows, stays
/// \return with factors
inline LcpProblem with_factors(LcpProblem problem) {
  const int n = problem.size();
  if (!problem.factors.rows.empty() || n == 0) return problem;
  MatX L = MatX::Zero(n, 12);
  L.leftCols(n) = MatX(Eigen::LLT<MatX>(problem.A).matrixL());
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

/// What forces do to the bodies, W Jᵀ f. Unlike f it is unique.
/// \param factors  of the problem
/// \param f        [N]
/// \return [m/s²], [rad/s²] 6 numbers a body
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

/// Solves a problem by a new solver.
/// \tparam Solver  its class
/// \param problem  the problem
/// \param options  of the solver
/// \return what it says
template <class Solver, class... Options>
LcpResult solved_with(const LcpProblem& problem, const Options&... options) {
  Solver solver(options...);
  LcpResult result;
  solver.solve(problem, result);
  return result;
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
