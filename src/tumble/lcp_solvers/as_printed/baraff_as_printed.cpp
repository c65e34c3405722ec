/// \file
/// \brief Baraff's pivoting the way the thesis describes its own program (thesis 3.3.1).
#include "tumble/lcp_solvers/as_printed/baraff_as_printed.hpp"

#include "tumble/base/error.hpp"
#include "tumble/base/index.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tumble {

/// How far the force at d may grow, and at which contact that ends; -1: at none.
struct BaraffAsPrintedSolver::Step {
  double length = std::numeric_limits<double>::infinity();  ///< [N] of that force
  int contact = -1;                                         ///< that ends it
};

BaraffAsPrintedSolver::BaraffAsPrintedSolver(const BaraffAsPrintedOptions& options)
    : options_(options) {
  require::not_negative(options.eps, "eps");
  require::that(options.pivots_per_row >= 1, "pivots_per_row: give at least 1");
}

void BaraffAsPrintedSolver::solve(const LcpProblem& problem, LcpResult& result,
                                  std::span<const int> start) {
  require_valid(problem, LcpMatrix::symmetric_semidefinite);
  require_valid_start(problem.size(), start);
  for (int i = 0; i < problem.size(); ++i)
    require::that(!is_equality(problem, i), "equality: this solver has none, give contacts only");
  const int n = problem.size();
  result.status = LcpStatus::solved;
  result.pivots = 0;
  result.multiplications = 0;
  if (system_.rows() < n) system_.resize(n, n + 1);
  C_.reserve(idx(n));
  df_.resize(idx(n));
  da_.resize(idx(n));

  // [S3.3.1:compute_forces]
  // f = 0, a = b; both sets are empty.
  result.f.assign(idx(n), 0.0);
  result.a.assign(problem.b.data(), problem.b.data() + n);
  set_.assign(idx(n), Set::none);

  // While there is a contact d that sinks, a_d < -eps,
  // drive it to zero. (The paper: a_d < 0.)
  while (result.status == LcpStatus::solved) {
    int d = 0;
    while (d < n && !(result.a[idx(d)] < -options_.eps)) ++d;
    if (d == n) break;
    result.status = drive_to_zero(problem.A, d, result);
  }

  // After the loop, negative forces are set to zero.
  // (The paper: nothing.)
  if (options_.clamp && result.status == LcpStatus::solved)
    for (double& f : result.f) f = std::max(f, 0.0);
  // [S3.3.1:compute_forces]
  complete(problem, result);
}

// [S3.3.1:drive_to_zero]
// Lets the force at d grow until a_d = 0.
LcpStatus BaraffAsPrintedSolver::drive_to_zero(const MatX& A, int d, LcpResult& result) {
  const int n = static_cast<int>(set_.size());

  // Rounding can make a contact sink that is in one of the sets. The description does not say what
  // then; here it is taken out first, or it would end its own step for ever.
  set_[idx(d)] = Set::none;

  while (result.pivots < options_.pivots_per_row * (n + 1)) {
    // df: what the other forces have to do while the one at d grows by 1; da = A df.
    if (!fdirection(A, d, result)) return LcpStatus::singular;
    multiply(A, df_, da_);
    result.multiplications += std::int64_t{n} * n;

    // The longest step that breaks no condition, and the contact j that ends it.
    const Step step = maxstep(d, result);
    const int j = step.contact;
    if (j < 0) return LcpStatus::infeasible;

    // f and a go there.
    for (int i = 0; i < n; ++i) {
      result.f[idx(i)] += step.length * df_[idx(i)];
      result.a[idx(i)] += step.length * da_[idx(i)];
    }
    result.multiplications += 2 * std::int64_t{n};
    ++result.pivots;

    // j changes sets, and d goes on; if it is d, it has stopped sinking and belongs to C.
    set_[idx(j)] = set_[idx(j)] == Set::C ? Set::NC : Set::C;
    if (observer_ != nullptr) observer_->on_step({d, j, step.length, set_, result.f, result.a});
    if (j == d) return LcpStatus::solved;
  }
  return LcpStatus::cap_reached;
}
// [S3.3.1:drive_to_zero]

// [S3.3.1:fdirection]
// A force of 1 at d, and those of C that keep the accelerations of C: A_CC df_C = -A_Cd.
bool BaraffAsPrintedSolver::fdirection(const MatX& A, int d, LcpResult& result) {
  C_.clear();
  for (int i = 0; i < static_cast<int>(set_.size()); ++i)
    if (set_[idx(i)] == Set::C) C_.push_back(i);
  const int size = static_cast<int>(C_.size());
  for (int column = 0; column < size; ++column)
    for (int row = 0; row < size; ++row) system_(row, column) = A(C_[idx(row)], C_[idx(column)]);
  for (int row = 0; row < size; ++row) system_(row, size) = -A(C_[idx(row)], d);
  if (!eliminate(result)) return false;

  std::fill(df_.begin(), df_.end(), 0.0);
  df_[idx(d)] = 1.0;
  for (int row = 0; row < size; ++row) df_[idx(C_[idx(row)])] = system_(row, size);
  return true;
}
// [S3.3.1:fdirection]

// [S3.3.1:maxstep]
// The first of these to happen: d stops sinking, a force of C is used up, a contact of NC would
// begin to sink.
BaraffAsPrintedSolver::Step BaraffAsPrintedSolver::maxstep(int d, const LcpResult& result) const {
  Step step;
  if (da_[idx(d)] > 0.0) step = {-result.a[idx(d)] / da_[idx(d)], d};
  for (int i = 0; i < static_cast<int>(set_.size()); ++i) {
    double length = step.length;
    if (set_[idx(i)] == Set::C && df_[idx(i)] < 0.0) length = -result.f[idx(i)] / df_[idx(i)];
    if (set_[idx(i)] == Set::NC && da_[idx(i)] < 0.0) length = -result.a[idx(i)] / da_[idx(i)];
    if (length < step.length) step = {length, i};
  }
  return step;
}
// [S3.3.1:maxstep]

// Gaussian elimination with the largest entry of each column as pivot. The solution takes the place
// of the right-hand side. Returns false if a column has none.
bool BaraffAsPrintedSolver::eliminate(LcpResult& result) {
  const int size = static_cast<int>(C_.size());
  for (int k = 0; k < size; ++k) {
    int pivot = k;
    for (int row = k + 1; row < size; ++row)
      if (std::abs(system_(row, k)) > std::abs(system_(pivot, k))) pivot = row;
    if (system_(pivot, k) == 0.0) return false;
    for (int column = k; column <= size; ++column)
      std::swap(system_(k, column), system_(pivot, column));
    // Column by column, as they are stored.
    for (int row = k + 1; row < size; ++row) system_(row, k) /= system_(k, k);
    for (int column = k + 1; column <= size; ++column) {
      const double head = system_(k, column);
      for (int row = k + 1; row < size; ++row) system_(row, column) -= system_(row, k) * head;
    }
    result.multiplications += std::int64_t{size - k - 1} * (size - k + 1);
  }
  for (int k = size - 1; k >= 0; --k) {
    system_(k, size) /= system_(k, k);
    for (int row = 0; row < k; ++row) system_(row, size) -= system_(row, k) * system_(k, size);
    result.multiplications += k + 1;
  }
  return true;
}

}  // namespace tumble
