/// \file
/// \brief Contact forces by Gauss' principle of least constraint (thesis 2.6.2).
#include "tumble/lcp_solvers/least_constraint.hpp"

#include "tumble/base/index.hpp"
#include "tumble/base/tolerances.hpp"
#include "tumble/lcp_solvers/tolerances.hpp"

#include <algorithm>
#include <cmath>

namespace tumble {
namespace {

// The length of a column of E without its last entry: of a column of G.
double length_of(const MatX& E, int column) {
  double square = 0.0;
  for (int k = 0; k + 1 < E.rows(); ++k) square += E(k, column) * E(k, column);
  return std::sqrt(square);
}

}  // namespace

void LeastConstraintSolver::solve(const LcpProblem& problem, LcpResult& result,
                                  std::span<const int> start) {
  require_valid(problem, LcpMatrix::symmetric_semidefinite);
  require_valid_start(problem.size(), start);
  const int n = problem.size();
  cone_.pushing.assign(start.begin(), start.end());
  result.status = LcpStatus::solved;
  result.f.assign(idx(n), 0.0);
  result.pivots = 0;
  result.multiplications = 0;
  if (!set_up_columns(problem)) {
    result.status = LcpStatus::not_positive_semidefinite;
    complete(problem, result);
    return;
  }
  x_.assign(6 * problem.factors.bodies.size(), 0.0);

  // |z| is at least the distance of the farthest constraint; if that is 0, the free accelerations
  // obey all of them. Once z is known its length is the right scale, and with the columns in use as
  // a start a second projection costs next to nothing and gains the digits that t had lost.
  double scale = farthest_constraint(problem);
  if (!std::isfinite(scale)) result.status = LcpStatus::infeasible;
  for (int round = 0; round < 2 && scale > 0.0 && result.status == LcpStatus::solved; ++round) {
    if (!project(problem, scale)) result.status = LcpStatus::infeasible;
    result.pivots += cone_.pivots;
    result.multiplications += cone_.multiplications;
    if (cone_.status != ComplementarityStatus::solved) result.status = LcpStatus::cap_reached;
    if (result.status != LcpStatus::infeasible) take_forces(problem, scale, result);
    const double t = cone_.rest.back();
    scale *= std::sqrt(std::max(0.0, cone_.distance * cone_.distance - t * t)) / t;
  }
  conclude(problem, result);
}

// E without its last row: G = Sᵀ Jᵀ, then once more with the other sign for equalities. Where bodies are not
// known a factor of A stands for G. Returns false if there is none.
bool LeastConstraintSolver::set_up_columns(const LcpProblem& problem) {
  const int n = problem.size();
  mirrored_.clear();
  mirrored_.reserve(idx(n));
  for (int i = 0; i < n; ++i)
    if (is_equality(problem, i)) mirrored_.push_back(i);
  if (problem.factors.rows.empty()) {
    if (!rows_.take(problem)) return false;
    set_size(problem, rows_.blocks());
    take_matrix_columns();
  } else {
    set_size(problem, static_cast<int>(problem.factors.bodies.size()));
    take_body_columns(problem);
  }
  for (std::size_t k = 0; k < mirrored_.size(); ++k)
    E_.col(n + static_cast<int>(k)) = -E_.col(mirrored_[k]);
  return true;
}

void LeastConstraintSolver::set_size(const LcpProblem& problem, int blocks) {
  const int rows = 6 * blocks + 1;
  E_.setZero(rows, problem.size() + static_cast<int>(mirrored_.size()));
  target_.setZero(rows);
  target_[rows - 1] = 1.0;
}

void LeastConstraintSolver::take_matrix_columns() {
  for (int i = 0; i < rows_.size(); ++i)
    for (int p = rows_.begin_of_rows()[idx(i)]; p < rows_.begin_of_rows()[idx(i) + 1]; ++p)
      E_.block<6, 1>(6 * rows_.blocks_of_rows()[idx(p)], i) =
          rows_.length(i) * rows_.parts()[idx(p)];
}

void LeastConstraintSolver::take_body_columns(const LcpProblem& problem) {
  require_factors_fit(problem);
  roots_.take(problem.factors);
  const auto put = [this](int column, int body, const Vec3& linear_w, const Vec3& angular_w) {
    if (body >= 0) E_.block<6, 1>(6 * body, column) = roots_.part(body, linear_w, angular_w);
  };
  for (int i = 0; i < problem.size(); ++i) {
    const LcpFactors::Row& row = problem.factors.rows[idx(i)];
    put(i, row.first, row.linear_first_w, row.angular_first_w);
    put(i, row.second, row.linear_second_w, row.angular_second_w);
    const double length = length_of(E_, i);
    require_diagonal(problem, i, length * length);
  }
}

// The distance of z = 0 from the half space that it is farthest out of; 0 if it is in all of them;
// infinite if a constraint that no acceleration changes is broken.
double LeastConstraintSolver::farthest_constraint(const LcpProblem& problem) const {
  double farthest = 0.0;
  double largest = 0.0;
  for (int i = 0; i < problem.size(); ++i) largest = std::max(largest, std::abs(problem.b[i]));
  for (int i = 0; i < problem.size(); ++i) {
    const double broken_by = is_equality(problem, i) ? std::abs(problem.b[i]) : -problem.b[i];
    const double length = length_of(E_, i);
    if (length == 0.0 && broken_by <= tolerance::complementarity * largest) continue;
    farthest = std::max(farthest, broken_by / length);
  }
  return farthest;
}

// Projects (0, 1) on the cone of E, with E's last row in units of the scale. Returns false if it
// lies in the cone: then some forces do not move the bodies and yet sum up to b·f < 0.
bool LeastConstraintSolver::project(const LcpProblem& problem, double scale) {
  const int n = problem.size();
  const int last = static_cast<int>(E_.rows()) - 1;
  for (int i = 0; i < n; ++i) E_(last, i) = length_of(E_, i) > 0.0 ? -problem.b[i] / scale : 0.0;
  for (std::size_t k = 0; k < mirrored_.size(); ++k)
    E_(last, n + static_cast<int>(k)) = -E_(last, mirrored_[k]);
  nearest_.solve(E_, target_, cone_, cone_.pushing);
  return cone_.distance > tolerance::contradiction;
}

// f = s u / t, and x = S z with z = s G u / t.
void LeastConstraintSolver::take_forces(const LcpProblem& problem, double scale,
                                        LcpResult& result) {
  const int n = problem.size();
  const double factor = scale / cone_.rest.back();
  for (int i = 0; i < n; ++i) result.f[idx(i)] = factor * cone_.f[idx(i)];
  for (std::size_t k = 0; k < mirrored_.size(); ++k)
    result.f[idx(mirrored_[k])] -= factor * cone_.f[idx(n) + k];

  if (problem.factors.rows.empty()) return;
  for (int body = 0; body < static_cast<int>(problem.factors.bodies.size()); ++body) {
    double* x = &x_[6 * idx(body)];
    const Vec6 Gu = Eigen::Map<const Vec6>(&cone_.rest[6 * idx(body)]);  // with the other sign
    Eigen::Map<Vec6>(x, 6) = roots_.acceleration(body, -factor * Gu);
  }
}

}  // namespace tumble
