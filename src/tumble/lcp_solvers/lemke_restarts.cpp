/// \file
/// \brief Lemke's method begun at other bases, for matrices for which a ray proves nothing.
#include "tumble/lcp_solvers/lemke_restarts.hpp"

#include "tumble/base/index.hpp"
#include "tumble/lcp_solvers/tolerances.hpp"

#include <algorithm>
#include <array>
#include <vector>

namespace tumble {
namespace {

constexpr int kMostAttempts = 500;
constexpr double kMostWork = 1e8;  // multiplications of all attempts, about 2 n³ each

// Of a 1×1 or 2×2 matrix; false if it has none.
bool invert(const MatX& A, MatX& inverse) {
  const double determinant = A.rows() == 1 ? A(0, 0) : A(0, 0) * A(1, 1) - A(0, 1) * A(1, 0);
  if (determinant == 0.0) return false;
  inverse.resize(A.rows(), A.cols());
  if (A.rows() == 1)
    inverse(0, 0) = 1.0;
  else
    inverse << A(1, 1), -A(0, 1), -A(1, 0), A(0, 0);
  inverse /= determinant;
  return inverse.allFinite();
}

}  // namespace

bool LemkeRestarts::solve(const LcpProblem& problem, LcpResult& result) {
  if (problem.size() == 0) return false;
  units_.assign(problem);
  twins_.assign(units_.problem());
  scaled_.A = twins_.A();
  scaled_.b = twins_.b();
  const int n = twins_.size();
  int left = std::min(kMostAttempts, static_cast<int>(kMostWork / (2.0 * n * n * n)));
  for (LemkeSolver& solver : solvers_)
    if (attempt({}, solver, problem, result)) return true;
  for (int i = 0; i < n && left > 0; ++i, --left)
    if (attempt(std::array{i}, solvers_[0], problem, result)) return true;
  for (int i = 0; i < n; ++i)
    for (int j = i + 1; j < n && left > 0; ++j, --left)
      if (attempt(std::array{i, j}, solvers_[0], problem, result)) return true;
  return false;
}

LemkeRestarts::LemkeRestarts()
    : solvers_{LemkeSolver(), LemkeSolver({.slack = tolerance::lost_in_A}),
               LemkeSolver({.slack = tolerance::lost_digits})} {}

bool LemkeRestarts::exchange(std::span<const int> exchanged) {
  const LcpProblem& problem = scaled_;
  transformed_.A = problem.A;
  transformed_.b = problem.b;
  if (exchanged.empty()) return true;
  const auto count = static_cast<Eigen::Index>(exchanged.size());
  MatX rows(count, problem.size());
  MatX columns(problem.size(), count);
  MatX own(count, count);
  VecX b(count);
  for (Eigen::Index k = 0; k < count; ++k) {
    const int i = exchanged[static_cast<std::size_t>(k)];
    rows.row(k) = problem.A.row(i);
    columns.col(k) = problem.A.col(i);
    b[k] = problem.b[i];
    for (Eigen::Index m = 0; m < count; ++m)
      own(k, m) = problem.A(i, exchanged[static_cast<std::size_t>(m)]);
  }
  MatX inverse;
  if (!invert(own, inverse)) return false;
  // Lazy products: Eigen's other ones sum in an order that depends on the cache.
  const MatX to_rows = columns.lazyProduct(inverse);
  transformed_.A = problem.A - to_rows.lazyProduct(rows);
  transformed_.b = problem.b - to_rows.lazyProduct(b);
  const MatX own_rows = (-inverse).lazyProduct(rows);
  const VecX own_b = (-inverse).lazyProduct(b);
  for (Eigen::Index k = 0; k < count; ++k) {
    const int i = exchanged[static_cast<std::size_t>(k)];
    transformed_.A.row(i) = own_rows.row(k);
    transformed_.b[i] = own_b[k];
  }
  for (Eigen::Index k = 0; k < count; ++k) {
    const int i = exchanged[static_cast<std::size_t>(k)];
    transformed_.A.col(i) = to_rows.col(k);
    for (Eigen::Index m = 0; m < count; ++m)
      transformed_.A(exchanged[static_cast<std::size_t>(m)], i) = inverse(m, k);
  }
  return transformed_.A.allFinite() && transformed_.b.allFinite();
}

bool LemkeRestarts::attempt(std::span<const int> exchanged, LemkeSolver& solver,
                            const LcpProblem& problem, LcpResult& result) {
  if (!exchange(exchanged)) return false;
  solver.solve(transformed_, answer_);
  if (answer_.status != LcpStatus::solved) return false;
  for (const int i : exchanged) answer_.f[idx(i)] = answer_.a[idx(i)];
  for (double& f : answer_.f) f = std::max(f, 0.0);
  std::vector<double> f;
  twins_.forces(answer_.f, f);
  units_.forces(f, answer_.f);
  conclude(problem, answer_);
  if (answer_.status != LcpStatus::solved) return false;
  std::swap(result, answer_);
  return true;
}

}  // namespace tumble
